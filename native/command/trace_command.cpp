/// gnomon lab trace: what finding objects costs, by accelerator and data path, beside the source's way of tracing.
#include "lab/results/result_pictures.h"
#include "lab/trace/trace_lab.h"
#include "lab/trace/trace_tables.h"
#include "native/command/lab_command.h"
#include "native/context/environment.h"

#include <algorithm>
#include <cstdio>

namespace gnomon {

namespace {

constexpr int kFewestSpheres = 8, kMostSpheres = 20000;
constexpr std::array<std::string_view, 3> kSettingKeys{"size", "depth", "shadows"};

struct TraceOptions {
    LabOptions lab;
    Drawing settings;
    std::vector<std::string> scenes{"lite", "pro", "shapes"};
    std::vector<int> spheres{10, 100, 1000, 10000};
    int repeats = 5;
};

Settings standardSettings() {
    Settings settings;
    settings.size = {400, 300};
    settings.depth = 8;
    return settings;
}

/// The command that makes the same numbers again.
std::string commandOf(const TraceOptions& options, const Settings& settings) {
    std::vector<std::string> spheres;
    for (const int count : options.spheres) spheres.push_back(std::to_string(count));
    std::string command = "gnomon lab trace" + listOption("scenes", options.scenes) + listOption("spheres", spheres);
    for (const std::string_view key : kSettingKeys)
        command += " --" + std::string(key) + "=" + textOf(*findSetting(key), settings);
    return command + " --repeats=" + std::to_string(options.repeats) + " --context=" + options.lab.context;
}

void checkOptions(const TraceOptions& options, Problems& problems) {
    checkLabOptions(options.lab, problems);
    if (options.repeats < 1 || options.repeats > 1000)
        problems.push_back(
            wrongOption("repeats", std::to_string(options.repeats) + " is out of range", "use 1 … 1000"));
    for (const int count : options.spheres)
        if (count < kFewestSpheres || count > kMostSpheres)
            problems.push_back(
                wrongOption("spheres", std::to_string(count) + " is out of range",
                            "use " + std::to_string(kFewestSpheres) + " … " + std::to_string(kMostSpheres)));
}

std::vector<Loaded> loadScenes(const std::vector<std::string>& names, Problems& problems) {
    std::vector<Loaded> scenes;
    for (const std::string& name : names)
        if (auto loaded = load(name, problems)) scenes.push_back(std::move(*loaded));
    return scenes;
}

/// What was measured so far.
struct TraceResults {
    std::vector<ViewCosts> views;
    std::vector<GrowthCosts> growth;
};

/// Their size, where files are written.
std::optional<glm::ivec2> picturesFor(const TraceOptions& options, const Settings& settings,
                                      const std::vector<Loaded>& scenes) {
    if (!options.lab.writes()) return std::nullopt;
    std::size_t count = 0;
    for (const Loaded& scene : scenes) count += TraceLab::picturesOf(scene.scene);
    for (const Arrangement arrangement : kArrangements) count += TraceLab::picturesOf(arrangement, options.spheres);
    return pictureSize(settings.size, count);
}

/// False, with problems, where GL cannot; less where the user wants no more.
bool measure(const TraceOptions& options, const Settings& settings, const std::vector<Loaded>& scenes,
             TraceResults& results, Problems& problems) {
    const TraceLab lab(settings, options.repeats, labClock(), picturesFor(options, settings, scenes));
    std::size_t steps = 0;
    for (const Loaded& scene : scenes) steps += lab.stepsOf(scene.scene);
    for (const Arrangement arrangement : kArrangements) steps += lab.stepsOf(arrangement, options.spheres);
    LabProgress progress(steps);
    for (const Loaded& scene : scenes) {
        if (LabProgress::interrupted()) break;
        const std::vector<ViewCosts> views = lab.measure(scene, progress, problems);
        if (!problems.empty()) return false;
        printTable(viewTable(views));
        results.views.insert(results.views.end(), views.begin(), views.end());
    }
    for (const Arrangement arrangement : kArrangements) {
        if (LabProgress::interrupted()) break;
        const std::vector<GrowthCosts> growth = lab.measure(arrangement, options.spheres, progress, problems);
        if (!problems.empty()) return false;
        printTable(growthTable(growth));
        results.growth.insert(results.growth.end(), growth.begin(), growth.end());
    }
    return true;
}

void printSummary(const TraceResults& results) {
    const Table choice = choiceTable(results.views, results.growth);
    printTable(choice);
    const auto right = std::count_if(choice.rows.begin(), choice.rows.end(),
                                     [](const auto& row) { return row.back() == Cell(std::string("yes")); });
    std::printf("\n%s%d of %zu choices right%s\n", growthSummary(results.growth).c_str(), int(right),
                choice.rows.size(), LabProgress::interrupted() ? "; interrupted: what is done is kept" : "");
}

int labTrace(const TraceOptions& options) {
    Problems problems;
    const auto settings = readSettings(options.settings, problems, standardSettings());
    checkOptions(options, problems);
    if (!problems.empty()) return fail(kCommandLineWrong, problems);
    const std::vector<Loaded> scenes = loadScenes(options.scenes, problems);
    if (!problems.empty()) return fail(kInputWrong, problems);
    if (!sparesInputs(options.lab, problems)) return fail(kCommandLineWrong, problems);
    compileFromNothing();
    const ContextKind kind = *contextNamed(options.lab.context);
    const auto context = makeContext(kind, problems);
    if (!context) return fail(kNoGl, problems);
    Results results{"Tracing: what finding objects costs", commandOf(options, *settings), environmentOf(kind), {}, {}};
    results.environment.emplace_back("time", labClockName());
    results.environment.emplace_back("spheres", sphereScenesText());
    printEnvironment(results.environment);
    TraceResults measured;
    if (!measure(options, *settings, scenes, measured, problems)) return fail(kNoGl, problems);
    printSummary(measured);
    results.tables = {viewTable(measured.views), growthTable(measured.growth),
                      choiceTable(measured.views, measured.growth)};
    results.charts = traceCharts();
    addTracePictures(measured.views, measured.growth, results);
    writeResults(options.lab, results, problems);
    return problems.empty() ? doneOrInterrupted() : fail(kInputWrong, problems);
}

} // namespace

void addTraceLab(CLI::App& lab, Task& task) {
    auto options = std::make_shared<TraceOptions>();
    auto* trace = lab.add_subcommand(
        "trace", "What finding objects costs, by accelerator and data path, beside the source's way");
    trace->add_option("--scenes", options->scenes, "Names or files [lite,pro,shapes]")
        ->type_name("SCENE,…")
        ->delimiter(',');
    trace->add_option("--spheres", options->spheres, "Numbers of spheres [10,100,1000,10000]")
        ->type_name("N,…")
        ->delimiter(',');
    trace->add_option("--repeats", options->repeats, "Rounds, in each of which every way draws a frame [5]")
        ->type_name("N");
    for (const std::string_view key : kSettingKeys)
        addSetting(*trace, options->settings, *findSetting(key), standardSettings());
    addLabOptions(*trace, options->lab);
    trace->callback([&task, options] {
        std::sort(options->spheres.begin(), options->spheres.end());
        task = [options] { return labTrace(*options); };
    });
}

} // namespace gnomon
