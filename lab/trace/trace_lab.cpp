#include "lab/trace/trace_lab.h"

#include "lab/reference/textbook/source_scene.h"
#include "lab/reference/textbook/textbook.h"
#include "tracer/clock.h"
#include "tracer/plan/scene_offsets.h"
#include "tracer/plan/scene_packer.h"
#include "tracer/shader/program_cache.h"
#include "tracer/software/tuning.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>

namespace gnomon {
namespace {

constexpr std::array kSceneWays{TraceWay{Accel::None, DataPath::Block},
                                TraceWay{Accel::Hierarchy, DataPath::Block},
                                TraceWay{Accel::Auto, DataPath::Block},
                                TraceWay{Accel::None, DataPath::Texture},
                                TraceWay{Accel::Hierarchy, DataPath::Texture},
                                TraceWay{Accel::Auto, DataPath::Texture},
                                TraceWay{.data = DataPath::Texture, .variants = true},
                                TraceWay{.accel = Accel::None, .source = true}};

constexpr double kFrameSeconds = 1.0 / 60;

/// Without the plain loop where it takes too long.
std::vector<TraceWay> waysFor(int spheres) {
    std::vector<TraceWay> ways{{Accel::Hierarchy, DataPath::Texture}, {Accel::Auto, DataPath::Texture}};
    if (spheres <= kMostLooped) ways.insert(ways.begin(), {Accel::None, DataPath::Texture});
    return ways;
}

/// Beside the scene's own camera.
struct FurtherView {
    const char *scene, *name;
    glm::dvec3 eye, target;
};
constexpr std::array kFurtherViews{FurtherView{"pro", "over the balls", {0, 6, 24}, {0, -7, 12}},
                                   FurtherView{"pro", "glass cube", {16, 3, 14}, {8, 0, 0}}};

/// Numbers of spheres in the scenes, which of a lattice may be the same for several `counts`.
std::vector<int> numbersOf(Arrangement arrangement, std::vector<int> counts) {
    for (int& count : counts) count = spheresIn(arrangement, count);
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    return counts;
}

struct NamedView {
    std::string name;
    View view;
};

std::vector<NamedView> viewsOf(const Scene& scene, glm::ivec2 size) {
    std::vector<NamedView> views{{scene.name, {scene.camera, 0, size.x, size.y}}};
    for (const FurtherView& further : kFurtherViews)
        if (scene.name == further.scene) {
            CameraPose camera = scene.camera;
            camera.eye = further.eye;
            camera.target = further.target;
            views.push_back({scene.name + ", " + further.name, {camera, 0, size.x, size.y}});
        }
    return views;
}

std::string latticeText(glm::ivec3 size) {
    return "lattice " + std::to_string(size.x) + "x" + std::to_string(size.y) + "x" + std::to_string(size.z);
}

/// Kinds that are asked one by one go without saying.
std::string searchOf(const SceneFeatures& features) {
    constexpr std::array names{"loop", "bounding-sphere mask", "hierarchy", "uniform grid"}; // as Search
    std::string text;
    for (const KindCount& kind : features.shapes) {
        if (kind.latticeMembers() == 0 && kind.search == Search::Loop) continue;
        text += (text.empty() ? "" : "; ") + std::string(shapeRow(kind.kind).key) + ": ";
        if (kind.latticeMembers() > 0) text += latticeText(kind.lattice) + (kind.loose() > 0 ? ", " : "");
        if (kind.loose() > 0) text += names[std::size_t(kind.search)];
    }
    return text.empty() ? "loop" : text;
}

/// Median milliseconds of one core for `work`, often enough for the clock.
double millisecondsOf(int rounds, const std::function<void()>& work) {
    std::vector<double> all;
    for (int round = 0; round < rounds; ++round) {
        const double start = processSeconds();
        int times = 0;
        while (processSeconds() - start < 1e-3 || times == 0) {
            work();
            ++times;
        }
        all.push_back(1e3 * (processSeconds() - start) / times);
    }
    return quartilesOf(all).median;
}

} // namespace

std::string nameOf(const TraceWay& way) {
    if (way.source) return "source";
    if (way.variants) return "variants";
    return way.accel == Accel::None ? "none" : way.accel == Accel::Hierarchy ? "hierarchy" : "auto";
}

std::string dataOf(const TraceWay& way) { return way.data == DataPath::Block ? "block" : "texture"; }

TraceLab::TraceLab(const Settings& settings, int rounds, double (*clock)(), std::optional<glm::ivec2> pictures)
    : settings_(settings), rounds_(rounds), clock_(clock), pictures_(pictures) {}

std::size_t TraceLab::picturesOf(const Scene& scene) { return kSceneWays.size() * viewsOf(scene, {1, 1}).size(); }

std::size_t TraceLab::picturesOf(Arrangement arrangement, const std::vector<int>& counts) {
    std::size_t all = 0;
    for (const int number : numbersOf(arrangement, counts)) all += waysFor(number).size();
    return all;
}

Settings TraceLab::settingsFor(const TraceWay& way) const {
    Settings settings = settings_;
    settings.accel = way.accel;
    settings.data = way.data;
    settings.variants = way.variants ? Variants::On : Variants::Off;
    return settings;
}

Plan TraceLab::planFor(const PreparedScene& scene, const TraceWay& way) const {
    return planOf(scene, settingsFor(way), targetOf(info_));
}

bool TraceLab::fits(const Scene& scene, const TraceWay& way) const {
    return way.data == DataPath::Texture ||
           sceneTexels(planFor(*gnomon::prepare(scene), way).scene) <= targetOf(info_).blockTexels;
}

std::size_t TraceLab::stepsOf(const Scene& scene) const {
    return kSceneWays.size() * (1 + viewsOf(scene, settings_.size).size() * std::size_t(rounds_ + 1));
}

std::size_t TraceLab::stepsOf(Arrangement arrangement, const std::vector<int>& counts) const {
    return picturesOf(arrangement, counts) * std::size_t(rounds_ + 2);
}

std::optional<TraceLab::Prepared> TraceLab::prepare(const Scene& scene, const NamedImages& images, const TraceWay& way,
                                                    std::span<const View> views, Problems& problems) const {
    const auto overrides = way.source ? sourceShaders() : std::span<const ShaderFile>{};
    auto benchmarkCase = std::make_unique<BenchmarkCase>(scene, images, settingsFor(way), overrides, problems);
    if (!problems.empty()) return std::nullopt;
    const auto works = way.source ? std::nullopt : benchmarkCase->count(views, problems);
    if (!problems.empty()) return std::nullopt;
    TraceCost cost{way, {}, {}, benchmarkCase->program(), searchOf(planFor(*gnomon::prepare(scene), way).scene), {}};
    std::vector<TraceCost> costs(views.size(), cost);
    for (std::size_t i = 0; works && i < costs.size(); ++i) costs[i].work = (*works)[i];
    for (std::size_t i = 0; pictures_ && i < costs.size(); ++i) {
        View view = views[i];
        view.width = pictures_->x;
        view.height = pictures_->y;
        costs[i].image = benchmarkCase->picture(settingsFor(way), view, problems);
    }
    if (!problems.empty()) return std::nullopt;
    return Prepared{std::move(benchmarkCase), std::move(costs)};
}

std::vector<ViewCosts> TraceLab::measure(const Loaded& loaded, LabProgress& progress, Problems& problems) const {
    if (const std::string beyond = beyondSource(loaded.scene); !beyond.empty()) {
        problems.push_back({loaded.scene.file,
                            0,
                            {},
                            "the source's way of tracing knows no " + beyond,
                            "measure a scene without them"});
        return {};
    }
    const std::vector<NamedView> named = viewsOf(loaded.scene, settings_.size);
    std::vector<View> views;
    for (const NamedView& view : named) views.push_back(view.view);
    std::vector<Prepared> all;
    for (const TraceWay& way : kSceneWays) {
        const Scene scene = way.source ? sourceScene(loaded.scene) : loaded.scene;
        if (!fits(scene, way)) continue;
        auto prepared = prepare(scene, loaded.images, way, views, problems);
        if (!prepared) return {};
        all.push_back(std::move(*prepared));
        if (!progress.step()) return {};
    }
    std::vector<ViewCosts> costs;
    for (std::size_t i = 0; i < views.size() && !LabProgress::interrupted(); ++i) {
        std::vector<TimedCase> timed;
        for (const Prepared& one : all) timed.push_back({one.benchmarkCase.get(), views[i]});
        const auto times = timeInRounds(timed, rounds_, clock_, progress);
        if (times[0].empty()) break;
        costs.push_back({named[i].name, {}});
        for (std::size_t k = 0; k < all.size(); ++k) {
            costs.back().ways.push_back(all[k].costs[i]);
            costs.back().ways.back().seconds = times[k];
        }
    }
    return costs;
}

std::vector<GrowthCosts> TraceLab::measure(Arrangement arrangement, const std::vector<int>& counts,
                                           LabProgress& progress, Problems& problems) const {
    std::vector<Prepared> all;
    std::vector<TimedCase> timed;
    std::vector<GrowthCosts> growth;
    for (const int number : numbersOf(arrangement, counts)) {
        const Scene scene = sphereScene(arrangement, number);
        const View view{scene.camera, 0, settings_.size.x, settings_.size.y};
        growth.push_back({arrangement, number, {}});
        for (const TraceWay& way : waysFor(number)) {
            auto prepared = prepare(scene, {}, way, {&view, 1}, problems);
            if (!prepared) return {};
            growth.back().ways.push_back({prepared->costs[0], packMs(gnomon::prepare(scene), way), loadMs(scene, way)});
            timed.push_back({prepared->benchmarkCase.get(), view});
            all.push_back(std::move(*prepared));
            if (!progress.step()) return {};
        }
    }
    const auto times = timeInRounds(timed, rounds_, clock_, progress);
    if (times[0].empty()) return {};
    std::size_t next = 0;
    for (GrowthCosts& spheres : growth)
        for (GrowthCosts::Way& way : spheres.ways) way.cost.seconds = times[next++];
    return growth;
}

double TraceLab::packMs(const PreparedScenePtr& prepared, const TraceWay& way) const {
    const Plan plan = planFor(*prepared, way);
    const glm::dvec3 eye = prepared->scene.camera.eye;
    ScenePacker packer(prepared);
    double time = 0;
    packer.pack(plan, time, eye);
    return millisecondsOf(rounds_, [&] { packer.pack(plan, time += kFrameSeconds, eye); });
}

double TraceLab::loadMs(const Scene& scene, const TraceWay& way) const {
    return millisecondsOf(rounds_, [&] {
        const PreparedScenePtr prepared = gnomon::prepare(scene);
        ScenePacker(prepared).pack(planFor(*prepared, way), 0, scene.camera.eye);
    });
}

} // namespace gnomon
