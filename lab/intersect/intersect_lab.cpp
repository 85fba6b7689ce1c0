#include "lab/intersect/intersect_lab.h"

#include "lab/reference/exact/fan.h"

#include <algorithm>

namespace gnomon::oracle {
namespace {

constexpr int kPairs = 5;

bool same(const Shape& a, const Shape& b) { return a.kind == b.kind && a.values == b.values; }

bool same(const std::vector<Shape>& a, const std::vector<Shape>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Shape& x, const Shape& y) { return same(x, y); });
}

/// Every ray through a shared edge has to meet something: where, is as near as float32 can aim.
Tally leaksOf(const std::vector<BatchHit>& answers) {
    Tally tally;
    tally.rays = tally.decided = std::int64_t(answers.size());
    for (const BatchHit& answer : answers) ++(answer.object < 0 ? tally.missed : tally.hits);
    return tally;
}

/// Repeats that make a draw long enough for the clock, about a tenth of a second for the slower of the two.
int repeatsFor(double once) { return std::clamp(int(0.03 / std::max(once, 1e-5)), 1, 64); }

Quartiles costOf(RayBatch& ours, RayBatch& textbook, std::span<const BatchRay> rays, double (*clock)()) {
    const int repeats = repeatsFor(ours.seconds(rays, 1, clock));
    std::vector<double> ratios;
    for (int i = 0; i < kPairs; ++i)
        ratios.push_back(ours.seconds(rays, repeats, clock) / textbook.seconds(rays, repeats, clock));
    return quartilesOf(std::move(ratios));
}

} // namespace

struct IntersectLab::Pair {
    std::vector<Shape> shapes;
    RayBatch ours, textbook;

    Pair(const std::vector<Shape>& placed, std::span<const ShaderFile> overrides, Problems& problems)
        : shapes(placed), ours(sceneOf(placed), problems), textbook(sceneOf(placed), problems, overrides) {}
};

IntersectLab::IntersectLab(std::span<const ShaderFile> textbook, double (*clock)())
    : textbook_(textbook), clock_(clock) {}
IntersectLab::~IntersectLab() = default;

std::string_view raysOf(const IntersectCell& cell) { return cell.kind ? nameOf(*cell.kind) : "edges"; }

std::vector<IntersectCell> intersectCells(const std::vector<std::string>& shapes,
                                          const std::vector<double>& distances) {
    std::vector<IntersectCell> cells;
    for (const Subject& subject : subjects()) {
        if (!shapes.empty() && std::find(shapes.begin(), shapes.end(), subject.shape) == shapes.end()) continue;
        for (const RayClass kind : kRayClasses)
            for (const double distance : distances)
                if (fits(kind, subject)) cells.push_back({subject, kind, distance});
        if (subject.name() == "trianglefat")
            for (const double distance : distances) cells.push_back({subject, {}, distance});
    }
    return cells;
}

bool IntersectLab::prepare(const std::vector<Shape>& shapes, Problems& problems) {
    if (!pair_ || !same(pair_->shapes, shapes)) pair_ = std::make_unique<Pair>(shapes, textbook_, problems);
    return pair_->ours.valid() && pair_->textbook.valid();
}

bool IntersectLab::measure(const IntersectCell& cell, int rays, IntersectRow& row, Problems& problems) {
    std::vector<BatchRay> asked(std::size_t(rays), BatchRay{});
    row.cell = cell;
    if (!cell.kind) {
        Fan fan(glm::dvec3(0.3, -0.7, 1.1));
        if (!prepare(fan.triangles(), problems)) return false;
        for (BatchRay& ray : asked) ray = fan.next(cell.distance);
        row.ours = leaksOf(pair_->ours.trace(asked));
        row.textbook = leaksOf(pair_->textbook.trace(asked));
    } else {
        const Shape shape = placed(cell.subject, *cell.kind, cell.distance);
        if (!prepare({shape}, problems)) return false;
        RayStream stream(shape, *cell.kind, cell.distance, 3);
        for (BatchRay& ray : asked) ray = stream.next();
        row.ours = compareHits(shape, asked, pair_->ours.trace(asked));
        row.textbook = compareHits(shape, asked, pair_->textbook.trace(asked));
    }
    row.cost = costOf(pair_->ours, pair_->textbook, asked, clock_);
    return true;
}

