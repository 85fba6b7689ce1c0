#include "tracer/shader/features.h"

#include "tracer/accel/hierarchy.h"
#include "tracer/render/scene_data.h"

#include <algorithm>

namespace gnomon {
namespace {

/// Of asking an object, in boxes.
constexpr double kPrimitiveCost = 1;

/// Entries of the stack for trees of that depth. The depth itself stays a uniform; two sizes, since a GPU holds the
/// stack in registers of every pixel (docs/results.md), and a shader for each depth would compile at every press of a
/// key.
int stackFor(int depth) { return depth <= 4 ? 3 : 7; }

std::vector<KindCount> countKinds(const Scene& scene) {
    std::array<KindCount, kShapeKinds> counts{};
    const std::vector<ShapeKind> kinds = drawnKinds(scene);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        KindCount& kind = counts[std::size_t(kinds[i])];
        kind.kind = kinds[i];
        ++kind.count;
        kind.casters += scene.objects[i].castsShadow;
    }
    std::vector<KindCount> present;
    std::copy_if(counts.begin(), counts.end(), std::back_inserter(present),
                 [](const KindCount& kind) { return kind.count > 0; });
    return present;
}

/// A hierarchy for each kind where it pays: a loop asks every object, a hierarchy some boxes and then few objects.
void chooseHierarchies(const Scene& scene, Accel accel, std::vector<KindCount>& kinds) {
    const std::vector<ShapeKind> drawn = drawnKinds(scene);
    const std::vector<Shape> shapes = shapesAt(scene, 0);
    for (KindCount& kind : kinds) {
        const ShapeRow& row = shapeRow(kind.kind);
        if (!row.extent || kind.count < 2) continue;
        std::vector<Bounds> bounds;
        for (std::size_t i = 0; i < shapes.size(); ++i)
            if (drawn[i] == kind.kind) bounds.push_back(*boundsOf(shapes[i]));
        const Hierarchy hierarchy = build(bounds);
        const double walk = hierarchy.cost() + kPrimitiveCost * hierarchy.leaves();
        kind.hierarchy = accel == Accel::Hierarchy || walk < kPrimitiveCost * kind.count;
    }
}

void addSlot(const std::string& image, const std::vector<std::string>& images, std::vector<int>& slots) {
    const int slot = int(std::find(images.begin(), images.end(), image) - images.begin());
    if (std::find(slots.begin(), slots.end(), slot) == slots.end()) slots.push_back(slot);
}

void addMaterial(const Material& material, const std::vector<std::string>& images, const Settings& settings,
                 Features& features) {
    const auto* coat = std::get_if<Coat>(&material.optics);
    features.coats |= coat != nullptr;
    features.conductors |= std::holds_alternative<Conductor>(material.optics);
    features.refraction |= std::holds_alternative<Dielectric>(material.optics);
    if (coat && !coat->mask.empty()) addSlot(coat->mask, images, features.maskSlots);
    if (material.texture) addSlot(material.texture->image, images, features.colorSlots);
    if (material.normalMap && settings.normalMaps) addSlot(material.normalMap->image, images, features.normalSlots);
}

} // namespace

int Features::objects() const {
    int sum = 0;
    for (const KindCount& kind : shapes) sum += kind.count;
    return sum;
}

Features featuresOf(const Scene& scene, const Settings& settings, int maxBlockTexels, bool es300) {
    Features features;
    features.shapes = countKinds(scene);
    if (settings.accel != Accel::None) chooseHierarchies(scene, settings.accel, features.shapes);
    features.output = settings.aov;
    features.es300 = es300;
    features.linear = scene.encoding == Encoding::Linear;
    features.materials = int(scene.materials.size());
    features.lights = int(scene.lights.size());
    const std::vector<std::string> images = imageSlots(scene);
    features.images = int(images.size());
    std::vector<bool> used(scene.materials.size(), false);
    for (const Object& object : scene.objects) used[object.material] = true;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) addMaterial(scene.materials[i], images, settings, features);
    features.reflection = features.conductors || features.refraction || features.coats;
    features.rayStack = features.refraction ? stackFor(settings.depth) : 0;
    features.cubemap = !scene.background.cubemap.empty();
    features.shadows = features.lights > 0 ? settings.shadows : ShadowModel::Off;
    if (settings.glow)
        features.glows = int(std::count_if(scene.objects.begin(), scene.objects.end(),
                                           [](const Object& o) { return o.glow.has_value(); }));
    features.dataBlock = settings.data == DataPath::Block ||
                         (settings.data == DataPath::Auto && sceneTexels(features) <= maxBlockTexels);
    return features;
}

} // namespace gnomon
