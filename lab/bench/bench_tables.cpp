#include "lab/bench/bench_tables.h"

#include "lab/results/quartiles.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace gnomon {
namespace {

constexpr double kMs = 1e3; // in a second

/// A measured column; one with quartiles is followed by theirs.
struct Measure {
    const char *key, *title, *unit, *help;
    Kind kind = Kind::None;
    Better better = Better::Untold;
    bool quartiles = false;
};
constexpr Measure kMeasures[] = {
    {"fps", "FPS", "1/s", "One over the median frame", Kind::None, Better::Higher},
    {"frame", "frame", "ms", "Wall clock, from asking for a frame to its last pixel: median of the rounds", Kind::Time,
     Better::Lower, true},
    {"frame_calibrated", "frame", "calibration = 1",
     "The frame over the calibration workload right before and after it: median of the rounds. By CPU time on a "
     "software rasteriser. What slows the machine slows both; runs are compared by it",
     Kind::None, Better::Untold, true},
    {"cpu", "CPU", "ms", "CPU time of a frame, all threads together: median of the rounds", Kind::Time, Better::Lower,
     true},
    {"gpu", "GPU", "ms", "By the GL's own timer: median of the rounds"},
    {"ratio", "ratio", "", "Of the frame's time to the baseline's in the same round: median of the rounds", Kind::Ratio,
     Better::Lower, true},
    {"compile", "compile", "ms", "Compiled, linked and drawn as one pixel, nothing cached"},
    {"first", "first frame", "ms", "The first frame of full size after that"},
    {"source", "source", "bytes", "Of the specialised shader", Kind::Count, Better::Lower},
    {"rounds", "rounds", "", "Measured"},
    {"passes", "passes", "", "Programs were compiled anew so often for the rounds"},
};

void appendMeasure(const Measure& measure, const std::string& unit, Table& table) {
    const std::string key = measure.key, title = measure.title;
    table.columns.push_back({key, title, unit, measure.help, measure.kind, measure.better});
    for (const char* side : {"low", "high"})
        if (measure.quartiles)
            table.columns.push_back({key + "_" + side, title + (*side == 'l' ? ", lower" : ", upper") + " quartile",
                                     unit, "Of the rounds"});
}

Table emptyTable(const BenchPlan& plan, bool gpuTimed) {
    Table table{"bench", "Frames a second", {}, {}};
    table.columns = {{"scene", "scene", "", "Name or file"}, {"context", "context", "", "Where GL comes from"}};
    for (const Axis& axis : plan.axes) {
        const std::string key(axis.setting->key);
        table.columns.push_back(
            {key, key, axis.setting->key == "size" ? "pixels" : "", std::string(axis.setting->help)});
    }
    table.keys = int(table.columns.size());
    for (const Measure& measure : kMeasures)
        if (gpuTimed || measure.key != std::string_view("gpu"))
            appendMeasure(measure, measure.kind == Kind::Ratio ? plan.baselineText + " = 1" : measure.unit, table);
    return table;
}

/// Median and quartiles, or nothing where nothing was measured.
void appendQuartiles(const Quartiles& quartiles, bool known, double unit, std::vector<Cell>& row) {
    const std::size_t at = row.size();
    row.resize(at + 3);
    if (!known) return;
    row[at] = unit * quartiles.median;
    row[at + 1] = unit * quartiles.low;
    row[at + 2] = unit * quartiles.high;
}

/// Words, but the numbers of whole-number settings as numbers: charts draw over them.
Cell valueCell(const Axis& axis, const std::string& value) {
    return std::holds_alternative<IntType>(axis.setting->type) ? Cell(double(std::stoi(value))) : Cell(value);
}

std::vector<Cell> rowOf(const BenchPlan& plan, const ContextCosts& context, std::size_t entry, bool gpuTimed) {
    const BenchCost &cost = context.costs[entry], &base = context.costs[plan.baselines[entry]];
    std::vector<Cell> row{plan.scenes[plan.entries[entry].scene], context.context};
    for (std::size_t i = 0; i < plan.axes.size(); ++i)
        row.push_back(valueCell(plan.axes[i], plan.entries[entry].values[i]));
    const Quartiles frame = quartilesOf(cost.wall);
    const bool measured = !cost.wall.empty();
    row.resize(row.size() + 1);
    if (measured) row.back() = 1 / frame.median;
    appendQuartiles(frame, measured, kMs, row);
    appendQuartiles(quartilesOf(cost.calibrated), measured, 1, row);
    appendQuartiles(quartilesOf(cost.cpu), !cost.cpu.empty(), kMs, row);
    if (gpuTimed) row.resize(row.size() + 1);
    if (!cost.gpu.empty()) row.back() = kMs * quartilesOf(cost.gpu).median;
    appendQuartiles(ratioOf(cost.wall, base.wall), measured && !base.wall.empty(), 1, row);
    row.insert(row.end(),
               {Cell(cost.program.compileMs), Cell(kMs * cost.firstSeconds), Cell(double(cost.program.sourceBytes)),
                Cell(double(cost.wall.size())), Cell(double(cost.passes))});
    return row;
}

using Where = std::vector<std::pair<std::string, std::string>>;

/// Every combination of one more column's values with those before; a column of one value needs no saying.
std::vector<Where> combined(const std::vector<Where>& before, const std::string& key,
                            const std::vector<std::string>& values) {
    if (values.size() < 2) return before;
    std::vector<Where> all;
    for (const Where& where : before)
        for (const std::string& value : values) {
            all.push_back(where);
            all.back().emplace_back(key, value);
        }
    return all;
}

} // namespace

