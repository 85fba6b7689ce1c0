/// gnomon report: results of several runs as one page, or two runs held against each other.
#include "lab/results/compare.h"
#include "lab/results/read_results.h"
#include "native/command/commands.h"
#include "native/command/lab_command.h"
#include "native/file/input_file.h"
#include "native/file/output_file.h"
#include "native/report/report.h"
#include "tracer/printable.h"
#include "tracer/scene/json_document.h"

#include <cstdio>
#include <memory>

namespace gnomon {

namespace {

struct ReportOptions {
    std::vector<std::string> files;
    std::string against, page, json;
    double tolerance = 5; ///< percent
};

std::optional<Results> readFile(const std::string& file, Problems& problems) {
    const auto text = readInput(file, kMaxJsonBytes, "measure less at a time", problems);
    return text ? readResults(*text, inputName(file), problems) : std::nullopt;
}

std::vector<Results> readFiles(const std::vector<std::string>& files, Problems& problems) {
    std::vector<Results> all;
    for (const std::string& file : files)
        if (auto results = readFile(file, problems)) all.push_back(std::move(*results));
    return all;
}

void checkOptions(const ReportOptions& options, Problems& problems) {
    if (options.against.empty() && options.page.empty())
        problems.push_back(
            wrongOption("output", "there is nowhere to write to", "use -o report.html, or --against OLD.json"));
    if (!options.against.empty() && options.files.size() != 1)
        problems.push_back(wrongOption("against", std::to_string(options.files.size()) + " files are held against it",
                                       "give one: gnomon report --against OLD.json NEW.json"));
    if (options.against.empty() && !options.json.empty())
        problems.push_back(wrongOption("json", "only a comparison is written as JSON", "add --against OLD.json"));
    if (!(options.tolerance >= 0 && options.tolerance < 100))
        problems.push_back(
            wrongOption("tolerance", toString(options.tolerance) + " is out of range", "use 0…99 per cent"));
    for (const std::string& file : {options.page, options.json})
        if (!file.empty()) prepareOutput(file, problems);
}

int writePage(const ReportOptions& options, const std::vector<Results>& runs, Problems& problems) {
    if (options.page.empty()) return kDone;
    if (!writeOutput(options.page, toHtml(runs), problems)) return fail(kInputWrong, problems);
    std::printf("%s written\n", printable(options.page).c_str());
    return kDone;
}

/// The summary comes last, where a terminal's reader looks first.
void print(const Results& comparison) {
    for (const auto& [name, value] : comparison.environment)
        std::printf("%-10s %s\n", printable(name).c_str(), printable(value).c_str());
    for (std::size_t i = 1; i < comparison.tables.size(); ++i) printTable(comparison.tables[i]);
    printTable(comparison.tables.front());
}

/// The comparison comes first on the page, then both runs.
int compareFiles(const ReportOptions& options) {
    Problems problems;
    std::vector<Results> runs = readFiles({options.files.front(), options.against}, problems);
    if (!problems.empty()) return fail(kInputWrong, problems);
    Results comparison = compareRuns(runs[1], runs[0], options.tolerance / 100, problems);
    for (Problem& problem : problems) problem.file = options.files.front();
    if (!problems.empty()) return fail(kInputWrong, problems);
    comparison.command = "gnomon report --against " + inShell(options.against) + " " + inShell(options.files.front()) +
                         " --tolerance=" + toString(options.tolerance);
    comparison.environment.emplace_back("tolerance", "times and ratios " + toString(options.tolerance) +
                                                         " % beyond noise, errors " + toString(100 * kErrorTolerance) +
                                                         " %, counts none");
    comparison.environment.emplace_back("confidence", "95 % for all intervals of a column together");
    print(comparison);
    if (!options.json.empty() && !writeOutput(options.json, toJson(comparison), problems))
        return fail(kInputWrong, problems);
    runs.insert(runs.begin(), std::move(comparison));
    return writePage(options, runs, problems);
}

int report(const ReportOptions& options) {
    Problems problems;
    checkOptions(options, problems);
    if (!problems.empty()) return fail(kCommandLineWrong, problems);
    if (!options.against.empty()) return compareFiles(options);
    const std::vector<Results> runs = readFiles(options.files, problems);
    return problems.empty() ? writePage(options, runs, problems) : fail(kInputWrong, problems);
}

} // namespace

void addReport(CLI::App& app, Task& task) {
    auto options = std::make_shared<ReportOptions>();
    auto* command = app.add_subcommand("report", "Makes one page of results, or holds two runs against each other");
    command->add_option("FILES", options->files, "What `gnomon bench` and `gnomon lab` wrote with --json")
        ->type_name("")
        ->required();
    command->add_option("-o,--output", options->page, "The page: one file that loads nothing; - is standard output")
        ->type_name("FILE.html");
    command
        ->add_option("--against", options->against,
                     "Says of each row whether it became faster or slower, better or worse")
        ->type_name("OLD.json");
    command
        ->add_option("--tolerance", options->tolerance,
                     "Per cent that times of one program may differ by beyond noise [5]")
        ->type_name("PERCENT");
    command->add_option("--json", options->json, "Write the comparison")->type_name("FILE");
    command->callback([&task, options] { task = [options] { return report(*options); }; });
}

} // namespace gnomon
