/// The measurements of `gnomon lab shadows`: what a shadow model costs and how wrong the light fraction is.
#pragma once

#include "lab/bench/benchmark_case.h"
#include "tracer/settings/settings.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gnomon {

/// A shadow model with what it depends on.
struct ShadowWay {
    ShadowModel model = ShadowModel::Off;
    ConeOrigin coneOrigin = ConeOrigin::Surface;
    double epsilon = 1.0 / 30;
    int samples = 64;
};
/// Whether the model has an epsilon and a cone origin, or samples.
bool marchesCones(ShadowModel);
bool takesSamples(ShadowModel);

/// Differences from the reference over the pixels that see a surface.
struct Errors {
    double rmse = 0, mean = 0, most999 = 0, most = 0; ///< most999: 99.9 % are below
};
Errors errorsOf(std::vector<double> differences);

struct ShadowCost {
    ShadowWay way;
    std::vector<double> seconds;      ///< a frame in each round
    double evaluations = 0;           ///< of distances, a pixel, for shadows alone
    std::optional<double> shadowRays; ///< a pixel, of models that shoot them
    Errors visibility, picture;
    bool front = false; ///< no other way is both faster and nearer to the reference
    Image image;        ///< where the plan asks for pictures
};

/// One scene under lights of one radius.
struct ShadowCosts {
    std::string scene;
    double radius = 0;
    std::vector<double> bare; ///< seconds of a frame without shadows, in each round
    std::vector<ShadowCost> ways;
    Image reference; ///< where the plan asks for pictures
};

struct ShadowPlan {
    glm::ivec2 size{160, 120};
    int rounds = 5, reference = 4096; ///< samples
    std::vector<double> radii;        ///< empty: the scene's own
    std::vector<double> epsilons{1.0 / 10, 1.0 / 30, 1.0 / 256};
    std::vector<int> samples{1, 4, 16, 64};
    std::vector<ShadowModel> models; ///< off and hard aside
    bool bothOrigins = true;
    std::optional<CameraPose> camera;     ///< instead of the scene's
    std::optional<glm::ivec2> pictures{}; ///< their size
};

/// As the laboratory draws a way; the scene's own radii where none is given.
Settings settingsFor(const ShadowPlan&, const ShadowWay&, std::optional<double> radius);
std::vector<ShadowWay> waysOf(const ShadowPlan&);
/// For LabProgress: frames drawn, references and read-backs.
std::size_t stepsOf(const ShadowPlan&);

/// Ways and references under every radius of one scene.
std::size_t picturesOf(const ShadowPlan&);

/// A scene under each radius. Less where the user wants no more; problems where GL cannot.
std::vector<ShadowCosts> measureShadows(const Loaded&, const ShadowPlan&, double (*clock)(), LabProgress&, Problems&);

} // namespace gnomon