namespace {

/// All rows of one shape.
struct Summary {
    std::int64_t decided = 0, wrong = 0;
    double margin = 0, ray = 0, point = 0, normal = 0;
    std::vector<double> costs;                                   ///< of uniform rays
    std::int64_t textbookWrong[2] = {}, textbookDecided[2] = {}; ///< uniform, grazing

    void add(const IntersectRow& row) {
        decided += row.ours.decided;
        wrong += row.ours.wrong();
        margin = std::max(margin, row.ours.worstMargin * 0x1p24);
        ray = std::max(ray, row.ours.ray.worst);
        point = std::max(point, row.ours.point.worst);
        normal = std::max(normal, row.ours.normal.worst);
        if (row.cell.kind == RayClass::Uniform) costs.push_back(row.cost.median);
        for (const int i : {0, 1})
            if (row.cell.kind == (i == 0 ? RayClass::Uniform : RayClass::Grazing)) {
                textbookWrong[i] += row.textbook.missed + row.textbook.invented;
                textbookDecided[i] += row.textbook.decided;
            }
    }
    Cell textbookWrongPercent(int i) const {
        if (textbookDecided[i] == 0) return {};
        return 100.0 * double(textbookWrong[i]) / double(textbookDecided[i]);
    }
};

} // namespace

Table intersectSummary(const std::vector<IntersectRow>& rows) {
    Table table{"summary", "Every shape, over all rays and distances", {}, {}, 1};
    table.columns = {
        {"shape", "shape", "", "Shape and proportion"},
        {"decided", "decided rays", "", "Far enough from tangency that float32 has to be right", Kind::Count},
        {"wrong", "wrong", "", "Of the decided: missed, false hit, or elsewhere", Kind::Count, Better::Lower},
        {"margin", "farthest", "2^-24", "Of all decisions unlike the exact one: how far from tangency, in sizes",
         Kind::Error},
        {"ray", "o + t d", "ulp", "Worst distance from the surface, in ulp at that distance", Kind::Error},
        {"point", "point", "2^-23", "Worst distance of the surface point from the surface, in roundings", Kind::Error},
        {"normal", "normal", "2^-23", "Worst error, as the turn of so many roundings of the point", Kind::Error},
        {"textbook_uniform", "textbook wrong, uniform", "%", "Missed and false hits of the textbook's formula",
         Kind::Error},
        {"textbook_grazing", "textbook wrong, grazing", "%", "The same, of grazing rays", Kind::Error},
        {"cost", "cost", "textbook = 1", "Time of uniform rays: median over the distances"}};
    std::vector<std::string> names;
    for (const IntersectRow& row : rows)
        if (names.empty() || names.back() != row.cell.subject.title()) names.push_back(row.cell.subject.title());
    for (const std::string& name : names) {
        Summary all;
        for (const IntersectRow& row : rows)
            if (row.cell.subject.title() == name) all.add(row);
        std::sort(all.costs.begin(), all.costs.end());
        const Cell cost = all.costs.empty() ? Cell{} : Cell(all.costs[all.costs.size() / 2]);
        table.rows.push_back({name, double(all.decided), double(all.wrong), all.margin, all.ray, all.point, all.normal,
                              all.textbookWrongPercent(0), all.textbookWrongPercent(1), cost});
    }
    return table;
}

