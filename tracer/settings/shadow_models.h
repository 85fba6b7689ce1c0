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
    MontecarloMarch,
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
    bool cones;     ///< marches cones, which may start at the light: at any but a directional one, which has no place
    bool parallel;  ///< takes directional lights, which are at no distance
    int batch;      ///< of a light's samples so many in one draw where a picture is read back; 0: takes none
};

// clang-format off
inline constexpr std::array kShadowModels{
    ShadowRow{ShadowModel::Off,             "off",              false, false, false, true,  0},
    ShadowRow{ShadowModel::Hard,            "hard",             true,  false, false, true,  0},
    ShadowRow{ShadowModel::Montecarlo,      "montecarlo",       true,  false, false, true,  32},
    ShadowRow{ShadowModel::MontecarloMarch, "montecarlo-march", false, true,  false, true,  4},
    ShadowRow{ShadowModel::Quilez,          "quilez",           false, true,  false, true,  0},
    ShadowRow{ShadowModel::Aaltonen,        "aaltonen",         false, true,  false, true,  0},
    ShadowRow{ShadowModel::ConeBase,        "cone-base",        false, true,  true,  true,  0},
    ShadowRow{ShadowModel::ConeLinear,      "cone-linear",      false, true,  true,  true,  0},
    ShadowRow{ShadowModel::ConeDiscrete,    "cone-discrete",    false, true,  true,  true,  0},
    ShadowRow{ShadowModel::ConeConvex,      "cone-convex",      false, true,  true,  true,  0},
    ShadowRow{ShadowModel::Silhouette,      "silhouette",       false, true,  false, false, 0}};
// clang-format on

constexpr const ShadowRow& shadowRow(ShadowModel model) { return kShadowModels[std::size_t(model)]; }

} // namespace gnomon
