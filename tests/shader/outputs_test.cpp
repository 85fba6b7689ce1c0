/// Outputs of the shader, read back as float32 and held against the oracle, pixel by pixel.

#include "lab/reference/exact/scene_hit.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>
#include <string>

namespace gnomon {
namespace {

using namespace test;
using namespace oracle;

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
    double fov = 0; ///< 0: the scene's own
};

/// Two of each convex shape: four side by side, near enough to stand in each, and four behind and beside them.
constexpr const char* kConvex = R"({"objects": [
    {"box": {"center": [-2, 1.2, 0], "half_size": [0.9, 0.6, 0.7]}},
    {"cylinder": {"from": [0.4, 0.5, -0.3], "to": [2.6, 1.6, 0.5], "radius": 0.6}},
    {"capsule": {"from": [-2.6, -1.6, 0.5], "to": [-1, -0.8, -0.6], "radius": 0.5}},
    {"cone": {"from": [1.6, -1.9, 0], "to": [1.2, -0.2, 0.4], "radius": 0.8}},
    {"box": {"center": [0, -1, -6], "half_size": [0.5, 3, 0.3]}},
    {"cylinder": {"from": [4, -2, -3], "to": [4, 2, -3], "radius": 0.4}},
    {"capsule": {"from": [-4, -2, -3], "to": [-4, 2, -3], "radius": 0.3}},
    {"cone": {"from": [0, 4, -4], "to": [0, 2.2, -4], "radius": 1.5}}]})";

Scene sceneOf(const char* nameOrText) { return *nameOrText == '{' ? sceneFrom(nameOrText) : sceneNamed(nameOrText); }
std::string nameOf(const char* nameOrText) { return *nameOrText == '{' ? "convex" : nameOrText; }
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << nameOf(c.scene); }

class PrimaryHits : public testing::TestWithParam<Case> {
  protected:
    void SetUp() override {
        scene = sceneOf(GetParam().scene);
        if (GetParam().fov > 0) scene.camera.fov = GetParam().fov;
        settings = small(GetParam().time);
        settings.eye = GetParam().eye;
        settings.target = GetParam().target;
        scene.camera.eye = GetParam().eye;
        scene.camera.target = GetParam().target;
        const std::vector<SceneShape> exactShapes = exactShapesOf(scene, settings.time);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                Vec origin, direction;
                pixelRay(scene.camera, x, y, kWidth, kHeight, origin, direction);
                exact.push_back(nearestHit(exactShapes, origin, direction));
            }
    }
    const SceneHit& at(int x, int y) const { return exact[std::size_t(y) * kWidth + x]; }
    FloatImage output(Aov aov) { return outputOf(scene, settings, aov); }
    /// Calls `check(x, y, exact)` for the pixels whose answer does not hang on rounding; most must be such.
    template<typename Check>
    void eachCertainPixel(Check check) {
        int certain = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const SceneHit& hit = at(x, y);
                if (hit.margin < 40 * slack(hit.object < 0 ? 100 : hit.t)) continue;
                ++certain;
                check(x, y, hit);
                if (testing::Test::HasFailure()) return;
            }
        EXPECT_GT(certain, kWidth * kHeight * 95 / 100);
    }

    /// Which of two faces is met so near to an edge is rounding, and the faces' normals and slopes differ.
    static bool atAnEdge(const SceneHit& hit) { return hit.edge < 40 * slack(hit.t); }

    Scene scene;
    Settings settings;
    std::vector<SceneHit> exact;
};

TEST_P(PrimaryHits, NameTheObjectThatTheOracleNames) {
    const FloatImage image = output(Aov::Object);
    eachCertainPixel(
        [&](int x, int y, const SceneHit& hit) { EXPECT_EQ(int(*image.at(x, y)), hit.object) << x << ' ' << y; });
}

TEST_P(PrimaryHits, LieAtTheOraclesDistance) {
    const FloatImage image = output(Aov::Distance);
    eachCertainPixel([&](int x, int y, const SceneHit& hit) {
        if (hit.object < 0) {
            EXPECT_TRUE(std::isinf(*image.at(x, y)));
            return;
        }
        if (atAnEdge(hit)) return;
        Vec origin, direction;
        pixelRay(scene.camera, x, y, kWidth, kHeight, origin, direction);
        const long double cosine = std::abs(glm::dot(hit.normal, direction));
        EXPECT_NEAR(*image.at(x, y), double(hit.t), double(slack(hit.t) / cosine)) << x << ' ' << y;
    });
}

