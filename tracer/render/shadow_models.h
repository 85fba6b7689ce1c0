/// The table of shadow models: one row and one file shaders/shadow/KEY.glsl each ('-' in a key is '_' in the file's
/// name).
#pragma once

#include <array>
#include <string_view>

namespace gnomon {

/// How much of a light reaches a point: docs/shadows.md. Montecarlo … ConeConvex are those of the source document.
enum class ShadowModel {
    Off,
    Hard,
    Montecarlo,
    Quilez,
    Aaltonen,
    ConeBase,
    ConeLinear,
    ConeDiscrete,
    ConeConvex,
    Silhouette
};

struct ShadowRow {
    ShadowModel model;
    std::string_view key;
    bool rays;      ///< asks whether rays are occluded: shaders/ray/nearest.glsl
    bool distances; ///< asks for distances of shapes
};

// clang-format off
inline constexpr std::array kShadowModels{
    ShadowRow{ShadowModel::Off,          "off",           false, false},
    ShadowRow{ShadowModel::Hard,         "hard",          true,  false},
    ShadowRow{ShadowModel::Montecarlo,   "montecarlo",    true,  false},
    ShadowRow{ShadowModel::Quilez,       "quilez",        false, true},
    ShadowRow{ShadowModel::Aaltonen,     "aaltonen",      false, true},
    ShadowRow{ShadowModel::ConeBase,     "cone-base",     false, true},
    ShadowRow{ShadowModel::ConeLinear,   "cone-linear",   false, true},
    ShadowRow{ShadowModel::ConeDiscrete, "cone-discrete", false, true},
    ShadowRow{ShadowModel::ConeConvex,   "cone-convex",   false, true},
    ShadowRow{ShadowModel::Silhouette,   "silhouette",    false, true}};
// clang-format on

constexpr const ShadowRow& shadowRow(ShadowModel model) { return kShadowModels[std::size_t(model)]; }

} // namespace gnomon
