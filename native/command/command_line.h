/// What the commands share: the settings table as options, and what is wrong with a command line.
#pragma once

#include "native/exit.h"
#include "native/file/asset_folder.h"
#include "tracer/problem.h"
#include "tracer/scene/scene.h"
#include "tracer/settings/settings.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gnomon {

/// Work a command line asks for; answers the exit code.
using Task = std::function<int()>;

/// A problem of the command line; `option` may be empty.
Problem wrongOption(const std::string& option, const std::string& what, const std::string& remedy);

/// `SCENE` and `--KEY=VALUE` for every row of the settings table, as they were typed.
struct Drawing {
    std::string scene = "lite";
    std::vector<std::pair<std::string, std::string>> values;
};
void addScene(CLI::App& command, std::string& scene, bool required);
void addSettings(CLI::App& command, Drawing&);
/// One of them; `standard` are the values where it is not given.
void addSetting(CLI::App& command, Drawing&, const SettingRow&, const Settings& standard = {});

/// As CLI11 takes them: `--cone-origin,--direction`, the row's key and its aliases.
std::string optionNames(const SettingRow&);

/// The settings of the command line over the standard ones. Every wrong one is a problem.
std::optional<Settings> readSettings(const Drawing&, Problems&, Settings standard = {});

/// The pose a picture is taken from, and whether settings and scene fit together.
std::optional<CameraPose> poseOf(const Scene&, const Settings&, Problems&);

/// As it is typed after the program's name, `lab intersect`; empty for the program itself.
std::string pathOf(const CLI::App& command);

/// What CLI11 did not know, each with the closest option the command has.
Problems unknownWords(const CLI::App& command);

} // namespace gnomon
