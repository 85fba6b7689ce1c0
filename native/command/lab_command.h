/// What the laboratories' commands share: where GL comes from, where results go, the clock, what is left to do.
#pragma once

#include "lab/progress.h"
#include "lab/results/results.h"
#include "native/command/command_line.h"
#include "native/context/context.h"

#include <string>
#include <vector>

namespace gnomon {

struct LabOptions {
    std::string context = "osmesa", json, html;

    bool writes() const { return !json.empty() || !html.empty(); }
};
void addLabOptions(CLI::App& command, LabOptions&);
/// A problem for each file that cannot be written, before anything is measured.
void checkLabOptions(const LabOptions&, Problems&);
/// Just --json and --html.
void addFileOptions(CLI::App& command, LabOptions&);
void checkFileOptions(const LabOptions&, Problems&);
/// A problem where results would replace a scene: to be asked once all are read.
bool sparesInputs(const LabOptions&, Problems&);

/// A word as a shell takes it for itself: in quotes where it has anything but letters, digits and what means nothing.
std::string inShell(const std::string& word);

/// ` --NAME=A,B,…` for a command that makes the same numbers again; empty where there are no values.
std::string listOption(const std::string& name, const std::vector<std::string>& values);

/// Mesa and others keep compiled shaders on disk: what compiling takes would depend on what was run before. To be
/// called before there is a context.
void compileFromNothing();

/// The environment, before the first number.
void printEnvironment(const Environment&);
/// Title and rows; nothing of a table without rows.
void printTable(const Table&);
/// Writes the files asked for; a problem for each that cannot be written.
void writeResults(const LabOptions&, const Results&, Problems&);

/// The exit code where no problem was found.
int doneOrInterrupted();

void addIntersectLab(CLI::App& lab, Task& task);
void addTraceLab(CLI::App& lab, Task& task);
void addShadowLab(CLI::App& lab, Task& task);

} // namespace gnomon
