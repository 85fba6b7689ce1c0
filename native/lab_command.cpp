/// gnomon lab: measurements of the tracer's own methods, speed beside error.
#include "native/commands.h"
#include "native/context.h"
#include "native/environment.h"
#include "native/report.h"
#include "native/textbook_picture.h"
#include "tests/naive/naive.h"
#include "tests/oracle/intersect_lab.h"
#include "tracer/clock.h"
#include "tracer/scene/shapes.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <unistd.h>

namespace gnomon {

namespace {

struct LabOptions {
    std::vector<std::string> shapes;
    std::vector<double> distances{3, 10, 100, 1000, 10000, 100000};
    int rays = 4000;
    std::string context = "osmesa", json, html, picture;
};

/// The command that makes the same numbers again.
std::string commandOf(const LabOptions& options) {
    std::string command =
        "gnomon lab intersect --rays=" + std::to_string(options.rays) + " --context=" + options.context;
    const auto append = [&](const char* name, const auto& values, const auto& text) {
        for (std::size_t i = 0; i < values.size(); ++i) command += (i ? "," : name) + text(values[i]);
    };
    append(" --distances=", options.distances, [](double distance) { return toString(distance); });
    append(" --shapes=", options.shapes, [](const std::string& shape) { return shape; });
    return command;
}

std::atomic<bool> interrupted{false};
extern "C" void interrupt(int) {
    interrupted = true;
    std::signal(SIGINT, SIG_DFL); // once more ends the program
}

bool isSoftware(const std::string& renderer) {
    return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos ||
           renderer.find("SwiftShader") != std::string::npos;
}

void printRow(const oracle::IntersectRow& row) {
    const oracle::IntersectCell& cell = row.cell;
    std::printf("%-9s %-8s %-8s %7.0f %7lld %5lld %9.2g %8.2f %8.2f %8.2f %10lld %6.2f\n",
                std::string(cell.subject.shape).c_str(), std::string(cell.subject.proportion).c_str(),
                std::string(raysOf(cell)).c_str(), cell.distance, (long long)row.ours.decided,
                (long long)row.ours.wrong(), row.ours.t.most, row.ours.ray.worst, row.ours.point.worst,
                row.ours.normal.worst, (long long)(row.naive.missed + row.naive.invented), row.cost.median);
    std::fflush(stdout);
}

/// What is left to do, on a line of its own where people look on.
void printProgress(std::size_t done, std::size_t all, double started) {
    if (!isatty(STDERR_FILENO)) return;
    const double left = (monotonicSeconds() - started) / double(std::max<std::size_t>(done, 1)) * double(all - done);
    std::fprintf(stderr, "\r%zu of %zu, %.0f s left  \r", done, all, left);
}

Problems checkOptions(const LabOptions& options) {
    Problems problems;
    if (!contextNamed(options.context))
        problems.push_back(wrongOption("context", "'" + options.context + "' is none of osmesa|egl|window", {}));
    if (options.rays < 100 || options.rays > 10000000)
        problems.push_back(
            wrongOption("rays", std::to_string(options.rays) + " is out of range", "use 100 … 10000000"));
    for (const double distance : options.distances)
        if (!(distance >= 2 && distance <= 1e6))
            problems.push_back(
                wrongOption("distances", toString(distance) + " is out of range", "use 2 … 1000000 sizes"));
    std::vector<std::string_view> names;
    for (const ShapeRow& row : shapeTable()) names.push_back(row.key);
    for (const std::string& shape : options.shapes)
        if (std::find(names.begin(), names.end(), shape) == names.end()) {
            const auto meant = closest(shape, names);
            problems.push_back(
                wrongOption("shapes", "there is no shape '" + shape + "'",
                            meant.empty() ? std::string() : "did you mean '" + std::string(meant) + "'?"));
        }
    return problems;
}

ExitCode writeResults(const LabOptions& options, const Results& results, Problems& problems) {
    if (!options.json.empty()) writeText(options.json, toJson(results), problems);
    if (!options.html.empty()) writeText(options.html, toHtml(results), problems);
    if (!options.picture.empty()) writeTextbookPicture(options.picture, problems);
    return problems.empty() ? kDone : kInputWrong;
}

int labIntersect(const LabOptions& options) {
    if (const Problems problems = checkOptions(options); !problems.empty()) return fail(kCommandLineWrong, problems);
    Problems problems;
    const ContextKind kind = *contextNamed(options.context);
    const auto context = makeContext(kind, problems);
    if (!context) return fail(kNoGl, problems);
    Results results{
        "Intersectors: errors and cost", commandOf(options), environmentOf(kind), {}, oracle::intersectCharts()};
    for (const auto& [name, value] : results.environment) std::printf("%-10s %s\n", name.c_str(), value.c_str());
    std::printf("%-9s %-8s %-8s %7s %7s %5s %9s %8s %8s %8s %10s %6s\n", "shape", "", "rays", "sizes", "decided",
                "wrong", "t 99.9 %", "o+td max", "point", "normal", "textbook:", "cost");
    oracle::IntersectLab lab(naiveShaders(), isSoftware(gl::info().renderer) ? processSeconds : monotonicSeconds);
    const auto cells = oracle::intersectCells(options.shapes, options.distances);
    std::vector<oracle::IntersectRow> rows;
    std::signal(SIGINT, interrupt);
    const double started = monotonicSeconds();
    std::int64_t wrong = 0, decided = 0;
    for (const auto& cell : cells) {
        oracle::IntersectRow row;
        if (!lab.measure(cell, options.rays, row, problems)) return fail(kNoGl, problems);
        wrong += row.ours.wrong();
        decided += row.ours.decided;
        printRow(row);
        rows.push_back(std::move(row));
        printProgress(rows.size(), cells.size(), started);
        if (interrupted) break;
    }
    std::printf("\n%s\n", toMarkdown(oracle::intersectSummary(rows)).c_str());
    std::printf("%lld of %lld decided rays wrong%s\n", (long long)wrong, (long long)decided,
                interrupted ? "; interrupted: what is done is kept" : "");
    results.tables = {oracle::intersectSummary(rows), oracle::intersectTable(rows)};
    const ExitCode code = writeResults(options, results, problems);
    return code == kDone ? kDone : fail(code, problems);
}

} // namespace

void addLab(CLI::App& app, Task& task) {
    auto* lab = app.add_subcommand("lab", "Measures the tracer's own methods: speed beside error");
    lab->require_subcommand(1);
    auto options = std::make_shared<LabOptions>();
    auto* intersect =
        lab->add_subcommand("intersect", "Every shape's intersector against an exact oracle and the textbook");
    intersect->add_option("--shapes", options->shapes, "Only these")->type_name("SHAPE,…")->delimiter(',');
    intersect->add_option("--distances", options->distances, "Sizes from the eye to the body")
        ->type_name("N,…")
        ->delimiter(',');
    intersect->add_option("--rays", options->rays, "Rays of each class at each distance [4000]")->type_name("N");
    intersect->add_option("--context", options->context, "Where GL comes from [osmesa]")
        ->type_name("osmesa|egl|window");
    intersect->add_option("--json", options->json, "Write all numbers")->type_name("FILE");
    intersect->add_option("--html", options->html, "Write tables and charts, as one page")->type_name("FILE");
    intersect
        ->add_option("--picture", options->picture, "Write the torus from afar, by the textbook (above) and by ours")
        ->type_name("FILE.png");
    intersect->callback([&task, options] { task = [options] { return labIntersect(*options); }; });
}

} // namespace gnomon
