/// The measurements of `gnomon lab trace`: what finding objects costs, by accelerator and data path.
#pragma once

#include "lab/bench/benchmark_case.h"
#include "lab/trace/sphere_scenes.h"
#include "tracer/gl/gl.h"
#include "tracer/plan/plan.h"
#include "tracer/settings/settings.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

/// How rays find objects: as `--accel` and `--data` say, or as the source document did. By shader variants, or by one
/// program alone, so that accelerators differ in nothing else.
struct TraceWay {
    Accel accel = Accel::Auto;
    DataPath data = DataPath::Block;
    bool source = false, variants = false;

    bool operator==(const TraceWay&) const = default;
};
/// source, none, hierarchy, auto, variants; block, texture.
std::string nameOf(const TraceWay&);
std::string dataOf(const TraceWay&);

/// Of one picture drawn in one way.
struct TraceCost {
    TraceWay way;
    std::vector<double> seconds; ///< a frame in each round
    std::optional<Work> work;    ///< none of the source's way, which does not count
    ProgramStats program;
    std::string
        search;    ///< what the way came to: `sphere: lattice 5x5x4, bounding-sphere mask`; all else is a plain loop
    Image image{}; ///< where pictures are asked for
};

/// One picture, in all ways that can draw it.
struct ViewCosts {
    std::string view;
    std::vector<TraceCost> ways;
};

/// Spheres, in all ways that end in time; the numbers in a texture, which holds them all.
struct GrowthCosts {
    Arrangement arrangement = Arrangement::Random;
    int spheres = 0;
    struct Way {
        TraceCost cost;
        double packMs = 0; ///< a frame's numbers, at the next moment
        double loadMs = 0; ///< from the scene to the first frame's numbers
    };
    std::vector<Way> ways;
};
/// The plain loop is left out above that.
inline constexpr int kMostLooped = 1000;

class TraceLab {
  public:
    /// `settings` say size, depth and shadows. In the current context; `clock` counts the seconds of frames.
    /// Pictures of that size are drawn of every way.
    TraceLab(const Settings&, int rounds, double (*clock)(), std::optional<glm::ivec2> pictures);

    /// Views of a scene times the ways to draw it, numbers of spheres times theirs.
    static std::size_t picturesOf(const Scene&);
    static std::size_t picturesOf(Arrangement, const std::vector<int>& counts);

    /// For LabProgress: cases made and frames drawn.
    std::size_t stepsOf(const Scene&) const;
    std::size_t stepsOf(Arrangement, const std::vector<int>& counts) const;

    /// Each view of the scene. Fewer rounds or views where the user wants no more; problems where GL cannot.
    std::vector<ViewCosts> measure(const Loaded&, LabProgress&, Problems&) const;
    /// Spheres in rising numbers, all drawn in turn.
    std::vector<GrowthCosts> measure(Arrangement, const std::vector<int>& counts, LabProgress&, Problems&) const;

  private:
    /// Compiled, with what can be told before the first frame, for each view.
    struct Prepared {
        std::unique_ptr<BenchmarkCase> benchmarkCase;
        std::vector<TraceCost> costs;
    };
    std::optional<Prepared> prepare(const Scene&, const NamedImages&, const TraceWay&, std::span<const View>,
                                    Problems&) const;
    Settings settingsFor(const TraceWay&) const;
    Plan planFor(const PreparedScene&, const TraceWay&) const;
    bool fits(const Scene&, const TraceWay&) const;
    double packMs(const PreparedScenePtr&, const TraceWay&) const;
    double loadMs(const Scene&, const TraceWay&) const;

    gl::Info info_ = gl::info();
    Settings settings_;
    int rounds_;
    double (*clock_)();
    std::optional<glm::ivec2> pictures_;
};

} // namespace gnomon
