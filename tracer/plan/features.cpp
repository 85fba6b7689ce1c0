#include "tracer/plan/features.h"

#include "tracer/accel/hierarchy.h"
#include "tracer/plan/layout.h"
#include "tracer/plan/scene_packer.h"
#include "tracer/software/uncommon_features.h"
#include "tracer/shader/solid_source.h"

#include <algorithm>

namespace gnomon {
namespace {

/// Of asking an object, and its ball, in boxes.
constexpr double kObjectCost = 2;
constexpr double kBallCost = 0.3;
/// Of a turn in a walk through cells, which reads a list and a ball; measured 1.5 to 2.1 in clouds of 100 to 10 000.
constexpr double kGridStepCost = 1.75;
/// Of more objects the picture is not looked through for what it may show where: that would take its time each frame.
constexpr int kMostParted = 1024;
/// Pixels: what SwiftShader draws at a time. In squares of 4 `pro` takes 1.04 times as long, of 8 1.12 (320x240).
constexpr int kTile = 2;
/// Bits of the sieve.
constexpr int kMostMasked = 24;

/// The objects that make no block, and what a search takes a ray to find them, in boxes: the objects that it asks, and
/// what leads to them.
struct Loose {
    Hierarchy hierarchy;
    std::optional<GridPlan> cells; ///< where those may be searched
    int objects = 0;

