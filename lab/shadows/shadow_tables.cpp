#include "lab/shadows/shadow_tables.h"

#include "lab/results/result_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace gnomon {
namespace {

constexpr double kLinearEpsilon = 1.0 / 30;
constexpr std::array kVariants{ShadowModel::ConeBase, ShadowModel::ConeLinear, ShadowModel::ConeDiscrete,
                               ShadowModel::ConeConvex};

std::string nameOf(ConeOrigin origin) { return origin == ConeOrigin::Surface ? "surface" : "light"; }

double median(const std::vector<double>& seconds) { return quartilesOf(seconds).median; }

/// `cone-linear 1/30 surface`, `montecarlo 16`.
std::string nameOf(const ShadowWay& way) {
    std::string name(shadowRow(way.model).key);
    if (takesSamples(way.model)) return name + " " + std::to_string(way.samples);
    if (!marchesCones(way.model)) return name;
    return name + " 1/" + std::to_string(std::lround(1 / way.epsilon)) + " " + nameOf(way.coneOrigin);
}

/// By name: 1/30 as a command line tells it is not quite the same number.
const ShadowCost* find(const ShadowCosts& costs, const ShadowWay& way) {
    const auto found = std::find_if(costs.ways.begin(), costs.ways.end(),
                                    [&](const ShadowCost& cost) { return nameOf(cost.way) == nameOf(way); });
    return found == costs.ways.end() ? nullptr : &*found;
}

std::vector<Cell> keysOf(const ShadowCosts& costs, const ShadowWay& way) {
    std::vector<Cell> row{costs.scene, costs.radius, std::string(shadowRow(way.model).key), Cell{}, Cell{}, Cell{}};
    if (marchesCones(way.model)) {
        row[3] = nameOf(way.coneOrigin);
        row[4] = way.epsilon;
    }
    if (takesSamples(way.model)) row[5] = double(way.samples);
    return row;
}

std::vector<Cell> rowOf(const ShadowCosts& costs, const ShadowCost& cost) {
    const Quartiles ratio = ratioOf(cost.seconds, costs.bare);
    std::vector<Cell> row = keysOf(costs, cost.way);
    const Quartiles frame = quartilesOf(cost.seconds);
    if (cost.seconds.empty())
        row.resize(row.size() + 6); // interrupted before the first round
    else
        row.insert(row.end(),
                   {1e3 * frame.median, 1e3 * frame.low, 1e3 * frame.high, ratio.median, ratio.low, ratio.high});
    row.insert(row.end(), {double(cost.seconds.size()), cost.evaluations, Cell{}});
    if (cost.shadowRays) row.back() = *cost.shadowRays;
    const Errors& fraction = cost.visibility;
    row.insert(row.end(), {fraction.rmse, fraction.mean, fraction.most999, fraction.most, cost.picture.rmse});
    row.push_back(cost.seconds.empty() ? Cell{} : Cell{std::string(cost.front ? "yes" : "no")});
    return row;
}

double timeOf(const ShadowCost& cost) { return median(cost.seconds); }
double evaluationsOf(const ShadowCost& cost) { return cost.evaluations; }

/// Of one model the way that comes nearest to `most` without passing it; the cheapest where all do.
const ShadowCost* nearestWithin(const ShadowCosts& costs, ShadowModel model, double (*priceOf)(const ShadowCost&),
                                double most) {
    const ShadowCost* best = nullptr;
    for (const ShadowCost& cost : costs.ways) {
        if (cost.way.model != model) continue;
        const double price = priceOf(cost);
        const bool costlier = best && price > priceOf(*best), within = best && priceOf(*best) <= most;
        if (!best || (within ? costlier && price <= most : !costlier)) best = &cost;
    }
    return best;
}

} // namespace

Table shadowTable(const std::vector<ShadowCosts>& all) {
    Table table{"shadows", "Shadow models: cost and error", {}, {}, 6};
    table.columns = {
        {"scene", "scene", "", ""},
        {"radius", "light radius", "scene units", "Of all lights"},
        {"model", "model", "", "As --shadows says"},
        {"cone_origin", "cone origin", "", "End that the shadow cone is marched from: surface or light"},
        {"epsilon", "epsilon", "", "Error of the light fraction that cones may make"},
        {"samples", "samples", "", "Points of a light that are looked at"},
        {"frame", "frame", "ms", "Median of the rounds", Kind::Time, Better::Lower},
        {"frame_low", "frame, lower quartile", "ms", "Of the rounds"},
        {"frame_high", "frame, upper quartile", "ms", "Of the rounds"},
        {"ratio", "frame time", "no shadows = 1", "In the same round: median", Kind::Ratio, Better::Lower},
        {"ratio_low", "frame time, lower quartile", "", "Of the rounds"},
        {"ratio_high", "frame time, upper quartile", "", "Of the rounds"},
        {"rounds", "rounds", "", "Measured"},
        {"evaluations", "evaluations", "a pixel", "Of distances, for shadows: mean", Kind::Count, Better::Lower},
        {"shadow_rays", "shadow rays", "a pixel", "Mean", Kind::Count, Better::Lower},
        {"rmse", "error", "light fraction", "Root of the mean square, over pixels that see a surface", Kind::Error,
         Better::Lower},
        {"mean", "mean error", "light fraction", "Above 0: too light", Kind::Error, Better::Lower},
        {"error_999", "error, 99.9 %", "light fraction", "All but one pixel in a thousand are nearer", Kind::Error,
         Better::Lower},
        {"error_max", "error, greatest", "light fraction", "", Kind::Error, Better::Lower},
        {"picture", "error of the picture", "colour", "Root of the mean square of the linear colours", Kind::Error,
         Better::Lower},
        {"front", "front", "", "No other way is both faster and nearer to the reference"}};
    for (const ShadowCosts& costs : all)
        for (const ShadowCost& cost : costs.ways) table.rows.push_back(rowOf(costs, cost));
    return table;
}

