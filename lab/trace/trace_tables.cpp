#include "lab/trace/trace_tables.h"

#include "lab/results/result_pictures.h"

#include <algorithm>
#include <cstdio>

namespace gnomon {
namespace {

/// Slower than the best by no more is chosen right.
constexpr double kRightChoice = 1.15;

Cell number(double value) { return value; }

double roundsOf(const TraceCost& cost) { return double(cost.seconds.size()); }

double milliseconds(const TraceCost& cost) { return 1e3 * quartilesOf(cost.seconds).median; }

void appendQuartiles(const Quartiles& all, std::vector<Cell>& row) {
    row.insert(row.end(), {all.median, all.low, all.high});
}

void appendFrame(const TraceCost& cost, std::vector<Cell>& row) {
    const Quartiles frame = quartilesOf(cost.seconds);
    appendQuartiles({1e3 * frame.low, 1e3 * frame.median, 1e3 * frame.high}, row);
}

const TraceCost* costIn(const std::vector<TraceCost>& costs, const TraceWay& way) {
    const auto found = std::find_if(costs.begin(), costs.end(), [&](const TraceCost& cost) { return cost.way == way; });
    return found == costs.end() ? nullptr : &*found;
}

/// The plain loop over numbers in a block; in a texture, where no block holds them.
const TraceCost* baseOf(const std::vector<TraceCost>& costs) {
    const TraceCost* block = costIn(costs, {Accel::None, DataPath::Block});
    return block ? block : costIn(costs, {Accel::None, DataPath::Texture});
}

void appendWork(const std::optional<Work>& work, std::vector<Cell>& row) {
    const auto cell = [&](double Work::*part) { return work ? number((*work).*part) : Cell{}; };
    row.insert(row.end(), {cell(&Work::boxes), cell(&Work::objects), cell(&Work::shadowRays)});
}

const std::vector<Column> kWorkColumns{
    {"boxes", "boxes", "a pixel",
     "Boxes of hierarchies and cells of lattices tested: mean; spheres of a bounding-sphere mask do not count",
     Kind::Count, Better::Lower},
    {"objects", "objects", "a pixel", "Objects asked where a ray meets them: mean", Kind::Count, Better::Lower},
    {"shadow_rays", "shadow rays", "a pixel", "Mean", Kind::Count, Better::Lower}};

const Column kRoundsColumn{"rounds", "rounds", "", "Measured"};

std::vector<Cell> viewRow(const ViewCosts& view, const TraceCost& cost) {
    std::vector<Cell> row{view.view, nameOf(cost.way), dataOf(cost.way)};
    appendFrame(cost, row);
    appendQuartiles(ratioOf(cost.seconds, baseOf(view.ways)->seconds), row);
    const TraceCost* source = costIn(view.ways, {Accel::None, DataPath::Block, true});
    if (source)
        appendQuartiles(ratioOf(source->seconds, cost.seconds), row);
    else
        row.resize(row.size() + 3);
    appendWork(cost.work, row);
    row.insert(row.end(), {double(cost.program.sourceBytes), cost.program.compileMs, roundsOf(cost)});
    return row;
}

/// The same way with the fewest spheres in the same arrangement.
const TraceCost& fewest(const std::vector<GrowthCosts>& growth, const GrowthCosts& spheres, const TraceWay& way) {
    const TraceCost* least = nullptr;
    int count = 0;
    for (const GrowthCosts& other : growth)
        for (const GrowthCosts::Way& one : other.ways)
            if (other.arrangement == spheres.arrangement && one.cost.way == way && (!least || other.spheres < count)) {
                least = &one.cost;
                count = other.spheres;
            }
    return *least;
}

Quartiles growthOf(const std::vector<GrowthCosts>& growth, const GrowthCosts& spheres, const TraceCost& cost) {
    return ratioOf(cost.seconds, fewest(growth, spheres, cost.way).seconds);
}

/// `auto` among those that read the scene from the same data path. The source's way is none that could be chosen, and a
/// way that searches alike is the same program.
void addChoice(const std::string& picture, const std::vector<TraceCost>& costs, DataPath data, Table& table) {
    const TraceCost* chosen = costIn(costs, {Accel::Auto, data});
    if (!chosen) return;
    const TraceCost* best = chosen;
    for (const TraceCost& cost : costs)
        if (cost.way.data == data && !cost.way.source && cost.search != chosen->search &&
            milliseconds(cost) < milliseconds(*best))
            best = &cost;
    const Quartiles ratio = ratioOf(chosen->seconds, best->seconds);
    std::vector<Cell> row{picture, dataOf(chosen->way), chosen->search, nameOf(best->way)};
    appendQuartiles(ratio, row);
    row.emplace_back(roundsOf(*chosen));
    row.emplace_back(ratio.median <= kRightChoice ? "yes" : "no");
    table.rows.push_back(std::move(row));
}

std::string titleOf(const GrowthCosts& spheres) {
    return std::string(nameOf(spheres.arrangement)) + ", " + std::to_string(spheres.spheres);
}

} // namespace

Table viewTable(const std::vector<ViewCosts>& views) {
    Table table{"scenes", "Scenes", {}, {}, 3};
    table.columns = {
        {"view", "view", "", "The scene from its own camera, or from where the name says"},
        {"way", "way", "", "source: the document's way; variants: auto, by shader variants; else as --accel says"},
        {"data", "data", "", "Where the scene's numbers are, as --data says"},
        {"frame", "frame", "ms", "Median of the rounds", Kind::Time, Better::Lower},
        {"frame_low", "frame, lower quartile", "ms", "Of the rounds"},
        {"frame_high", "frame, upper quartile", "ms", "Of the rounds"},
        {"ratio", "ratio", "none, block = 1", "Of a frame's time to the plain loop's, in the same round", Kind::Ratio,
         Better::Lower},
        {"ratio_low", "ratio, lower quartile", "", "Of the rounds"},
        {"ratio_high", "ratio, upper quartile", "", "Of the rounds"},
        {"speed_up", "speed-up", "source = 1", "Of the source's time to this, in the same round: median", Kind::Ratio,
         Better::Higher},
        {"speed_up_low", "speed-up, lower quartile", "", "Of the rounds"},
        {"speed_up_high", "speed-up, upper quartile", "", "Of the rounds"}};
    table.columns.insert(table.columns.end(), kWorkColumns.begin(), kWorkColumns.end());
    table.columns.push_back({"source", "source", "bytes", "Of the specialised shader", Kind::Count, Better::Lower});
    table.columns.push_back(
        {"compile", "compile", "ms", "Compiled, linked and first drawn, nothing cached: wall clock"});
    table.columns.push_back(kRoundsColumn);
    for (const ViewCosts& view : views)
        for (const TraceCost& cost : view.ways) table.rows.push_back(viewRow(view, cost));
    return table;
}

Table growthTable(const std::vector<GrowthCosts>& growth) {
    Table table{"growth", "Growth", {}, {}, 3};
    table.columns = {
        {"arrangement", "arrangement", "", "Of the spheres: random, in eight heaps, or on a lattice"},
        {"spheres", "spheres", "", "In the scene"},
        {"way", "way", "", "As --accel says, by one program; none only up to " + std::to_string(kMostLooped)},
        {"frame", "frame", "ms", "Median of the rounds", Kind::Time, Better::Lower},
        {"frame_low", "frame, lower quartile", "ms", "Of the rounds"},
        {"frame_high", "frame, upper quartile", "ms", "Of the rounds"},
        {"growth", "frame time", "fewest = 1", "To that of the fewest spheres: median of the rounds", Kind::Ratio,
         Better::Lower},
        {"growth_low", "frame time, lower quartile", "", "Of the rounds"},
        {"growth_high", "frame time, upper quartile", "", "Of the rounds"}};
    table.columns.insert(table.columns.end(), kWorkColumns.begin(), kWorkColumns.end());
    table.columns.push_back(
        {"pack", "pack", "ms of one core",
         "A frame's numbers, boxes fitted and children sorted, when all spheres move; regular ones rest"});
    table.columns.push_back({"load", "load", "ms of one core",
                             "From the scene to its first frame's numbers: search chosen, hierarchy built"});
    table.columns.push_back(kRoundsColumn);
    for (const GrowthCosts& spheres : growth)
        for (const GrowthCosts::Way& way : spheres.ways) {
            std::vector<Cell> row{std::string(nameOf(spheres.arrangement)), double(spheres.spheres),
                                  nameOf(way.cost.way)};
            appendFrame(way.cost, row);
            appendQuartiles(growthOf(growth, spheres, way.cost), row);
            appendWork(way.cost.work, row);
            row.insert(row.end(), {way.packMs, way.loadMs, roundsOf(way.cost)});
            table.rows.push_back(std::move(row));
        }
    return table;
}

Table choiceTable(const std::vector<ViewCosts>& views, const std::vector<GrowthCosts>& growth) {
    Table table{"choice", "Choice: the cost model against the clock", {}, {}, 2};
    table.columns = {{"picture", "picture", "", "A view, or spheres"},
                     {"data", "data", "", "Where the scene's numbers are"},
                     {"chose", "auto chose", "", "Of the kinds that are not asked one by one"},
                     {"best", "best", "", "The way with the least median: auto, where no other search is faster"},
                     {"ratio", "auto", "best = 1", "Of a frame's time to the best one's, in the same round: median",
                      Kind::Ratio, Better::Lower},
                     {"ratio_low", "auto, lower quartile", "", "Of the rounds"},
                     {"ratio_high", "auto, upper quartile", "", "Of the rounds"},
                     kRoundsColumn,
                     {"right", "right", "", "Within 15 % of the best"}};
    for (const ViewCosts& view : views)
        for (const DataPath data : {DataPath::Block, DataPath::Texture}) addChoice(view.view, view.ways, data, table);
    for (const GrowthCosts& spheres : growth) {
        std::vector<TraceCost> costs;
        for (const GrowthCosts::Way& way : spheres.ways) costs.push_back(way.cost);
        addChoice(titleOf(spheres), costs, DataPath::Texture, table);
    }
    return table;
}

void addTracePictures(const std::vector<ViewCosts>& views, const std::vector<GrowthCosts>& growth, Results& results) {
    const auto titled = [](const TraceCost& cost) { return nameOf(cost.way) + ", " + dataOf(cost.way); };
    for (const ViewCosts& view : views) {
        const TraceCost& base = *baseOf(view.ways);
        for (const TraceCost& cost : view.ways)
            addPicture({view.view + ", " + titled(cost),
                        "scenes",
                        {view.view, nameOf(cost.way), dataOf(cost.way)},
                        0,
                        {},
                        titled(base)},
                       cost.image, base.image, results);
    }
    for (const GrowthCosts& spheres : growth)
        for (const GrowthCosts::Way& way : spheres.ways) {
            const TraceCost &cost = way.cost, &base = spheres.ways.front().cost;
            addPicture({titleOf(spheres) + ", " + nameOf(cost.way),
                        "growth",
                        {std::string(nameOf(spheres.arrangement)), double(spheres.spheres), nameOf(cost.way)},
                        0,
                        {},
                        nameOf(base.way)},
                       cost.image, base.image, results);
        }
}

std::vector<Chart> traceCharts() {
    const Chart speedUp{"Speed-up over the source's way, with numbers in a block and in a texture",
                        "scenes",
                        "view",
                        {{"speed_up", ""}},
                        "way",
                        "data",
                        {}};
    const auto growth = [](const char* title, const std::vector<std::pair<std::string, std::string>>& columns) {
        return Chart{title, "growth", "spheres", columns, "way", "arrangement", {}, true, true};
    };
    return {speedUp, growth("Frame time beside that of the fewest spheres", {{"growth", ""}}),
            growth("Boxes and objects asked a pixel", {{"boxes", "boxes"}, {"objects", "objects"}})};
}

std::string growthSummary(const std::vector<GrowthCosts>& growth) {
    std::string text;
    for (std::size_t i = 0; i < growth.size(); ++i) {
        const GrowthCosts& most = growth[i];
        const bool last = i + 1 == growth.size() || growth[i + 1].arrangement != most.arrangement;
        const auto first = std::find_if(growth.begin(), growth.end(), [&](const GrowthCosts& other) {
            return other.arrangement == most.arrangement;
        });
        if (!last || first->spheres == most.spheres) continue;
        text += std::string(nameOf(most.arrangement)) + " spheres, " + std::to_string(first->spheres) + " to " +
                std::to_string(most.spheres) + ": a frame takes";
        for (const GrowthCosts::Way& way : most.ways) {
            char words[80];
            std::snprintf(words, sizeof words, "%s %.2f times as long (%s)", &way == &most.ways.front() ? "" : ",",
                          growthOf(growth, most, way.cost).median, nameOf(way.cost.way).c_str());
            text += words;
        }
        text += "\n";
    }
    return text;
}

} // namespace gnomon
