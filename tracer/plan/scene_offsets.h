/// Where the scene's values lie among its texels: one description for who packs them (scene_packer.h) and for the
/// shader that reads them (tracer/shader/scene_constants.h). Pure values, no names.
///
/// Order: for each kind present the geometry of its objects, then the searches of the kinds that have one, then one
/// texel for each object (material, index in the file, whether the base variant discards it), then materials, lights,
/// glows, and what only some scenes know of their materials and lights: complex refractive indices; where media are
/// tracked, one texel for each: air, then the bodies by their ranks, then the ranks of those that the eye is inside of;
/// checkers; profiles; the background's gradient.
#pragma once

#include "tracer/plan/scene_features.h"

#include <vector>

namespace gnomon {

inline constexpr int kDataWidth = 2048; ///< texels a row of the data texture, as shaders/scene.glsl reads it
inline constexpr int kObjectTexels = 1;
inline constexpr int kMaterialTexels = 6;
inline constexpr int kMetalTexels = 2;
inline constexpr int kCheckerTexels = 2;
inline constexpr int kLightTexels = 2;
inline constexpr int kProfileTexels = 1;
inline constexpr int kGlowTexels = 2;
inline constexpr int kGradientTexels = 2;

/// Of one kind. Where it has no such search, its offset is where that would lie.
struct KindOffsets {
    int geometry = 0; ///< of the first object
    int first = 0;    ///< object of the kind, counted over all kinds
    int lattice = 0, hierarchy = 0, grid = 0;
};

/// In texels.
struct SceneOffsets {
    std::vector<KindOffsets> kinds; ///< of SceneFeatures::shapes
    int objects = 0, materials = 0, lights = 0, glows = 0;
    int metals = 0, media = 0, checkers = 0, profiles = 0, gradient = 0;
    int end = 0;
};

SceneOffsets offsetsOf(const SceneFeatures&);

/// Texels that the scene takes.
inline int sceneTexels(const SceneFeatures& features) { return offsetsOf(features).end; }

} // namespace gnomon