Table variantTable(const std::vector<ShadowCosts>& all) {
    Table table{"variants", "Variants of the cone march: frame times, no shadows = 1", {}, {}, 4};
    table.columns = {{"scene", "scene", "", ""},
                     {"radius", "light radius", "scene units", ""},
                     {"epsilon", "epsilon", "", ""},
                     {"cone_origin", "cone origin", "", "End that the shadow cone is marched from: surface or light"}};
    for (const ShadowModel model : kVariants) {
        const std::string key(shadowRow(model).key);
        table.columns.push_back({key, key, "", "Median of the rounds"});
    }
    for (const ShadowCosts& costs : all) {
        std::set<double, std::greater<>> epsilons;
        for (const ShadowCost& cost : costs.ways)
            if (marchesCones(cost.way.model)) epsilons.insert(cost.way.epsilon);
        for (const double epsilon : epsilons)
            for (const ConeOrigin coneOrigin : {ConeOrigin::Surface, ConeOrigin::Light}) {
                std::vector<Cell> row{costs.scene, costs.radius, epsilon, nameOf(coneOrigin)};
                bool any = false;
                for (const ShadowModel model : kVariants) {
                    const ShadowCost* cost = find(costs, {model, coneOrigin, epsilon});
                    row.emplace_back();
                    if (cost && !cost->seconds.empty()) row.back() = ratioOf(cost->seconds, costs.bare).median;
                    any |= cost != nullptr;
                }
                if (any) table.rows.push_back(std::move(row));
            }
    }
    return table;
}

Table rivalTable(const std::vector<ShadowCosts>& all) {
    Table table{"rivals", "Against the linear variant at epsilon 1/30, cones from the surface", {}, {}, 3};
    table.columns = {{"scene", "scene", "", ""},
                     {"radius", "light radius", "scene units", ""},
                     {"way", "way", "", "Model with epsilon and cone origin, or samples"},
                     {"time", "frame time", "linear = 1", "In the same round: median"},
                     {"rmse", "error", "linear = 1", "Of the light fraction: root of the mean square"},
                     {"picture", "error of the picture", "linear = 1", "Root of the mean square of the linear colours"},
                     {"evaluations", "evaluations", "linear = 1", "Of distances"},
                     {"front", "front", "", "No other way is both faster and nearer to the reference"}};
    for (const ShadowCosts& costs : all) {
        const ShadowCost* linear = find(costs, {ShadowModel::ConeLinear, ConeOrigin::Surface, kLinearEpsilon});
        if (!linear || linear->seconds.empty()) continue;
        const auto add = [&](const ShadowCost* cost) {
            if (!cost) return;
            std::vector<Cell> row{costs.scene, costs.radius, nameOf(cost->way)};
            row.insert(row.end(),
                       {ratioOf(cost->seconds, linear->seconds).median, cost->visibility.rmse / linear->visibility.rmse,
                        cost->picture.rmse / linear->picture.rmse, cost->evaluations / linear->evaluations});
            row.emplace_back(cost->front ? "yes" : "no");
            table.rows.push_back(std::move(row));
        };
        add(find(costs, {ShadowModel::Silhouette}));
        for (const ShadowRow& row : kShadowModels) {
            if (!takesSamples(row.model)) continue;
            const ShadowCost* inTime = nearestWithin(costs, row.model, timeOf, timeOf(*linear));
            add(inTime);
            if (!row.distances) continue;
            const ShadowCost* inWork = nearestWithin(costs, row.model, evaluationsOf, linear->evaluations);
            if (inWork != inTime) add(inWork);
        }
        add(find(costs, {ShadowModel::ConeBase, ConeOrigin::Surface, kLinearEpsilon}));
        add(find(costs, {ShadowModel::ConeConvex, ConeOrigin::Surface, kLinearEpsilon}));
        add(find(costs, {ShadowModel::Quilez}));
    }
    return table;
}

std::vector<Chart> shadowCharts(const std::vector<ShadowCosts>& all) {
    std::set<std::string> scenes;
    std::set<double> radii;
    for (const ShadowCosts& costs : all) {
        scenes.insert(costs.scene);
        radii.insert(costs.radius);
    }
    const Chart plane{
        "Speed against error", "shadows", "ratio", {{"rmse", ""}}, "model", "scene", {}, true, true, "front"};
    std::vector<Chart> charts;
    if (all.size() == scenes.size()) { // one light each
        charts.push_back(plane);
        radii.clear();
    }
    for (const double radius : radii) {
        charts.push_back(plane);
        charts.back().where = {{"radius", toString(radius)}};
        charts.back().title += ", light radius " + toString(radius);
    }
    charts.push_back({"Frame time over epsilon, linear variant, for each light radius",
                      "shadows",
                      "epsilon",
                      {{"ratio", ""}},
                      "radius",
                      "scene",
                      {{"model", "cone-linear"}, {"cone_origin", "surface"}},
                      true,
                      false});
    return charts;
}

void addShadowPictures(const std::vector<ShadowCosts>& all, const std::string& reference, Results& results) {
    for (const ShadowCosts& costs : all)
        for (const ShadowCost& cost : costs.ways)
            addPicture({costs.scene + ", " + nameOf(cost.way), "shadows", keysOf(costs, cost.way), 0, {}, reference},
                       cost.image, costs.reference, results);
}

} // namespace gnomon
