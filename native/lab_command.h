/// What the laboratories' commands share: where GL comes from, where results go, the clock, what is left to do.
#pragma once

#include "native/command_line.h"
#include "native/context.h"
#include "tracer/lab/results.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace gnomon {

struct LabOptions {
    std::string context = "osmesa", json, html;

    bool writes() const { return !json.empty() || !html.empty(); }
};
void addLabOptions(CLI::App& command, LabOptions&);
void checkLabOptions(const LabOptions&, Problems&);
/// Just --json and --html; a problem for each that cannot be written, before anything is measured.
void addFileOptions(CLI::App& command, LabOptions&);
void checkFileOptions(const LabOptions&, Problems&);

/// ` --NAME=A,B,…` for a command that makes the same numbers again; empty where there are no values.
std::string listOption(const std::string& name, const std::vector<std::string>& values);

/// The current context draws with the processor.
bool drawnByProcessor();
/// Seconds as they are counted for the current context: of the process where the processor draws, else on the wall.
double (*labClock())();
/// What labClock() counts, in words.
std::string labClockName();

/// Mesa and others keep compiled shaders on disk: what compiling takes would depend on what was run before. To be
/// called before there is a context.
void compileFromNothing();

/// Says what is left to do, on a terminal in one line, else a line every ten seconds; hears Ctrl-C, of which the second
/// one ends the program.
class LabProgress {
  public:
    /// `done` stands before the counts. No time left is told beyond `deadline` on the monotonic clock.
    explicit LabProgress(std::size_t all, std::string done = "done", double deadline = 1e300);
    ~LabProgress();
    LabProgress(const LabProgress&) = delete;
    LabProgress& operator=(const LabProgress&) = delete;

    /// One more is done. False once the user wants no more: what is done is to be kept.
    bool step();
    static bool interrupted();

  private:
    std::size_t done_ = 0, all_;
    std::string what_;
    double started_, told_, deadline_;
};

/// The environment, before the first number.
void printEnvironment(const Environment&);
/// Writes the files asked for; a problem for each that cannot be written.
void writeResults(const LabOptions&, const Results&, Problems&);

void addIntersectLab(CLI::App& lab, Task& task);
void addTraceLab(CLI::App& lab, Task& task);
void addShadowLab(CLI::App& lab, Task& task);

} // namespace gnomon
