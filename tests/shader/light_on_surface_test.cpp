/// A light that lies exactly on a surface, as one on a floor: every shadow model lets it shine.
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon {
namespace {

using namespace test;

/// The light on a floor's top, a wall that it shines at, and a ball before a part of the wall.
const char* const kScene = R"({"camera": {"eye": [0, 1.5, 6], "target": [0, 1.5, -3], "fov": 40},
    "lights": [{"point": {"position": [0, 0, 0]}}],
    "objects": [{"box": {"center": [0, -1, 0], "half_size": [4, 1, 3]}},
                {"box": {"center": [0, 2, -3], "half_size": [4, 2, 0.1]}},
                {"sphere": {"center": [1, 1, -1.5], "radius": 0.4}}]})";

FloatImage visibility(ShadowModel model) {
    Settings settings;
    settings.size = {60, 40};
    settings.shadows = model;
    return outputOf(sceneFrom(kScene), settings, Aov::Visibility);
}

class LightOnSurface : public testing::TestWithParam<ShadowModel> {};

// Of the wall's pixels: elsewhere hardly any light comes in any case. Rims of shadows are soft or moved by a pixel.
TEST_P(LightOnSurface, ShinesAsHardShadowsSay) {
    offscreen();
    Settings settings;
    settings.size = {60, 40};
    const FloatImage objects = outputOf(sceneFrom(kScene), settings, Aov::Object), hard = visibility(ShadowModel::Hard),
                     soft = visibility(GetParam());
    int wall = 0, lit = 0, differing = 0;
    for (std::size_t i = 0; i < objects.pixels.size(); ++i) {
        if (objects.pixels[i] != 1) continue;
        ++wall;
        lit += hard.pixels[i] == 1;
        differing += std::abs(hard.pixels[i] - soft.pixels[i]) > 0.15F;
    }
    EXPECT_GT(lit, 0.7 * wall);
    EXPECT_LE(differing, 0.06 * wall);
}

INSTANTIATE_TEST_SUITE_P(Models, LightOnSurface,
                         testing::Values(ShadowModel::Montecarlo, ShadowModel::MontecarloMarch, ShadowModel::Quilez,
                                         ShadowModel::Aaltonen, ShadowModel::ConeBase, ShadowModel::ConeLinear),
                         [](const auto& test) {
                             std::string name(shadowRow(test.param).key);
                             std::erase(name, '-');
                             return name;
                         });

} // namespace
} // namespace gnomon
