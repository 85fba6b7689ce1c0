/// The ray tree's stack is shorter than deep trees: a ray that has lost its entry is found again by tracing the way to
/// it anew, and the picture does not show which rays were.

#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

namespace gnomon {
namespace {

using namespace test;

/// llvmpipe takes the level of detail of four pixels from one of them, whatever ray that one is on: where images are, a
/// pixel shows a little of what its neighbours do: 6e-8 of white.
constexpr double kImages = 1e-6;

struct Case {
    const char* scene;
    double threshold; ///< 0: no ray is left out, so that glass fills the tree
    glm::dvec3 eye, target;
    double bound;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.scene << ", threshold " << c.threshold; }

class RayTree : public testing::TestWithParam<Case> {
  protected:
    /// The output with that many entries on the stack.
    FloatImage with(int entries, Aov aov) const {
        const std::string is = "kRayStack = 3";
        std::string text(shaderText("integrator/ray_stack.glsl"));
        const std::size_t at = text.find(is);
        EXPECT_NE(at, std::string::npos);
        text.replace(at, is.size(), "kRayStack = " + std::to_string(entries));
        const ShaderFile overrides[] = {{"integrator/ray_stack.glsl", text}};
        Settings settings;
        settings.size = {160, 120};
        settings.depth = 8;
        settings.threshold = GetParam().threshold;
        settings.aov = aov;
        Drawing drawing(sceneNamed(GetParam().scene), settings, overrides);
        drawing.view.camera.eye = GetParam().eye;
        drawing.view.camera.target = GetParam().target;
        return drawing.output();
    }
};

double difference(const FloatImage& a, const FloatImage& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    double worst = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        worst = std::max(worst, double(std::abs(a.pixels[i] - b.pixels[i])));
    return worst;
}

/// Objects asked in all pixels.
double asked(const FloatImage& work) {
    double sum = 0;
    for (std::size_t i = 1; i < work.pixels.size(); i += std::size_t(work.channels)) sum += work.pixels[i];
    return sum;
}

/// Seven entries hold all that can wait at depth 8. One loses nearly all of them, and its work tells that it did.
TEST_P(RayTree, LooksTheSameWithAnyStack) {
    offscreen();
    const FloatImage whole = with(7, Aov::Color);
    const double three = difference(whole, with(3, Aov::Color)), one = difference(whole, with(1, Aov::Color));
    EXPECT_LE(three, GetParam().bound);
    EXPECT_LE(one, GetParam().bound);
    const double most = asked(with(7, Aov::Work)), few = asked(with(3, Aov::Work)), least = asked(with(1, Aov::Work));
    std::printf("%s: with three entries %.3f of the objects asked, with one %.3f; worst difference %.2g, %.2g\n",
                GetParam().scene, few / most, least / most, three, one);
    EXPECT_GE(few, most);
    EXPECT_GT(least, 1.02 * most) << "nothing was traced anew";
}

INSTANTIATE_TEST_SUITE_P(Scenes, RayTree,
                         testing::Values(Case{"pro", 1.0 / 512, {0, 0, 35}, {0, 0, 0}, kImages},
                                         Case{"pro", 0, {16, 3, 14}, {8, 0, 0}, kImages},
                                         Case{"lite", 0, {0, 0, 35}, {-7, 0, 0}, kImages},
                                         Case{"shapes", 0, {0, 4, 14}, {0, 0, 0}, 0}),
                         [](const auto& test) { return test.param.scene + std::to_string(test.index); });

} // namespace
} // namespace gnomon
