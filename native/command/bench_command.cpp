/// gnomon bench: frames a second over depth, shadows, size and whatever else is to be compared.
#include "lab/bench/bench_pictures.h"
#include "lab/bench/bench_tables.h"
#include "native/command/commands.h"
#include "native/command/lab_command.h"
#include "native/context/environment.h"
#include "native/report/report.h"
#include "tracer/clock.h"
#include "tracer/printable.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

namespace gnomon {

namespace {

constexpr int kMostRepeats = 10000, kMostSeconds = 86400;

struct BenchOptions {
    LabOptions files;
    std::vector<std::string> scenes{"lite", "pro"}, contexts{"osmesa"};
    std::vector<std::pair<std::string, std::string>> values;
    std::string baseline;
    std::optional<int> repeats, limit;

    int rounds() const { return repeats.value_or(15); }
    /// Who says how many rounds gets them.
    int seconds() const { return limit.value_or(repeats ? kMostSeconds : 150); }
};

/// The command that makes the same numbers again.
std::string commandOf(const BenchOptions& options, const BenchPlan& plan) {
    std::string command = "gnomon bench";
    for (const std::string& scene : plan.scenes) command += " " + inShell(scene);
    command += listOption("context", options.contexts) + optionsOf(plan, options.values);
    if (!options.baseline.empty()) command += " --baseline=" + options.baseline;
    command += " --repeats=" + std::to_string(options.rounds());
    return options.seconds() == kMostSeconds ? command : command + " --limit=" + std::to_string(options.seconds());
}

void checkRange(const char* name, const std::optional<int>& value, int most, Problems& problems) {
    if (value && (*value < 1 || *value > most))
        problems.push_back(
            wrongOption(name, std::to_string(*value) + " is out of range", "use 1…" + std::to_string(most)));
}

void checkOptions(const BenchOptions& options, Problems& problems) {
    for (const std::string& context : options.contexts)
        if (!contextNamed(context)) {
            const auto meant = closest(context, contextNames());
            problems.push_back(
                wrongOption("context", "'" + context + "' is none of osmesa|egl|window",
                            meant.empty() ? std::string() : "did you mean '" + std::string(meant) + "'?"));
        }
    checkRange("repeats", options.repeats, kMostRepeats, problems);
    checkRange("limit", options.limit, kMostSeconds, problems);
    checkFileOptions(options.files, problems);
}

/// A context, or what to do where there is none of that kind.
std::unique_ptr<Context> makeBenchContext(const std::string& name, Problems& problems) {
    auto context = makeContext(*contextNamed(name), problems);
    if (!context && name == "window")
        problems.back().remedy = "leave window out of --context, or start this where there is a display";
    return context;
}

std::vector<BenchScene> loadScenes(const BenchPlan& plan, Problems& problems) {
    std::vector<BenchScene> scenes;
    for (const std::string& name : plan.scenes)
        if (auto loaded = load(name, problems)) scenes.push_back({std::move(loaded->scene), std::move(loaded->images)});
    return scenes;
}

/// Of each scene with all that is asked of it: the first thing that does not fit.
void checkEntries(const BenchPlan& plan, const std::vector<BenchScene>& scenes, Problems& problems) {
    for (const BenchEntry& entry : plan.entries)
        if (!poseOf(scenes[entry.scene].scene, entry.settings, problems)) return;
}

/// All that is left of the time goes to this context, but for an equal share of those to come.
double deadlineOf(double deadline, std::size_t contextsLeft) {
    const double now = monotonicSeconds();
    return now + std::max(0.0, deadline - now) / double(contextsLeft);
}

/// Steps until all is done, or the user wants no more.
template<class Step>
void stepThrough(LabProgress& progress, Step next) {
    for (BenchStep step{}; !LabProgress::interrupted() && (step = next()) != BenchStep::Finished;) {
        if (step == BenchStep::Stepped)
            progress.step();
        else
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

ContextCosts measure(const BenchOptions& options, const BenchPlan& plan, const std::vector<BenchScene>& scenes,
                     const std::string& name, double deadline, BenchPictures& pictures, Problems& problems) {
    ContextCosts costs{name, {}, {}, 0};
    const auto context = makeBenchContext(name, problems);
    if (!context) return costs;
    costs.environment = environmentOf(*contextNamed(name));
    BenchRun lab(plan, scenes, {labClock(), processSeconds, 0, !softwareRasterised(), context->resolver()}, problems);
    if (!problems.empty()) return costs;
    {
        LabProgress progress(plan.entries.size(), name + ": compiled");
        stepThrough(progress, [&] { return lab.prepare(problems); });
    }
    if (const std::size_t drawn = lab.drawn(); drawn > 0 && !LabProgress::interrupted()) {
        LabProgress progress(drawn * std::size_t(options.rounds() + 1), name + ": drawn", deadline);
        lab.begin(options.rounds(), kBenchPasses, deadline);
        stepThrough(progress, [&] { return lab.measure(); });
    }
    if (options.files.writes()) pictures.draw(lab, problems);
    costs.costs = lab.costs();
    costs.rounds = lab.rounds();
    return costs;
}

std::string roundsText(const BenchOptions& options, const std::vector<ContextCosts>& all) {
    std::string text;
    for (const ContextCosts& costs : all)
        text += (text.empty() ? "" : ", ") + costs.context + " " + std::to_string(costs.rounds) + " of " +
                std::to_string(options.rounds());
    if (LabProgress::interrupted()) return text + "; interrupted";
    const bool fewer = std::any_of(all.begin(), all.end(), [&](const auto& c) { return c.rounds < options.rounds(); });
    return fewer ? text + "; ended by --limit=" + std::to_string(options.seconds()) : text;
}

void print(const BenchPlan& plan, const ContextCosts& costs) {
    std::printf("\n");
    for (const auto& [name, value] : costs.environment) std::printf("%-10s %s\n", name.c_str(), value.c_str());
    const Table table = benchTable(plan, {costs});
    if (!table.rows.empty()) std::printf("\n%s", toMarkdown(briefTable(table)).c_str());
    std::fflush(stdout);
}

int finish(const BenchOptions& options, const BenchPlan& plan, const std::vector<ContextCosts>& all,
           const BenchPictures& pictures, Problems& problems) {
    Results results = benchResults(plan, all, options.contexts, commandOf(options, plan));
    results.environment.emplace_back("rounds", roundsText(options, all));
    std::printf("\nTimes are medians, in brackets the quartiles of the rounds (%s).\n",
                results.environment.back().second.c_str());
    if (LabProgress::interrupted()) std::printf("Interrupted: what was measured is kept.\n");
    pictures.addTo(results);
    const bool complete = problems.empty();
    writeResults(options.files, results, problems);
    for (const std::string& file : {options.files.json, options.files.html})
        if (!file.empty() && problems.empty()) std::printf("%s written\n", printable(file).c_str());
    if (!problems.empty()) return fail(complete ? kInputWrong : kNoGl, problems);
    return doneOrInterrupted();
}

int bench(const BenchOptions& options) {
    const double deadline = monotonicSeconds() + options.seconds();
    Problems problems;
    checkOptions(options, problems);
    const BenchPlan plan = planBench(options.scenes, options.values, options.baseline, problems);
    if (!problems.empty()) return fail(kCommandLineWrong, problems);
    const std::vector<BenchScene> scenes = loadScenes(plan, problems);
    if (!problems.empty()) return fail(kInputWrong, problems);
    checkEntries(plan, scenes, problems);
    sparesInputs(options.files, problems);
    if (!problems.empty()) return fail(kCommandLineWrong, problems);
    compileFromNothing();
    for (const std::string& name : options.contexts) makeBenchContext(name, problems);
    if (!problems.empty()) return fail(kNoGl, problems);

    BenchPictures pictures(plan, options.contexts.size());
    std::vector<ContextCosts> all;
    for (std::size_t i = 0; i < options.contexts.size() && !LabProgress::interrupted(); ++i) {
        all.push_back(measure(options, plan, scenes, options.contexts[i],
                              deadlineOf(deadline, options.contexts.size() - i), pictures, problems));
        print(plan, all.back());
    }
    return finish(options, plan, all, pictures, problems);
}

std::string helpOf(const SettingRow& row) {
    std::string help(row.help);
    if (row.key == "size") return help + " [800x600]";
    if (row.key == "depth") return help + " [1,4,8]";
    return row.key == "shadows" ? help + "; all: every model [off," + textOf(row, {}) + "]" : help;
}

/// --depth=1,4,8, also as --depths.
void addList(CLI::App& command, BenchOptions& options, const SettingRow& row) {
    const std::string key(row.key);
    const bool plural = key == "depth" || key == "size";
    command
        .add_option_function<std::string>(
            optionNames(row) + (plural ? ",--" + key + "s" : ""),
            [&options, key](const std::string& text) { options.values.emplace_back(key, text); }, helpOf(row))
        ->type_name(takesList(row) ? "VALUE,…" : "X,Y,Z")
        ->group(std::string(row.group))
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

} // namespace

void addBench(CLI::App& app, Task& task) {
    auto options = std::make_shared<BenchOptions>();
    auto* command = app.add_subcommand("bench", "Frames a second over depth, shadows, size and any other setting");
    command->add_option("SCENE", options->scenes, "Scenes' names or files [lite pro]")->type_name("");
    command->add_option("--context,--contexts", options->contexts, "Where GL comes from: osmesa, egl, window [osmesa]")
        ->type_name("CONTEXT,…")
        ->delimiter(',');
    command->add_option("--repeats", options->repeats, "Rounds, in each of which every row draws in turn [15]")
        ->type_name("N");
    command->add_option("--limit", options->limit, "Begin no round after so many seconds [150; none with --repeats]")
        ->type_name("SECONDS");
    command->add_option("--baseline", options->baseline, "What each row is divided by [the first row of its scene]")
        ->type_name("KEY=VALUE,…");
    addFileOptions(*command, options->files);
    for (const SettingRow& row : settingsTable())
        if (isBenchSetting(row)) addList(*command, *options, row);
    command->footer(
        "Every setting takes a list, and every combination is a row: `gnomon bench pro --depth=1,8 --accel=all`.\n"
        "--baseline=shadows=off divides each row by the one like it without shadows.\n"
        "Ctrl-C ends it and keeps what was measured.");
    command->callback([&task, options] { task = [options] { return bench(*options); }; });
}

} // namespace gnomon
