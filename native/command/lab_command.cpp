/// gnomon lab: measurements of the tracer's own methods, speed beside error and counters.
#include "native/command/lab_command.h"

#include "native/command/commands.h"
#include "native/file/output_file.h"
#include "native/report/report.h"
#include "tracer/printable.h"

#include <cstdio>
#include <cstdlib>

namespace gnomon {

void addLabOptions(CLI::App& command, LabOptions& options) {
    command.add_option("--context", options.context, "Where GL comes from [osmesa]")->type_name("osmesa|egl|window");
    addFileOptions(command, options);
}

void addFileOptions(CLI::App& command, LabOptions& options) {
    command.add_option("--json", options.json, "Write all values; - is standard output")->type_name("FILE");
    command.add_option("--html", options.html, "Write tables and charts, as one page; - is standard output")
        ->type_name("FILE");
}

void checkLabOptions(const LabOptions& options, Problems& problems) {
    if (!contextNamed(options.context))
        problems.push_back(wrongOption("context", "'" + options.context + "' is none of osmesa|egl|window", {}));
    checkFileOptions(options, problems);
}

void checkFileOptions(const LabOptions& options, Problems& problems) {
    for (const std::string& file : {options.json, options.html})
        if (!file.empty()) prepareOutput(file, problems);
}

bool sparesInputs(const LabOptions& options, Problems& problems) {
    return sparesInputs(options.json, problems) && sparesInputs(options.html, problems);
}

std::string inShell(const std::string& word) {
    const bool plain = word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:+-") ==
                       std::string::npos;
    if (plain && !word.empty()) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string listOption(const std::string& name, const std::vector<std::string>& values) {
    std::string text;
    for (const std::string& value : values) text += (text.empty() ? " --" + name + "=" : ",") + inShell(value);
    return text;
}

void compileFromNothing() {
    for (const char* name : {"MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE"}) setenv(name, "true", 1);
    setenv("__GL_SHADER_DISK_CACHE", "0", 1); // NVIDIA's
}

void printEnvironment(const Environment& environment) {
    for (const auto& [name, value] : environment) std::printf("%-10s %s\n", name.c_str(), value.c_str());
}

void printTable(const Table& table) {
    if (table.rows.empty()) return;
    std::printf("\n%s\n\n%s", printable(table.title).c_str(), toMarkdown(table).c_str());
    std::fflush(stdout);
}

void writeResults(const LabOptions& options, const Results& results, Problems& problems) {
    if (!options.json.empty()) writeOutput(options.json, toJson(results), problems);
    if (!options.html.empty()) writeOutput(options.html, toHtml({&results, 1}), problems);
}

int doneOrInterrupted() { return LabProgress::interrupted() ? kInterrupted : kDone; }

void addLab(CLI::App& app, Task& task) {
    auto* lab = app.add_subcommand("lab", "Measures the tracer's own methods: speed beside error and counters");
    lab->require_subcommand(1);
    addIntersectLab(*lab, task);
    addTraceLab(*lab, task);
    addShadowLab(*lab, task);
}

} // namespace gnomon
