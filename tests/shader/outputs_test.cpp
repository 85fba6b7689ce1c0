/// Outputs of the shader, read back as float32 and held against the oracle, pixel by pixel.

#include "tests/shader/oracle.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

namespace gnomon {
namespace {

using namespace test;

constexpr int kWidth = 120, kHeight = 90;

Settings small(double time) {
    Settings settings;
    settings.size = {kWidth, kHeight};
    settings.time = time;
    return settings;
}

/// Angles between rays are known to float32 only: at distance t a ray is off by this much to the side.
long double slack(long double t) { return 4e-7L * (t + 1); }

struct Case {
    const char* scene;
    double time;
    glm::dvec3 eye, target;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.scene; }

class PrimaryHits : public testing::TestWithParam<Case> {
  protected:
    void SetUp() override {
        scene = sceneNamed(GetParam().scene);
        settings = small(GetParam().time);
        settings.eye = GetParam().eye;
        settings.target = GetParam().target;
        scene.camera.eye = GetParam().eye;
        scene.camera.target = GetParam().target;
        const auto shapes = shapesAt(scene, settings.time);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                Vec origin, direction;
                pixelRay(scene.camera, x, y, kWidth, kHeight, origin, direction);
                exact.push_back(oracleHit(shapes, origin, direction));
            }
    }
    const OracleHit& at(int x, int y) const { return exact[std::size_t(y) * kWidth + x]; }
    FloatImage output(Aov aov) { return outputOf(scene, settings, aov); }
    /// Calls `check(x, y, exact)` for the pixels whose answer does not hang on rounding; most must be such.
    template<typename Check>
    void eachCertainPixel(Check check) {
        int certain = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const OracleHit& hit = at(x, y);
                if (hit.margin < 40 * slack(hit.object < 0 ? 100 : hit.t)) continue;
                ++certain;
                check(x, y, hit);
                if (testing::Test::HasFailure()) return;
            }
        EXPECT_GT(certain, kWidth * kHeight * 95 / 100);
    }

    Scene scene;
    Settings settings;
    std::vector<OracleHit> exact;
};

TEST_P(PrimaryHits, NameTheObjectThatTheOracleNames) {
    const FloatImage image = output(Aov::Object);
    eachCertainPixel(
        [&](int x, int y, const OracleHit& hit) { EXPECT_EQ(int(*image.at(x, y)), hit.object) << x << ' ' << y; });
}

TEST_P(PrimaryHits, LieAtTheOraclesDistance) {
    const FloatImage image = output(Aov::Distance);
    eachCertainPixel([&](int x, int y, const OracleHit& hit) {
        if (hit.object < 0) {
            EXPECT_TRUE(std::isinf(*image.at(x, y)));
            return;
        }
        Vec origin, direction;
        pixelRay(scene.camera, x, y, kWidth, kHeight, origin, direction);
        const long double cosine = std::abs(glm::dot(hit.normal, direction));
        EXPECT_NEAR(*image.at(x, y), double(hit.t), double(slack(hit.t) / cosine)) << x << ' ' << y;
    });
}

TEST_P(PrimaryHits, LieOnTheOraclesPoint) {
    const FloatImage image = output(Aov::Position);
    eachCertainPixel([&](int x, int y, const OracleHit& hit) {
        Vec origin, direction;
        pixelRay(scene.camera, x, y, kWidth, kHeight, origin, direction);
        const long double cosine = hit.object < 0 ? 1 : std::abs(glm::dot(hit.normal, direction));
        const float* p = image.at(x, y);
        EXPECT_LE(double(glm::length(Vec(p[0], p[1], p[2]) - hit.point)), double(2 * slack(hit.t + 20) / cosine))
            << x << ' ' << y;
    });
}

TEST_P(PrimaryHits, HaveTheOraclesNormal) {
    const FloatImage image = output(Aov::Normal);
    eachCertainPixel([&](int x, int y, const OracleHit& hit) {
        const float* n = image.at(x, y);
        const Vec normal(n[0], n[1], n[2]);
        if (hit.object < 0) {
            EXPECT_EQ(double(glm::length(normal)), 0.0);
            return;
        }
        EXPECT_NEAR(double(glm::length(normal)), 1.0, 1e-6);
        EXPECT_LE(double(glm::length(normal - hit.normal)), 2e-3) << x << ' ' << y;
    });
}

INSTANTIATE_TEST_SUITE_P(
    Views, PrimaryHits,
    testing::Values(Case{"lite", 0, {0, 0, 35}, {0, 0, 0}}, Case{"lite", 3.7, {12, 4, 20}, {0, -1, 0}},
                    Case{"pro", 0, {0, 0, 35}, {0, 0, 0}}, Case{"pro", 1.5, {14, 2, 8}, {9, -1, 0}},
                    Case{"torus", 0, {0, 1.6, 4.5}, {0, 0, 0}}, Case{"torus", 0, {0.3, 0.2, 40}, {0, 0, 0}}),
    [](const auto& test) { return std::string(test.param.scene) + std::to_string(test.index); });

TEST(Outputs, GiveInfinityZeroAndMinusOneWhereNothingIsHit) {
    const Scene scene = sceneFrom(R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 9]},
                                      "lights": [{"point": {"position": [0, 5, 0]}}],
                                      "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}}]})");
    Settings settings;
    settings.size = {4, 3};
    EXPECT_TRUE(std::isinf(*outputOf(scene, settings, Aov::Distance).at(1, 1)));
    EXPECT_EQ(*outputOf(scene, settings, Aov::Object).at(1, 1), -1.0f);
    EXPECT_EQ(*outputOf(scene, settings, Aov::Visibility).at(1, 1), 1.0f);
    for (Aov aov : {Aov::Position, Aov::Normal})
        for (int c = 0; c < 3; ++c) EXPECT_EQ(outputOf(scene, settings, aov).at(1, 1)[c], 0.0f);
}

TEST(Outputs, ReadTheSameFromABlockAndFromATexture) {
    Settings settings = small(1);
    settings.data = DataPath::Block;
    const FloatImage block = outputOf(sceneNamed("pro"), settings, Aov::Color);
    settings.data = DataPath::Texture;
    const FloatImage texture = outputOf(sceneNamed("pro"), settings, Aov::Color);
    EXPECT_EQ(block.pixels, texture.pixels);
}

} // namespace
} // namespace gnomon
