/// gnomon lab shadows: what shadow models cost and how wrong they are.
#include "lab/results/result_pictures.h"
#include "lab/shadows/shadow_lab.h"
#include "lab/shadows/shadow_pictures.h"
#include "lab/shadows/shadow_tables.h"
#include "native/command/lab_command.h"
#include "native/context/environment.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace gnomon {

namespace {

constexpr std::array kEarlierOrigins{Renamed{"a", "surface"}, Renamed{"ab", "both"}};

struct ShadowOptions {
    LabOptions lab;
    std::vector<std::string> scenes{"simple", "complex", "mandelbulb"}, models;
    ShadowPlan plan;
    std::string size = "160x120", coneOrigins = "both", pictures;
};

std::vector<std::string> allModels() {
    std::vector<std::string> names;
    for (const ShadowRow& row : kShadowModels)
        if (row.model != ShadowModel::Off) names.emplace_back(row.key);
    return names;
}

void readModels(ShadowOptions& options, Problems& problems) {
    for (const std::string& name : options.models) {
        const auto found = std::find_if(kShadowModels.begin(), kShadowModels.end(),
                                        [&](const ShadowRow& row) { return row.key == name; });
        if (found == kShadowModels.end() || found->model == ShadowModel::Off) {
            std::vector<std::string_view> known;
            for (const ShadowRow& row : kShadowModels) known.push_back(row.key);
            const auto meant = closest(name, known);
            problems.push_back(
                wrongOption("models", "'" + name + "' is no shadow model",
                            meant.empty() ? "use those of --shadows" : "did you mean '" + std::string(meant) + "'?"));
            continue;
        }
        options.plan.models.push_back(found->model);
    }
}

void checkRange(const char* option, double value, double least, double most, Problems& problems) {
    if (!(value >= least && value <= most))
        problems.push_back(wrongOption(option, toString(value) + " is out of range",
                                       "use " + toString(least) + " … " + toString(most)));
}

void checkOptions(ShadowOptions& options, Problems& problems) {
    checkLabOptions(options.lab, problems);
    readModels(options, problems);
    Settings settings;
    if (setFromText(settings, "size", options.size, "command line", problems)) options.plan.size = settings.size;
    checkRange("repeats", options.plan.rounds, 1, 1000, problems);
    checkRange("reference", options.plan.reference, 16, 65536, problems);
    for (const double radius : options.plan.radii) checkRange("radii", radius, 0, 1e4, problems);
    for (const double epsilon : options.plan.epsilons) checkRange("epsilons", epsilon, 1.0 / 4096, 0.5, problems);
    for (const int samples : options.plan.samples) checkRange("samples", samples, 1, 65536, problems);
    if (options.coneOrigins != "surface" && options.coneOrigins != "both")
        problems.push_back(
            wrongOption("cone-origins", "'" + options.coneOrigins + "' is not known", "use surface or both"));
    options.plan.bothOrigins = options.coneOrigins == "both";
}

template<class Number>
std::vector<std::string> texts(const std::vector<Number>& numbers) {
    std::vector<std::string> all;
    for (const Number number : numbers) all.push_back(toString(double(number)));
    return all;
}

/// The command that makes the same numbers again.
std::string commandOf(const ShadowOptions& options) {
    return "gnomon lab shadows" + listOption("scenes", options.scenes) + listOption("models", options.models) +
           listOption("radii", texts(options.plan.radii)) + listOption("epsilons", texts(options.plan.epsilons)) +
           listOption("samples", texts(options.plan.samples)) + " --cone-origins=" + options.coneOrigins +
           " --size=" + options.size + " --reference=" + std::to_string(options.plan.reference) +
           " --repeats=" + std::to_string(options.plan.rounds) + " --context=" + options.lab.context;
}

int labShadows(ShadowOptions options) {
    Problems problems;
    checkOptions(options, problems);
    if (!problems.empty()) return fail(kCommandLineWrong, problems);
    std::vector<Loaded> scenes;
    for (const std::string& name : options.scenes)
        if (auto loaded = load(name, problems)) scenes.push_back(std::move(*loaded));
    if (!problems.empty()) return fail(kInputWrong, problems);
    if (!sparesInputs(options.lab, problems)) return fail(kCommandLineWrong, problems);
    const ContextKind kind = *contextNamed(options.lab.context);
    const auto context = makeContext(kind, problems);
    if (!context) return fail(kNoGl, problems);
    Results results{"Shadows: speed against error", commandOf(options), environmentOf(kind), {}, {}};
    results.environment.emplace_back("time", labClockName());
    results.environment.emplace_back("reference",
                                     "Monte Carlo, " + std::to_string(options.plan.reference) + " samples");
    printEnvironment(results.environment);
    if (options.lab.writes())
        options.plan.pictures = pictureSize(options.plan.size, scenes.size() * picturesOf(options.plan));
    LabProgress progress(scenes.size() * stepsOf(options.plan));
    std::vector<ShadowCosts> measured;
    for (const Loaded& scene : scenes) {
        if (LabProgress::interrupted()) break;
        const auto costs = measureShadows(scene, options.plan, labClock(), progress, problems);
        if (!problems.empty()) return fail(kInputWrong, problems);
        printTable(shadowTable(costs));
        if (!options.pictures.empty() && !writePictures(options.pictures, scene, options.plan, problems))
            return fail(kInputWrong, problems);
        measured.insert(measured.end(), costs.begin(), costs.end());
    }
    results.tables = {shadowTable(measured), variantTable(measured), rivalTable(measured)};
    results.charts = shadowCharts(measured);
    addShadowPictures(measured, results.environment.back().second, results);
    printTable(results.tables[1]);
    printTable(results.tables[2]);
    if (LabProgress::interrupted()) std::printf("\ninterrupted: what is done is kept\n");
    writeResults(options.lab, results, problems);
    return problems.empty() ? doneOrInterrupted() : fail(kInputWrong, problems);
}

} // namespace

