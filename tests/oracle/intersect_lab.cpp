#include "tests/oracle/intersect_lab.h"

#include <algorithm>

namespace gnomon::oracle {
namespace {

constexpr int kPairs = 5;

Scene sceneOf(const Shape& shape) {
    Scene scene;
    scene.materials.resize(1);
    scene.objects.resize(1);
    scene.objects[0].shape = shape;
    return scene;
}

bool same(const Shape& a, const Shape& b) { return a.kind == b.kind && a.texels == b.texels; }

/// Repeats that make a draw long enough for the clock, about a tenth of a second for the slower of the two.
int repeatsFor(double once) { return std::clamp(int(0.03 / std::max(once, 1e-5)), 1, 64); }

Ratio costOf(RayBatch& ours, RayBatch& naive, std::span<const BatchRay> rays, double (*clock)()) {
    const int repeats = repeatsFor(ours.seconds(rays, 1, clock));
    std::vector<double> ratios;
    for (int i = 0; i < kPairs; ++i)
        ratios.push_back(ours.seconds(rays, repeats, clock) / naive.seconds(rays, repeats, clock));
    std::sort(ratios.begin(), ratios.end());
    return {ratios[kPairs / 2], ratios.front(), ratios.back()};
}

} // namespace

struct IntersectLab::Pair {
    Shape shape;
    RayBatch ours, naive;

    Pair(const Shape& placed, std::span<const ShaderFile> overrides, Problems& problems)
        : shape(placed), ours(sceneOf(placed), problems), naive(sceneOf(placed), problems, overrides) {}
};

IntersectLab::IntersectLab(std::span<const ShaderFile> naive, double (*clock)()) : naive_(naive), clock_(clock) {}
IntersectLab::~IntersectLab() = default;

std::vector<IntersectCell> intersectCells(const std::vector<std::string>& shapes,
                                          const std::vector<double>& distances) {
    std::vector<IntersectCell> cells;
    for (const Subject& subject : subjects())
        for (const RayClass kind : kRayClasses)
            for (const double distance : distances)
                if (fits(kind, subject) &&
                    (shapes.empty() || std::find(shapes.begin(), shapes.end(), subject.shape) != shapes.end()))
                    cells.push_back({subject, kind, distance});
    return cells;
}

bool IntersectLab::measure(const IntersectCell& cell, int rays, IntersectRow& row, Problems& problems) {
    const Shape shape = placed(cell.subject, cell.kind, cell.distance);
    if (!pair_ || !same(pair_->shape, shape)) pair_ = std::make_unique<Pair>(shape, naive_, problems);
    if (!pair_->ours.valid() || !pair_->naive.valid()) return false;
    RayStream stream(shape, cell.kind, cell.distance, 3);
    std::vector<BatchRay> asked(std::size_t(rays), BatchRay{});
    for (BatchRay& ray : asked) ray = stream.next();
    row = {cell, judgeAll(shape, asked, pair_->ours.trace(asked)), judgeAll(shape, asked, pair_->naive.trace(asked)),
           costOf(pair_->ours, pair_->naive, asked, clock_)};
    return true;
}

Table intersectTable(const std::vector<IntersectRow>& rows) {
    Table table{"intersect", "Intersectors against the oracle", {}, {}};
    table.columns = {
        {"shape", "shape", "", "As in scene files"},
        {"proportion", "proportion", "", "thin: 1/128 of the size"},
        {"class", "rays", "", "How the rays are chosen"},
        {"distance", "distance", "sizes", "From the eye to the body; inside: from the world's origin to the body"},
        {"rays", "rays", "", "Traced"},
        {"decided", "decided", "", "Far enough from tangency that float32 has to be right; the others are in the band"},
        {"missed", "missed", "", "Of the decided"},
        {"invented", "false hits", "", "Of the decided"},
        {"elsewhere", "elsewhere", "", "Of the decided: a hit, but not where the ray meets the body first"},
        {"margin", "farthest", "2^-24", "Of all decisions unlike the exact one: how far from tangency, in sizes"},
    };
    const auto spread = [&](const char* key, const char* title, const char* unit, const char* help) {
        for (const auto& [end, word] :
             {std::pair("median", "median"), std::pair("most", "99.9 %"), std::pair("worst", "max")})
            table.columns.push_back({std::string(key) + "_" + end, std::string(title) + ", " + word, unit, help});
    };
    spread("t", "t", "ulp", "|t - exact|, in ulp at that distance");
    spread("ray", "o + t d", "ulp", "Distance of o + t d from the surface, in ulp at that distance");
    spread("point", "point", "2^-23",
           "Distance of the surface point from the surface, in 2^-23 of size and coordinates");
    spread("normal", "normal", "2^-23", "Error of the normal, as the turn of so many roundings of the point");
    table.columns.insert(
        table.columns.end(),
        {{"share", "wrong decisions", "%", "Missed and false hits, of the decided"},
         {"naive_share", "textbook: wrong decisions", "%", "As wrong decisions"},
         {"naive_elsewhere", "textbook: elsewhere", "", "As elsewhere: farther off than 4 ulp, or another sheet"},
         {"naive_ray_most", "textbook: o + t d, 99.9 %", "ulp", "As o + t d"},
         {"naive_point_most", "textbook: point, 99.9 %", "2^-23", "As point"},
         {"cost", "cost", "textbook = 1", "Time of ours to the textbook's, interleaved: median"},
         {"cost_least", "cost, least", "textbook = 1", "Of the pairs"},
         {"cost_most", "cost, most", "textbook = 1", "Of the pairs"}});
    for (const IntersectRow& row : rows) {
        const Tally& ours = row.ours;
        const auto share = [&](const Tally& tally) -> Cell {
            if (tally.decided == 0) return {};
            return 100.0 * double(tally.missed + tally.invented) / double(tally.decided);
        };
        std::vector<Cell> cells{std::string(row.cell.subject.shape),
                                std::string(row.cell.subject.proportion),
                                std::string(nameOf(row.cell.kind)),
                                row.cell.distance,
                                double(ours.rays),
                                double(ours.decided),
                                double(ours.missed),
                                double(ours.invented),
                                double(ours.elsewhere),
                                ours.worstMargin * 0x1p24};
        for (const Spread* values : {&ours.t, &ours.ray, &ours.point, &ours.normal})
            cells.insert(cells.end(), {values->median, values->most, values->worst});
        cells.insert(cells.end(), {share(ours), share(row.naive), double(row.naive.elsewhere), row.naive.ray.most,
                                   row.naive.point.most, row.cost.median, row.cost.least, row.cost.most});
        table.rows.push_back(std::move(cells));
    }
    return table;
}

std::vector<Chart> intersectCharts() {
    const auto chart = [](const char* title, const char* kind, const std::string& column, bool log) {
        return Chart{std::string(title) + ", " + kind + " rays",
                     "intersect",
                     "distance",
                     {{column, "ours"}, {"naive_" + column, "textbook"}},
                     "proportion",
                     "shape",
                     {{"class", kind}},
                     true,
                     log};
    };
    Chart cost = chart("Time beside the textbook's", "uniform", "cost", false);
    cost.y.pop_back();
    return {chart("Wrong decisions", "uniform", "share", false), chart("Wrong decisions", "grazing", "share", false),
            chart("How far o + t d is from the surface, 99.9 %", "uniform", "ray_most", true),
            chart("How far the surface point is from the surface, 99.9 %", "uniform", "point_most", true), cost};
}

} // namespace gnomon::oracle
