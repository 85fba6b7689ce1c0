#include "tracer/software/uncommon_features.h"

#include "tracer/accel/bounds.h"
#include "tracer/plan/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace gnomon {
namespace {

/// Of the picture: what covers less is uncommon. Mirrors show it once more.
constexpr double kUncommon = 1.0 / 8;
/// Bounding spheres that the base variant tests one by one.
constexpr int kMostSpheres = 4;
constexpr double kAspect = 4.0 / 3; // of a usual canvas
/// Of more objects the screen is not partitioned: that would take its time each frame.
constexpr int kMostPartitioned = 1024;

/// The fraction of the picture that the bounding sphere of a shape takes, wherever the camera looks.
double coverOf(const Shape& shape, glm::dvec3 eye, double halfHeight) {
    const auto bounds = boundsOf(shape);
    if (!bounds) return 1;
    const glm::dvec3 low(bounds->low), high(bounds->high);
    const double radius = shape.kind == ShapeKind::Sphere ? lengthOf(shape, "radius") : 0.5 * glm::distance(low, high);
    const double distance = glm::distance(eye, 0.5 * (low + high));
    if (distance <= radius) return 1;
    const double tangent = radius / std::sqrt((distance - radius) * (distance + radius)) / halfHeight;
    return std::min(1.0, std::numbers::pi * tangent * tangent / (4 * kAspect));
}

/// Objects of a scene at rest, and how much of the picture each takes.
class Covers {
  public:
    explicit Covers(const PreparedScene& prepared) : scene_(prepared.scene) {
        const CameraFrame camera = frameOf(scene_.camera);
        for (const Shape& shape : prepared.shapes)
            covers_.push_back(coverOf(shape, camera.eye - prepared.origin, camera.halfHeight));
    }

    /// There are some, and together they take little.
    template<class Which>
    bool uncommon(const std::vector<int>& objects, Which which) const {
        double sum = 0;
        for (const int i : objects)
            if (which(scene_.materials[std::size_t(scene_.objects[std::size_t(i)].material)]))
                sum += covers_[std::size_t(i)];
        return sum > 0 && sum < kUncommon;
    }

  private:
    const Scene& scene_;
    std::vector<double> covers_;
};

void markUncommon(const PreparedScene& prepared, Plan& plan) {
    const Covers covers(prepared);
    std::vector<int> all(prepared.scene.objects.size());
    std::iota(all.begin(), all.end(), 0);
    const SceneFeatures& scene = plan.scene;
    ScreenSplit& split = plan.split;
    split.refraction = scene.refraction && covers.uncommon(all, [](const Material& m) { return m.refracts(); });
    split.normalMaps =
        scene.normalMaps > 0 && covers.uncommon(all, [](const Material& m) { return m.normalMap.has_value(); });
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
        const KindCount& kind = scene.shapes[k];
        const std::vector<int>& objects = prepared.layout[k].objects;
        const bool fewExpensive = shapeRow(kind.kind).expensive && kind.count <= kMostSpheres;
        split.kinds.push_back(
            {fewExpensive && covers.uncommon(objects, [](const Material&) { return true; }),
             kind.images && covers.uncommon(objects, [](const Material& m) { return m.showsImages(); })});
    }
}

} // namespace

Plan splitScreen(Plan plan, const PreparedScene& prepared, const Settings& settings) {
    const bool wanted = settings.variants == Variants::On || (settings.variants == Variants::Auto && plan.target.split);
    plan.split.on = wanted && plan.scene.output == Aov::Color && plan.scene.objects() <= kMostPartitioned;
    // Other shadows ask all casters at once.
    const bool rays = plan.scene.shadows == ShadowModel::Off || plan.scene.shadows == ShadowModel::Hard;
    if (plan.split.on && rays && plan.target.fallback) markUncommon(prepared, plan);
    if (plan.split.anyUncommon()) plan.split.tile = plan.target.tile;
    return plan;
}

Plan splitPlanOf(const PreparedScene& prepared, const Settings& settings, const CodegenTarget& target) {
    return splitScreen(planOf(prepared, settings, target), prepared, settings);
}

Plan baseOf(Plan plan) {
    SceneFeatures& scene = plan.scene;
    ScreenSplit& split = plan.split;
    if (!split.anyUncommon()) return plan;
    split.fallback = true;
    split.coverageMask = split.tile > 0;
    split.tile = 0;
    scene.refraction = scene.refraction && !split.refraction;
    scene.reflection = reflects(scene);
    scene.exactFresnel = scene.exactFresnel && scene.reflection;
    if (split.normalMaps) scene.normalMaps = 0;
    bool images = false;
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
        KindCount& kind = scene.shapes[k];
        kind.images = kind.images && !split.kind(k).images && !split.kind(k).shape;
        images |= kind.images;
    }
    if (!images) scene.paints = scene.normalMaps = 0;
    return plan;
}

Plan skyOf(Plan plan) {
    plan.split.coverageMask = plan.split.tile > 0;
    plan.split.tile = 0;
    return plan;
}

std::vector<ScreenBounds> screenBoundsOf(const PreparedScene& prepared, const Plan& plan,
                                         std::span<const Shape> shapes) {
    const Scene& scene = prepared.scene;
    std::vector<ScreenBounds> all;
    for (std::size_t k = 0; k < prepared.layout.size(); ++k)
        for (const int i : prepared.layout[k].objects) {
            const Shape& shape = shapes[std::size_t(i)];
            const Material& material = scene.materials[std::size_t(scene.objects[std::size_t(i)].material)];
            ScreenBounds bounds{{}, shape.kind == ShapeKind::Sphere, plan.split.fallsBack(k, material)};
            if (prepared.layout[k].kind != ShapeKind::LargeSphere) bounds.bounds = boundsOf(shape); // that has no end
            all.push_back(bounds);
        }
    return all;
}

} // namespace gnomon