TEST_P(PrimaryHits, LieOnTheOraclesPoint) {
    const FloatImage image = output(Aov::Position);
    eachCertainPixel([&](int x, int y, const SceneHit& hit) {
        if (atAnEdge(hit)) return;
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
    eachCertainPixel([&](int x, int y, const SceneHit& hit) {
        const float* n = image.at(x, y);
        const Vec normal(n[0], n[1], n[2]);
        if (hit.object < 0) {
            EXPECT_EQ(double(glm::length(normal)), 0.0);
            return;
        }
        EXPECT_NEAR(double(glm::length(normal)), 1.0, 1e-6);
        if (atAnEdge(hit)) return;
        Vec origin, direction;
        pixelRay(scene.camera, x, y, kWidth, kHeight, origin, direction);
        const long double cosine = std::abs(glm::dot(hit.normal, direction));
        EXPECT_LE(double(glm::length(normal - hit.normal)), double(2e-3L + 2 * slack(hit.t) * hit.turn / cosine))
            << x << ' ' << y;
    });
}

INSTANTIATE_TEST_SUITE_P(
    Views, PrimaryHits,
    testing::Values(Case{"lite", 0, {0, 0, 35}, {0, 0, 0}}, Case{"lite", 3.7, {12, 4, 20}, {0, -1, 0}},
                    Case{"pro", 0, {0, 0, 35}, {0, 0, 0}}, Case{"pro", 1.5, {14, 2, 8}, {9, -1, 0}},
                    Case{"torus", 0, {0, 1.6, 4.5}, {0, 0, 0}}, Case{"torus", 0, {0.3, 0.2, 40}, {0, 0, 0}},
                    Case{"shapes", 0, {0.4, 2.5, 7.2}, {0, 0.6, 0}}, Case{kConvex, 0, {0.5, 1, 9}, {0, 0, 0}},
                    Case{kConvex, 0, {0, 0, 9}, {0, 0, 0}}, Case{kConvex, 0, {7, 5, -8}, {0, 0, 0}},
                    Case{kConvex, 0, {9, 0, 0}, {0, 0, 0}},
                    Case{kConvex, 0, {100, 150, 240}, {0, 0, 0}, 1.2},          // 300 units away
                    Case{kConvex, 0, {-2.3, 1.3, 0.2}, {-2, 1.2, 0}, 100},      // in the box
                    Case{kConvex, 0, {1.5, 1, 0.3}, {2.6, 1.6, 0.5}, 100},      // in the cylinder
                    Case{kConvex, 0, {-1.8, -1.2, 0}, {-2.6, -1.6, 0.5}, 100},  // in the capsule
                    Case{kConvex, 0, {1.5, -1.5, 0.1}, {1.2, -0.2, 0.4}, 100}), // in the cone
    [](const auto& test) { return nameOf(test.param.scene) + std::to_string(test.index); });

// The middle ray runs along -z exactly: parallel to faces, to axes and, on the tilted cone, to a line of its side.
TEST(ParallelRays, MeetConvexShapesWhereTheyAre) {
    struct Row {
        const char* shape;
        double distance; ///< from (0, 0, 9); infinite: passes by
    };
    const double kNone = std::numeric_limits<double>::infinity();
    const Row rows[] = {
        {R"("box": {"center": [0.3, 0.2, 0], "half_size": [0.5, 0.5, 1]})", 8},
        {R"("box": {"center": [1, 0, 0], "half_size": [0.5, 0.5, 1]})", kNone},
        {R"("box": {"center": [0.25, 0, 9], "half_size": [0.5, 0.5, 2]})", 2}, // the eye is inside
        {R"("cylinder": {"from": [0.3, 0, -1], "to": [0.3, 0, 1], "radius": 0.5})", 8},
        {R"("cylinder": {"from": [0.6, 0, -1], "to": [0.6, 0, 1], "radius": 0.5})", kNone},
        {R"("cylinder": {"from": [0, 0, 8], "to": [0, 0, 10], "radius": 0.5})", 1},
        {R"("capsule": {"from": [0, 0, -1], "to": [0, 0, 1], "radius": 0.5})", 7.5},
        {R"("capsule": {"from": [0.6, 0, -1], "to": [0.6, 0, 1], "radius": 0.5})", kNone},
        {R"("cone": {"from": [0, 0, -1], "to": [0, 0, 1], "radius": 0.5})", 8},
        {R"("cone": {"from": [0, 0, 1], "to": [0, 0, -1], "radius": 0.5})", 8},
        {R"("cone": {"from": [0.25, 0, -1], "to": [0.25, 0, 1], "radius": 0.5})", 9}, // half way down
        {R"("cone": {"from": [0.6, 0, -1], "to": [0.6, 0, 1], "radius": 0.5})", kNone},
        // Of half angle 45°, the ray parallel to one line of the side: in by the base, and in by the line across.
        {R"("cone": {"from": [-0.4, 0, 0.4], "to": [1.6, 0, -1.6], "radius": 2.8284271247461903})", 8.2},
        {R"("cone": {"from": [-0.4, 0, -0.4], "to": [1.6, 0, 1.6], "radius": 2.8284271247461903})", 7.4},
    };
    Settings settings;
    settings.size = {9, 9};
    for (const Row& row : rows) {
        const Scene scene = sceneFrom(
            std::string(R"({"camera": {"eye": [0, 0, 9], "target": [0, 0, 0]}, "objects": [{)") + row.shape + "}]}");
        const float t = *outputOf(scene, settings, Aov::Distance).at(4, 4);
        if (std::isinf(row.distance))
            EXPECT_TRUE(std::isinf(t)) << row.shape << ' ' << t;
        else
            EXPECT_NEAR(t, row.distance, 4e-6) << row.shape;
    }
}

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

// Preloads (shaders/software/preloads.glsl) spare a software rasteriser work and change nothing.
TEST(Outputs, AreTheSameWithoutPreloads) {
    offscreen();
    const ShaderFile nothing[] = {{"software/preloads.glsl", "vec4 preload() { return vec4(0.0); }"}};
    for (const char* name : {"lite", "pro", "torus", "solids"}) {
        const Scene scene = sceneNamed(name);
        Drawing preloaded(scene, small(1)), plain(scene, small(1), nothing);
        EXPECT_NE(preloaded.renderer().source(), plain.renderer().source()) << name;
        EXPECT_EQ(preloaded.output().pixels, plain.output().pixels) << name;
    }
}

} // namespace
} // namespace gnomon
