/// gnomon lab intersect: every shape's intersector, error beside cost.
#include "lab/intersect/intersect_lab.h"
#include "lab/intersect/textbook_picture.h"
#include "lab/reference/textbook/textbook.h"
#include "native/command/lab_command.h"
#include "native/context/environment.h"
#include "native/file/image_file.h"
#include "tracer/scene/shapes.h"

#include <algorithm>
#include <cstdio>

namespace gnomon {

namespace {

struct IntersectOptions {
    LabOptions lab;
    std::vector<std::string> shapes;
    std::vector<double> distances{3, 10, 100, 1000, 10000, 100000};
    int rays = 4000;
    std::string picture;
};

/// The command that makes the same numbers again.
std::string commandOf(const IntersectOptions& options) {
    std::vector<std::string> distances;
    for (const double distance : options.distances) distances.push_back(toString(distance));
    return "gnomon lab intersect --rays=" + std::to_string(options.rays) + " --context=" + options.lab.context +
           listOption("distances", distances) + listOption("shapes", options.shapes);
}

void printHead() {
    std::printf("%-9s %-8s %-8s %7s %7s %5s %9s %8s %8s %8s %10s %6s\n", "shape", "", "rays", "sizes", "decided",
                "wrong", "t 99.9 %", "o+td max", "point", "normal", "textbook:", "cost");
}

void printRow(const oracle::IntersectRow& row) {
    const oracle::IntersectCell& cell = row.cell;
    std::printf("%-9s %-8s %-8s %7.0f %7lld %5lld %9.2g %8.2f %8.2f %8.2f %10lld %6.2f\n",
                std::string(cell.subject.shape).c_str(), std::string(cell.subject.proportion).c_str(),
                std::string(raysOf(cell)).c_str(), cell.distance, (long long)row.ours.decided,
                (long long)row.ours.wrong(), row.ours.t.most, row.ours.ray.worst, row.ours.point.worst,
                row.ours.normal.worst, (long long)(row.textbook.missed + row.textbook.invented), row.cost.median);
    std::fflush(stdout);
}

void printSum(const std::vector<oracle::IntersectRow>& rows) {
    std::int64_t wrong = 0, decided = 0;
    for (const oracle::IntersectRow& row : rows) {
        wrong += row.ours.wrong();
        decided += row.ours.decided;
    }
    std::printf("\n%s\n", toMarkdown(oracle::intersectSummary(rows)).c_str());
    std::printf("%lld of %lld decided rays wrong%s\n", (long long)wrong, (long long)decided,
                LabProgress::interrupted() ? "; interrupted: what is done is kept" : "");
}

Problems checkOptions(const IntersectOptions& options) {
    Problems problems;
    checkLabOptions(options.lab, problems);
    if (!options.picture.empty()) checkImageFile(options.picture, "png", Aov::Color, problems);
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

/// False, with problems, where a row cannot be measured; fewer rows where the user wants no more.
bool measure(const IntersectOptions& options, std::vector<oracle::IntersectRow>& rows, Problems& problems) {
    oracle::IntersectLab lab(textbookShaders(), labClock());
    const auto cells = oracle::intersectCells(options.shapes, options.distances);
    LabProgress progress(cells.size());
    for (const auto& cell : cells) {
        oracle::IntersectRow row;
        if (!lab.measure(cell, options.rays, row, problems)) return false;
        printRow(row);
        rows.push_back(std::move(row));
        if (!progress.step()) break;
    }
    return true;
}

int labIntersect(const IntersectOptions& options) {
    Problems problems = checkOptions(options);
    if (!problems.empty()) return fail(kCommandLineWrong, problems);
    const ContextKind kind = *contextNamed(options.lab.context);
    const auto context = makeContext(kind, problems);
    if (!context) return fail(kNoGl, problems);
    Results results{
        "Intersectors: errors and cost", commandOf(options), environmentOf(kind), {}, oracle::intersectCharts()};
    printEnvironment(results.environment);
    printHead();
    std::vector<oracle::IntersectRow> rows;
    if (!measure(options, rows, problems)) return fail(kNoGl, problems);
    printSum(rows);
    results.tables = {oracle::intersectSummary(rows), oracle::intersectTable(rows)};
    writeResults(options.lab, results, problems);
    if (!options.picture.empty()) writeTextbookPicture(options.picture, problems);
    return problems.empty() ? doneOrInterrupted() : fail(kInputWrong, problems);
}

} // namespace

void addIntersectLab(CLI::App& lab, Task& task) {
    auto options = std::make_shared<IntersectOptions>();
    auto* intersect =
        lab.add_subcommand("intersect", "Every shape's intersector against an exact oracle and the textbook");
    intersect->add_option("--shapes", options->shapes, "Only these")->type_name("SHAPE,…")->delimiter(',');
    intersect->add_option("--distances", options->distances, "Sizes from the eye to the shape")
        ->type_name("N,…")
        ->delimiter(',');
    intersect->add_option("--rays", options->rays, "Rays of each class at each distance [4000]")->type_name("N");
    addLabOptions(*intersect, options->lab);
    intersect
        ->add_option("--picture", options->picture, "Write the torus from afar, by the textbook (above) and by ours")
        ->type_name("FILE.png");
    intersect->callback([&task, options] { task = [options] { return labIntersect(*options); }; });
}

} // namespace gnomon
