/// gnomon lab: measurements of the tracer's own methods, speed beside error and counters.
#include "native/lab_command.h"

#include "native/commands.h"
#include "native/report.h"
#include "tracer/clock.h"
#include "tracer/gl/gl.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace gnomon {

namespace {

constexpr double kPlainSeconds = 10; // between lines, where there is no terminal

std::atomic<bool> stopped{false};
extern "C" void stop(int) {
    stopped = true;
    std::signal(SIGINT, SIG_DFL); // once more ends the program
}

} // namespace

void addLabOptions(CLI::App& command, LabOptions& options) {
    command.add_option("--context", options.context, "Where GL comes from [osmesa]")->type_name("osmesa|egl|window");
    addFileOptions(command, options);
}

void addFileOptions(CLI::App& command, LabOptions& options) {
    command.add_option("--json", options.json, "Write all numbers")->type_name("FILE");
    command.add_option("--html", options.html, "Write tables and charts, as one page")->type_name("FILE");
}

void checkLabOptions(const LabOptions& options, Problems& problems) {
    if (!contextNamed(options.context))
        problems.push_back(wrongOption("context", "'" + options.context + "' is none of osmesa|egl|window", {}));
}

void checkFileOptions(const LabOptions& options, Problems& problems) {
    for (const std::string& file : {options.json, options.html})
        if (!file.empty()) checkTextFile(file, problems);
}

std::string listOption(const std::string& name, const std::vector<std::string>& values) {
    std::string text;
    for (const std::string& value : values) text += (text.empty() ? " --" + name + "=" : ",") + value;
    return text;
}

bool drawnByProcessor() { return gl::drawnByProcessor(gl::info().renderer); }

double (*labClock())() { return drawnByProcessor() ? processSeconds : monotonicSeconds; }

std::string labClockName() { return drawnByProcessor() ? "CPU time of the process, all threads" : "wall clock"; }

void compileFromNothing() {
    for (const char* name : {"MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE"}) setenv(name, "true", 1);
    setenv("__GL_SHADER_DISK_CACHE", "0", 1); // NVIDIA's
}

LabProgress::LabProgress(std::size_t all, std::string done, double deadline)
    : all_(all), what_(std::move(done)), started_(monotonicSeconds()), told_(started_), deadline_(deadline) {
    if (!stopped) std::signal(SIGINT, stop);
}

LabProgress::~LabProgress() {
    if (isatty(STDERR_FILENO)) std::fputs("\r\x1b[K", stderr);
}

bool LabProgress::step() {
    ++done_;
    const bool terminal = isatty(STDERR_FILENO);
    const double now = monotonicSeconds();
    if (now - told_ < (terminal ? 0.1 : kPlainSeconds)) return !stopped;
    told_ = now;
    const double left = (now - started_) / double(done_) * double(all_ - std::min(done_, all_));
    std::fprintf(stderr, "%s%s %zu of %zu, %.0f s left%s", terminal ? "\r" : "gnomon: ", what_.c_str(), done_, all_,
                 std::max(0.0, std::min(left, deadline_ - now)), terminal ? "\x1b[K" : "\n");
    return !stopped;
}

bool LabProgress::interrupted() { return stopped; }

void printEnvironment(const Environment& environment) {
    for (const auto& [name, value] : environment) std::printf("%-10s %s\n", name.c_str(), value.c_str());
}

void writeResults(const LabOptions& options, const Results& results, Problems& problems) {
    if (!options.json.empty()) writeText(options.json, toJson(results), problems);
    if (!options.html.empty()) writeText(options.html, toHtml({&results, 1}), problems);
}

void addLab(CLI::App& app, Task& task) {
    auto* lab = app.add_subcommand("lab", "Measures the tracer's own methods: speed beside error and counters");
    lab->require_subcommand(1);
    addIntersectLab(*lab, task);
    addTraceLab(*lab, task);
    addShadowLab(*lab, task);
}

} // namespace gnomon