    double cost(Search search) const {
        const double asked = kObjectCost * hierarchy.fallsBack();
        switch (search) {
        case Search::Loop: return kObjectCost * objects;
        case Search::SphereMask: return kBallCost * objects + asked;
        case Search::Grid: return kGridStepCost * cells->iterations + asked;
        case Search::Hierarchy: break;
        }
        return hierarchy.cost() + asked;
    }
};

/// Chooses the search for the objects that make no block.
void chooseSearch(const KindLayout& layout, const std::vector<Shape>& shapes, Accel accel, bool cells,
                  KindCount& kind) {
    const int latticeMembers = kind.latticeMembers();
    Loose loose;
    loose.objects = int(layout.objects.size()) - latticeMembers;
    if (!shapeRow(layout.kind).extent || loose.objects < (latticeMembers > 0 ? 1 : 2)) return;
    if (accel == Accel::Hierarchy) {
        kind.search = Search::Hierarchy;
        return;
    }
    std::vector<Bounds> bounds;
    for (auto i = layout.objects.begin() + latticeMembers; i != layout.objects.end(); ++i)
        bounds.push_back(*boundsOf(shapes[std::size_t(*i)]));
    loose.hierarchy = build(bounds);
    std::vector<Search> possible{Search::Hierarchy};
    if (loose.objects <= kMostMasked) possible.push_back(Search::SphereMask);
    if (latticeMembers == 0) possible.push_back(Search::Loop);
    if (cells) loose.cells = planGrid(bounds);
    if (loose.cells) possible.push_back(Search::Grid);
    kind.search = *std::min_element(possible.begin(), possible.end(),
                                    [&](Search a, Search b) { return loose.cost(a) < loose.cost(b); });
    if (kind.search == Search::Grid) kind.grid = *loose.cells;
}

/// `cells`: grids are worth considering.
std::vector<KindCount> countKinds(const Scene& scene, Accel accel, bool cells) {
    std::vector<Shape> shapes = shapesAt(scene, 0);
    const glm::dvec3 origin = originOf(scene);
    for (Shape& shape : shapes) shape = translated(shape, -origin);
    std::vector<KindCount> kinds;
    int forms = 0;
    for (const KindLayout& layout : layoutOf(scene)) {
        KindCount kind{layout.kind, int(layout.objects.size()), layout.casters};
        kind.solid = layout.solid;
        if (kind.solid) kind.form = forms++;
        kind.images = std::any_of(layout.objects.begin(), layout.objects.end(), [&](int i) {
            return scene.materials[std::size_t(scene.objects[std::size_t(i)].material)].showsImages();
        });
        if (accel != Accel::None) {
            if (accel != Accel::Hierarchy) kind.lattice = layout.lattice;
            chooseSearch(layout, shapes, accel, cells, kind);
        }
        kinds.push_back(kind);
    }
    return kinds;
}

void addMaterial(const Material& material, const TextureSet& textureSet, const Settings& settings, Features& features) {
    features.coats |= std::holds_alternative<Coat>(material.optics);
    features.conductors |= std::holds_alternative<Conductor>(material.optics);
    features.refraction |= std::holds_alternative<Dielectric>(material.optics);
    if (textureSet.paintOf(material) >= 0) features.paints = int(textureSet.paints.size());
    if (material.normalMap && settings.normalMaps) features.normalMaps = int(textureSet.normals.size());
}

} // namespace

std::string KindCount::type() const { return std::string(shapeRow(kind).type) + (solid ? std::to_string(form) : ""); }

int KindCount::texels() const { return solid ? texelsOf(*solid) : shapeRow(kind).texels; }

int Features::objects() const {
    int sum = 0;
    for (const KindCount& kind : shapes) sum += kind.count;
    return sum;
}

Features featuresOf(const Scene& scene, const Settings& settings, const GlslTarget& target) {
    Features features;
    features.output = settings.aov;
    features.es300 = target.es300;
    features.floatTargets = target.floatTargets;
    features.iterationsCounted = !target.processor;
    features.preloads = target.processor && !target.swiftShader;
    features.cachedLoads = target.swiftShader;
    features.linear = scene.encoding == Encoding::Linear;
    features.materials = int(scene.materials.size());
    features.lights = int(scene.lights.size());
    const TextureSet textureSet = textureSetOf(scene);
    std::vector<bool> used(scene.materials.size(), false);
    for (const Object& object : scene.objects) used[object.material] = true;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) addMaterial(scene.materials[i], textureSet, settings, features);
    features.reflection = features.conductors || features.refraction || features.coats;
    features.cubemap = !scene.background.cubemap.empty();
    features.shadows = features.lights > 0 ? settings.shadows : ShadowModel::Off;
    features.fromLight = features.shadows != ShadowModel::Off && settings.coneOrigin == ConeOrigin::Light;
    features.march = settings.march;
    const bool solids = std::any_of(scene.objects.begin(), scene.objects.end(),
                                    [](const Object& object) { return object.shape.solid != nullptr; });
    features.distances = solids || shadowRow(features.shadows).distances;
    // Grids have long lists: they are for what lies in a texture. Searches by distance know none.
    const bool blockIsBest = settings.data == DataPath::Auto && !target.processor;
    const bool mayBeBlock = blockIsBest || settings.data == DataPath::Block;
    features.shapes = countKinds(scene, settings.accel, !mayBeBlock && !features.distances);
    if (settings.glow)
        features.glows = int(std::count_if(scene.objects.begin(), scene.objects.end(),
                                           [](const Object& o) { return o.glow.has_value(); }));
    features.dataBlock =
        settings.data == DataPath::Block || (blockIsBest && sceneTexels(features) <= target.blockTexels);
    if (mayBeBlock && !features.dataBlock && !features.distances)
        features.shapes = countKinds(scene, settings.accel, true);
    features.parted = features.output == Aov::Color && features.objects() <= kMostParted &&
                      (settings.parts == Parts::On || (settings.parts == Parts::Auto && target.processor));
    // Other shadows ask all casters at once.
    const bool rays = features.shadows == ShadowModel::Off || features.shadows == ShadowModel::Hard;
    const bool tiles = target.swiftShader && kTile <= target.mostPoint, depths = !target.swiftShader;
    if (features.parted && rays && (tiles || depths)) markUncommon(scene, features);
    if (tiles && anyUncommon(features)) features.tile = kTile;
    return features;
}

} // namespace gnomon