void addShadowLab(CLI::App& lab, Task& task) {
    auto options = std::make_shared<ShadowOptions>();
    options->models = allModels();
    auto* shadows = lab.add_subcommand("shadows", "What shadow models cost and how wrong they are");
    const auto list = [&](const char* name, auto& target, const char* help, const char* type) {
        shadows->add_option(name, target, help)->type_name(type)->delimiter(',');
    };
    list("--scenes", options->scenes, "Names or files [simple,complex,mandelbulb]", "SCENE,…");
    list("--models", options->models, "Shadow models, as --shadows names them [all]", "MODEL,…");
    list("--radii", options->plan.radii, "Light radii [the scene's own]", "R,…");
    list("--epsilons", options->plan.epsilons, "Of the cone marches [1/10,1/30,1/256]", "E,…");
    list("--samples", options->plan.samples, "Of the Monte Carlo models [1,4,16,64]", "N,…");
    shadows
        ->add_option("--cone-origins,--directions", options->coneOrigins,
                     "Ends that cones are marched from: the surface only, or the light as well [both]")
        ->type_name("surface|both")
        ->transform([](std::string origins) { return std::string(renamed(origins, kEarlierOrigins)); });
    shadows->add_option("--size", options->size, "Of the picture [160x120]")->type_name("WIDTHxHEIGHT");
    shadows->add_option("--reference", options->plan.reference, "Samples of the reference [4096]")->type_name("N");
    shadows->add_option("--repeats", options->plan.rounds, "Rounds, in each of which every way draws a frame [5]")
        ->type_name("N");
    shadows
        ->add_option("--pictures", options->pictures,
                     "Folder for PNGs: each model, the reference, four times their difference")
        ->type_name("FOLDER");
    addLabOptions(*shadows, options->lab);
    shadows->callback([&task, options] { task = [options] { return labShadows(*options); }; });
}

} // namespace gnomon
