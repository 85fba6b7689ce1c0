#include "tracer/plan/plan.h"

#include "tracer/plan/scene_offsets.h"
#include "tracer/plan/search_choice.h"

#include <algorithm>

namespace gnomon {
namespace {

void addMaterial(const Material& material, const TextureSet& textureSet, const Settings& settings,
                 SceneFeatures& features) {
    features.coats |= std::holds_alternative<Coat>(material.optics);
    features.conductors |= std::holds_alternative<Conductor>(material.optics);
    features.mirrors |= std::holds_alternative<Mirror>(material.optics);
    features.refraction |= material.refracts();
    features.checkers |= material.checker.has_value();
    if (textureSet.paintOf(material) >= 0) features.paints = int(textureSet.paints.size());
    if (material.normalMap && settings.normalMaps) features.normalMaps = int(textureSet.normals.size());
}

/// Of those materials that objects are of.
void addMaterials(const PreparedScene& prepared, const Settings& settings, SceneFeatures& features) {
    const Scene& scene = prepared.scene;
    std::vector<bool> used(scene.materials.size(), false);
    for (const Object& object : scene.objects) used[std::size_t(object.material)] = true;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) addMaterial(scene.materials[i], prepared.textureSet, settings, features);
    features.reflection = reflects(features);
    features.exactFresnel = features.reflection && scene.fresnel == Fresnel::Exact;
}

void addMedia(const PreparedScene& prepared, SceneFeatures& features) {
    features.passesOn = features.reflection && prepared.scene.depthLimit == DepthLimit::Straight;
    if (!prepared.media.tracked) return;
    features.media = int(prepared.media.materials.size()) - 1;
    features.absorption = prepared.media.absorbing;
}

void addLight(const Scene& scene, const Settings& settings, SceneFeatures& features) {
    features.lights = int(scene.lights.size());
    for (const Light& light : scene.lights) {
        features.directional |= light.kind == LightKind::Directional;
        features.lightProfiles |= light.kind == LightKind::Spot || light.falloff > 0;
    }
    const auto count = [&](auto which) { return std::count_if(scene.objects.begin(), scene.objects.end(), which); };
    const bool nets = count([](const Object& o) { return o.shape.net != nullptr; }) > 0; // whose distance none knows
    const ShadowRow& asked = shadowRow(settings.shadows);
    const bool served = (asked.parallel || !features.directional) && !(asked.distances && nets);
    features.shadows = features.lights == 0 ? ShadowModel::Off : served ? settings.shadows : ShadowModel::Hard;
    // What comes from infinity has no start to march from.
    features.fromLight =
        features.shadows != ShadowModel::Off && settings.coneOrigin == ConeOrigin::Light && !features.directional;
    if (settings.glow) features.glows = int(count([](const Object& o) { return o.glow.has_value(); }));
}

/// Fields are baked where rays go through them and where models ask for distances. A GL that cannot draw floats has
/// none.
void addFields(const Scene& scene, const Settings& settings, const CodegenTarget& target, SceneFeatures& features) {
    if (!hasSurfaces(scene)) return;
    if (!target.floatTargets && shadowRow(features.shadows).distances) {
        features.shadows = ShadowModel::Hard;
        features.fromLight = false;
    }
    features.surfaceInField = settings.surface == SurfaceMode::Field && target.floatTargets;
    features.fields = features.surfaceInField || shadowRow(features.shadows).distances;
    if (features.surfaceInField) features.fieldMarch = settings.fieldMarch;
}

/// Grids have long lists: they are for what lies in a texture. Searches by distance know none.
void chooseData(const PreparedScene& prepared, const Settings& settings, const CodegenTarget& target,
                SceneFeatures& features) {
    const bool blockIsBest = settings.data == DataPath::Auto && !target.textureBest;
    const bool mayBeBlock = blockIsBest || settings.data == DataPath::Block;
    features.shapes = countKinds(prepared, settings.accel, !mayBeBlock && !features.distances);
    features.dataBlock =
        settings.data == DataPath::Block || (blockIsBest && sceneTexels(features) <= target.blockTexels);
    if (mayBeBlock && !features.dataBlock && !features.distances)
        features.shapes = countKinds(prepared, settings.accel, true);
}

} // namespace

bool hasSurfaces(const Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [](const Object& o) { return o.shape.kind == ShapeKind::HeightPatch; });
}

Plan planOf(const PreparedScene& prepared, const Settings& settings, const CodegenTarget& target) {
    Plan plan{{}, target, {}};
    SceneFeatures& features = plan.scene;
    features.output = settings.aov;
    features.march = settings.march;
    features.linear = prepared.scene.encoding == Encoding::Linear;
    features.cubemap = !prepared.skyFaces.empty();
    features.panorama = !prepared.scene.background.image.empty();
    features.gradient = prepared.scene.background.gradient.has_value();
    features.materials = int(prepared.scene.materials.size());
    addMaterials(prepared, settings, features);
    addMedia(prepared, features);
    addLight(prepared.scene, settings, features);
    addFields(prepared.scene, settings, target, features);
    const std::vector<Object>& objects = prepared.scene.objects;
    const bool solids = std::any_of(objects.begin(), objects.end(), [](const Object& o) { return o.shape.solid; });
    features.distances = solids || shadowRow(features.shadows).distances;
    chooseData(prepared, settings, target, features);
    return plan;
}

namespace {

bool alike(Effect effect, const Settings& a, const Settings& b) {
    const auto rows = settingsTable();
    return std::all_of(rows.begin(), rows.end(), [&](const SettingRow& row) {
        return row.effect != effect || textOf(row, a) == textOf(row, b);
    });
}

} // namespace

bool planAlike(const Settings& a, const Settings& b) { return alike(Effect::Rebuild, a, b); }
bool bakesAlike(const Settings& a, const Settings& b) { return alike(Effect::Bake, a, b); }

Plan sourceKeyOf(Plan plan) {
    const ScreenSplit split = plan.split;
    plan.split = split.fallback ? split : ScreenSplit{.tile = split.tile, .coverageMask = split.coverageMask};
    const CodegenTarget gpu;
    plan.target.blockTexels = gpu.blockTexels;
    plan.target.textureBest = gpu.textureBest;
    plan.target.split = gpu.split;
    plan.target.fallback = gpu.fallback;
    plan.target.tile = gpu.tile;
    return plan;
}

} // namespace gnomon