Table benchTable(const BenchPlan& plan, const std::vector<ContextCosts>& contexts) {
    const bool gpuTimed = std::any_of(contexts.begin(), contexts.end(), [](const ContextCosts& context) {
        return std::any_of(context.costs.begin(), context.costs.end(),
                           [](const BenchCost& cost) { return !cost.gpu.empty(); });
    });
    Table table = emptyTable(plan, gpuTimed);
    for (const ContextCosts& context : contexts)
        for (std::size_t i = 0; i < context.costs.size(); ++i)
            if (context.costs[i].drawn) table.rows.push_back(rowOf(plan, context, i, gpuTimed));
    return table;
}

Table briefTable(const Table& all) {
    constexpr std::array<std::string_view, 8> kDropped{"context", "frame_calibrated", "cpu",    "gpu",
                                                       "first",   "source",           "rounds", "passes"};
    Table table{all.name, all.title, {}, std::vector<std::vector<Cell>>(all.rows.size())};
    for (std::size_t i = 0; i < all.columns.size(); ++i) {
        const std::string& key = all.columns[i].key;
        const bool dropped = std::any_of(kDropped.begin(), kDropped.end(), [&](std::string_view name) {
            return key == name || key == std::string(name) + "_low" || key == std::string(name) + "_high";
        });
        if (dropped) continue;
        table.columns.push_back(all.columns[i]);
        for (std::size_t row = 0; row < all.rows.size(); ++row) table.rows[row].push_back(all.rows[row][i]);
    }
    return table;
}

std::vector<Chart> benchCharts(const BenchPlan& plan, const std::vector<std::string>& contexts) {
    const auto has = [&](const char* key) {
        const auto axis =
            std::find_if(plan.axes.begin(), plan.axes.end(), [&](const Axis& a) { return a.setting->key == key; });
        return axis->values.size() > 1;
    };
    const bool lines = has("depth");
    std::vector<Where> wheres = combined({{}}, "context", contexts);
    for (const Axis& axis : plan.axes)
        if (const std::string key(axis.setting->key); key != "depth" && key != "shadows")
            wheres = combined(wheres, key, axis.values);
    std::vector<Chart> charts;
    for (const Where& where : wheres) {
        Chart chart{lines ? "FPS over depth, by shadows" : "FPS by shadows",
                    "bench",
                    lines ? "depth" : "shadows",
                    {{"fps", ""}},
                    lines ? "shadows" : "",
                    "scene",
                    where};
        for (const auto& [key, value] : where) chart.title += ", " + key + " " + value;
        charts.push_back(std::move(chart));
    }
    return charts;
}

Environment mergedEnvironment(const std::vector<ContextCosts>& contexts) {
    Environment merged;
    for (const auto& [name, value] : contexts.empty() ? Environment{} : contexts.front().environment) {
        std::string all;
        bool same = true;
        for (const ContextCosts& context : contexts) {
            const auto found = std::find_if(context.environment.begin(), context.environment.end(),
                                            [&, &key = name](const auto& entry) { return entry.first == key; });
            const std::string other = found == context.environment.end() ? "unknown" : found->second;
            same = same && other == value;
            all += (all.empty() ? "" : "; ") + (name == "context" ? "" : context.context + ": ") + other;
        }
        merged.emplace_back(name, same ? value : all);
    }
    return merged;
}

Results benchResults(const BenchPlan& plan, const std::vector<ContextCosts>& all,
                     const std::vector<std::string>& contexts, const std::string& command) {
    return {"Frames a second", command, mergedEnvironment(all), {benchTable(plan, all)}, benchCharts(plan, contexts)};
}

} // namespace gnomon
