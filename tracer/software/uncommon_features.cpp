#include "tracer/software/uncommon_features.h"

#include "tracer/accel/bounds.h"
#include "tracer/plan/layout.h"
#include "tracer/plan/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gnomon {
namespace {

/// Of the picture: what covers less is rare. Mirrors show it once more.
constexpr double kUncommon = 1.0 / 8;
/// Balls that the usual program tests one by one.
constexpr int kMostBalls = 4;
constexpr double kAspect = 4.0 / 3; // of a usual canvas

/// The share of the picture that the ball about a shape takes, wherever the camera looks.
double coverOf(const Shape& shape, const CameraFrame& camera) {
    const auto bounds = boundsOf(shape);
    if (!bounds) return 1;
    const glm::dvec3 low(bounds->low), high(bounds->high);
    const double radius = shape.kind == ShapeKind::Sphere ? lengthOf(shape, "radius") : 0.5 * glm::distance(low, high);
    const double away = glm::distance(camera.eye, 0.5 * (low + high));
    if (away <= radius) return 1;
    const double tangent = radius / std::sqrt((away - radius) * (away + radius)) / camera.halfHeight;
    return std::min(1.0, std::numbers::pi * tangent * tangent / (4 * kAspect));
}

/// Objects of a scene as they rest, and how much of the picture each takes.
class Covers {
  public:
    explicit Covers(const Scene& scene) : scene_(scene) {
        const CameraFrame camera = frameOf(scene.camera);
        for (const Shape& shape : shapesAt(scene, 0)) covers_.push_back(coverOf(shape, camera));
    }

    /// There are some, and together they take little.
    bool uncommon(const std::vector<int>& objects, bool (*which)(const Material&)) const {
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

bool refracts(const Material& material) { return std::holds_alternative<Dielectric>(material.optics); }

} // namespace

void markUncommon(const Scene& scene, Features& features) {
    const std::vector<KindLayout> layout = layoutOf(scene);
    const Covers covers(scene);
    std::vector<int> all;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) all.push_back(int(i));
    features.refractionUncommon = features.refraction && covers.uncommon(all, refracts);
    features.normalMapsUncommon =
        features.normalMaps > 0 && covers.uncommon(all, [](const Material& m) { return m.normalMap.has_value(); });
    for (std::size_t k = 0; k < layout.size(); ++k) {
        KindCount& kind = features.shapes[k];
        kind.imagesUncommon =
            kind.images && covers.uncommon(layout[k].objects, [](const Material& m) { return m.showsImages(); });
        kind.uncommon = shapeRow(kind.kind).expensive && kind.count <= kMostBalls &&
                    covers.uncommon(layout[k].objects, [](const Material&) { return true; });
    }
}

bool anyUncommon(const Features& features) {
    return features.refractionUncommon || features.normalMapsUncommon ||
           std::any_of(features.shapes.begin(), features.shapes.end(),
                       [](const KindCount& kind) { return kind.uncommon || kind.imagesUncommon; });
}

Features baseOf(Features features) {
    features.fallsBack = true;
    features.tile = 0;
    features.refraction = features.refraction && !features.refractionUncommon;
    features.reflection = features.conductors || features.coats || features.refraction;
    if (features.normalMapsUncommon) features.normalMaps = 0;
    bool images = false;
    for (KindCount& kind : features.shapes) {
        kind.images = kind.images && !kind.imagesUncommon && !kind.uncommon;
        images |= kind.images;
    }
    if (!images) features.paints = features.normalMaps = 0;
    return features;
}

bool fallsBack(const Features& features, const KindCount& kind, const Material& material) {
    return kind.uncommon || (features.refractionUncommon && refracts(material)) ||
           (features.normalMapsUncommon && material.normalMap) || (kind.imagesUncommon && material.showsImages());
}

} // namespace gnomon