Table intersectTable(const std::vector<IntersectRow>& rows) {
    Table table{"intersect", "Intersectors against the oracle", {}, {}, 4};
    table.columns = {
        {"shape", "shape", "", "As in scene files"},
        {"proportion", "proportion", "", "thin: 1/128 of the size"},
        {"class", "rays", "", "How the rays are chosen"},
        {"distance", "distance", "sizes", "From the eye to the shape; inside: from the world's origin to the shape"},
        {"rays", "rays", "", "Traced", Kind::Count},
        {"decided", "decided", "", "Far enough from tangency that float32 has to be right; the others are in the band",
         Kind::Count},
        {"missed", "missed", "", "Of the decided", Kind::Count, Better::Lower},
        {"invented", "false hits", "", "Of the decided", Kind::Count, Better::Lower},
        {"elsewhere", "elsewhere", "", "Of the decided: a hit, but not where the ray meets the shape first",
         Kind::Count, Better::Lower},
        {"margin", "farthest", "2^-24", "Of all decisions unlike the exact one: how far from tangency, in sizes",
         Kind::Error},
    };
    const auto spread = [&](const char* key, const char* title, const char* unit, const char* help) {
        for (const auto& [end, word] :
             {std::pair("median", "median"), std::pair("most", "99.9 %"), std::pair("worst", "max")})
            table.columns.push_back(
                {std::string(key) + "_" + end, std::string(title) + ", " + word, unit, help, Kind::Error});
    };
    spread("t", "t", "ulp", "|t - exact|, in ulp at that distance");
    spread("ray", "o + t d", "ulp", "Distance of o + t d from the surface, in ulp at that distance");
    spread("point", "point", "2^-23",
           "Distance of the surface point from the surface, in 2^-23 of size and coordinates");
    spread("normal", "normal", "2^-23", "Error of the normal, as the turn of so many roundings of the point");
    table.columns.insert(
        table.columns.end(),
        {{"wrong_decisions", "wrong decisions", "%", "Missed and false hits, of the decided", Kind::Error},
         {"textbook_wrong_decisions", "textbook: wrong decisions", "%", "As wrong decisions", Kind::Error},
         {"textbook_elsewhere", "textbook: elsewhere", "", "As elsewhere: farther off than 4 ulp, or another sheet",
          Kind::Count, Better::Lower},
         {"textbook_ray_most", "textbook: o + t d, 99.9 %", "ulp", "As o + t d", Kind::Error},
         {"textbook_point_most", "textbook: point, 99.9 %", "2^-23", "As point", Kind::Error},
         {"cost", "cost", "textbook = 1", "Time of ours to the textbook's, interleaved: median", Kind::Ratio},
         {"cost_low", "cost, lower quartile", "textbook = 1", "Of the pairs"},
         {"cost_high", "cost, upper quartile", "textbook = 1", "Of the pairs"},
         {"rounds", "pairs", "", "Timed for the cost"}});
    for (const IntersectRow& row : rows) {
        const Tally& ours = row.ours;
        const auto wrongPercent = [&](const Tally& tally) -> Cell {
            if (tally.decided == 0) return {};
            return 100.0 * double(tally.missed + tally.invented) / double(tally.decided);
        };
        std::vector<Cell> cells{std::string(row.cell.subject.shape),
                                std::string(row.cell.subject.proportion),
                                std::string(raysOf(row.cell)),
                                row.cell.distance,
                                double(ours.rays),
                                double(ours.decided),
                                double(ours.missed),
                                double(ours.invented),
                                double(ours.elsewhere),
                                ours.worstMargin * 0x1p24};
        for (const Spread* values : {&ours.t, &ours.ray, &ours.point, &ours.normal})
            cells.insert(cells.end(), {values->median, values->most, values->worst});
        cells.insert(cells.end(), {wrongPercent(ours), wrongPercent(row.textbook), double(row.textbook.elsewhere),
                                   row.textbook.ray.most, row.textbook.point.most, row.cost.median, row.cost.low,
                                   row.cost.high, double(kPairs)});
        table.rows.push_back(std::move(cells));
    }
    return table;
}

std::vector<Chart> intersectCharts() {
    const auto chart = [](const char* title, const char* kind, const std::string& column, bool log) {
        return Chart{std::string(title) + ", " + kind + " rays",
                     "intersect",
                     "distance",
                     {{column, "ours"}, {"textbook_" + column, "textbook"}},
                     "proportion",
                     "shape",
                     {{"class", kind}},
                     true,
                     log};
    };
    Chart cost = chart("Time beside the textbook's", "uniform", "cost", false);
    cost.y.pop_back();
    return {chart("Wrong decisions", "uniform", "wrong_decisions", false),
            chart("Wrong decisions", "grazing", "wrong_decisions", false),
            chart("How far o + t d is from the surface, 99.9 %", "uniform", "ray_most", true),
            chart("How far the surface point is from the surface, 99.9 %", "uniform", "point_most", true), cost};
}

} // namespace gnomon::oracle
