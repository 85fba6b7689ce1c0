/// The commands of the program. Each adds itself with its options and, where it is chosen, sets `task`.
#pragma once

#include "native/command/command_line.h"

namespace gnomon {

void addView(CLI::App&, Task& task);
void addRender(CLI::App&, Task& task);
void addBench(CLI::App&, Task& task);
void addLab(CLI::App&, Task& task);
void addReport(CLI::App&, Task& task);
void addCheck(CLI::App&, Task& task);
void addShader(CLI::App&, Task& task);
void addScenes(CLI::App&, Task& task);
void addSettingsList(CLI::App&, Task& task);
void addInfo(CLI::App&, Task& task);

} // namespace gnomon
