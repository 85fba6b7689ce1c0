/// Fields in pictures: rays that go through a baked field end where the patch itself is met, however the field was
/// baked and gone through; distances of it hold; fields are shared, replaced and baked anew.

#include "lab/batch/distance_batch.h"
#include "lab/reference/exact/patch_distance.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/plan/field_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace gnomon {
namespace {

using namespace test;

constexpr int kWidth = 160, kHeight = 120;

/// Three patches: gentle, steep, and one that a group has turned.
constexpr const char* kScene = R"({"camera": {"eye": [0, 3.5, 9], "target": [0, 0.3, 0]},
    "lights": [{"point": {"position": [4, 9, 6]}}],
    "materials": {"grey": {"diffuse": 0.8}},
    "objects": [{"plane": {"point": [0, -1.2, 0], "normal": [0, 1, 0]}, "material": "grey"},
        {"patch": {"random": 1, "center": [-2.8, 0.4, 0], "size": [2.4, 0.5, 2.4]}, "material": "grey"},
        {"patch": {"random": 2, "center": [0, 0.4, 0], "size": [2.4, 1, 2.4]}, "material": "grey"},
        {"group": {"of": [{"patch": {"random": 3, "size": [2.4, 0.5, 2.4]}}], "rotate": [50, 20, 0],
            "translate": [2.8, 0.6, 0]}, "material": "grey"}]})";

Settings small(SurfaceMode surface) {
    Settings settings;
    settings.size = {kWidth, kHeight};
    settings.surface = surface;
    return settings;
}

/// Pixels of which a value differs by more than `most` of itself and of 1.
int differing(const FloatImage& a, const FloatImage& b, float most) {
    int count = 0;
    const std::size_t channels = std::size_t(a.channels);
    for (std::size_t i = 0; i < a.pixels.size(); i += channels) {
        bool differs = false;
        for (std::size_t c = i; c < i + channels; ++c)
            differs |= a.pixels[c] != b.pixels[c] &&
                       !(std::abs(a.pixels[c] - b.pixels[c]) <= most * std::max(1.0f, std::abs(a.pixels[c])));
        count += differs;
    }
    return count;
}

// What is left are pixels at rims and at silhouettes, where a field loses what lies within a voxel of its edge.
TEST(Field, ShowsThePatchItselfByEveryMarch) {
    offscreen();
    const Scene scene = sceneFrom(kScene);
    const FloatImage distance = outputOf(scene, small(SurfaceMode::Patch), Aov::Distance),
                     normal = outputOf(scene, small(SurfaceMode::Patch), Aov::Normal);
    for (const FieldMarch march : {FieldMarch::Sphere, FieldMarch::Relaxed, FieldMarch::Voxel}) {
        Settings settings = small(SurfaceMode::Field);
        settings.fieldMarch = march;
        EXPECT_LE(differing(outputOf(scene, settings, Aov::Distance), distance, 1e-5f), 12) << int(march);
        EXPECT_LE(differing(outputOf(scene, settings, Aov::Normal), normal, 1e-4f), 12) << int(march);
    }
}

TEST(Field, ShowsItByEveryMethodAndFormat) {
    offscreen();
    const Scene scene = sceneFrom(kScene);
    const FloatImage distance = outputOf(scene, small(SurfaceMode::Patch), Aov::Distance);
    for (int method = 0; method <= int(FieldMethod::Lipschitz); ++method) {
        Settings settings = small(SurfaceMode::Field);
        settings.fieldMethod = FieldMethod(method);
        settings.fieldResolution = 32;
        settings.fieldSteps = 1000;
        settings.fieldFormat = method % 2 ? FieldFormat::R16f : FieldFormat::R32f;
        EXPECT_LE(differing(outputOf(scene, settings, Aov::Distance), distance, 1e-4f), 60) << method;
    }
}

TEST(Field, CastsTheShadowsOfThePatch) {
    offscreen();
    const Scene scene = sceneFrom(kScene);
    const FloatImage visibility = outputOf(scene, small(SurfaceMode::Patch), Aov::Visibility);
    EXPECT_LE(differing(outputOf(scene, small(SurfaceMode::Field), Aov::Visibility), visibility, 0.01f), 60);
}

// Within the box as far as trilinear interpolation goes; beyond it from below, and nowhere farther than the patch is.
TEST(Field, TellsTheDistanceOfThePatch) {
    offscreen();
    for (const unsigned seed : {1U, 2U, 3U}) {
        Scene scene = sceneFrom(R"({"objects": [{"patch": {"random": )" + std::to_string(seed) +
                                R"(, "size": [1, 0.25, 1]}}]})");
        const Shape& shape = scene.objects[0].shape;
        Settings settings;
        Problems problems;
        DistanceBatch batch(scene, problems);
        ASSERT_TRUE(batch.valid()) << toString(problems);
        const oracle::PatchDistance exact(*shape.heights, pointOf(shape, "center"), pointOf(shape, "size"));
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> within(-1, 1);
        std::vector<BatchPoint> points(4000);
        for (BatchPoint& point : points) point.p = {within(random), 2 * within(random), within(random)};
        const auto answers = batch.measure(points);
        const double voxel = glm::length(fieldLayoutOf(scene, 64, 2048, 1e9).slots[0].size) / 63;
        double worst = 0, below = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double right = exact.nearest(glm::dvec3(points[i].p)).distance;
            worst = std::max(worst, double(answers[i].distance) - right);
            const glm::dvec3 off = glm::abs(glm::dvec3(points[i].p) - pointOf(shape, "center"));
            const bool inBox = off.x <= 0.5 && off.z <= 0.5 && off.y <= 0.5 * pointOf(shape, "size").y;
            if (inBox) below = std::max(below, right - double(answers[i].distance));
        }
        std::printf("seed %u: at most %.4f voxels too far, in its box %.4f too near\n", seed, worst / voxel,
                    below / voxel);
        EXPECT_LE(worst, 0.05 * voxel) << seed;
        EXPECT_LE(below, 0.05 * voxel) << seed;
    }
}

// Boxes hold their patches: a hierarchy finds what asking all of them finds.
TEST(Field, IsFoundByEverySearch) {
    offscreen();
    std::string objects;
    for (int i = 0; i < 48; ++i)
        objects += (i > 0 ? "," : "") + std::string(R"({"group": {"of": [{"patch": {"random": )") + std::to_string(i) +
                   R"(, "size": [1, 0.2, 1]}}], "rotate": [)" + std::to_string(7 * i) + ", " +
                   std::to_string(31 * i % 360) +
                   R"(, 0], "translate": [)" + std::to_string(i % 8 - 3.5) + ", " +
                   std::to_string(i / 8 - 2.5) + ", 0]}}";
    const Scene scene = sceneFrom(R"({"camera": {"eye": [0, 1, 12]}, "objects": [)" + objects + "]}");
    for (const SurfaceMode surface : {SurfaceMode::Patch, SurfaceMode::Field}) {
        Settings settings = small(surface);
        settings.fieldResolution = 16;
        settings.accel = Accel::None;
        const FloatImage all = outputOf(scene, settings, Aov::Distance);
        EXPECT_GT(std::count_if(all.pixels.begin(), all.pixels.end(), [](float t) { return std::isfinite(t); }), 3000);
        settings.accel = Accel::Hierarchy;
        EXPECT_EQ(difference(outputOf(scene, settings, Aov::Distance), all), "") << int(surface);
    }
}

TEST(Field, IsBakedAnewInANewContext) {
    offscreen();
    const Scene scene = sceneFrom(kScene);
    Settings settings = small(SurfaceMode::Field);
    settings.aov = Aov::Distance;
    Drawing drawing(scene, settings);
    const FloatImage before = drawing.output();
    renewContext();
    Problems problems;
    drawing.renderer().contextRestored();
    EXPECT_TRUE(drawing.renderer().finish(problems)) << toString(problems);
    EXPECT_EQ(difference(drawing.output(), before), "");
}

// The old field is drawn with until the new one is there, and it is the same one after a detour.
TEST(Field, IsReplacedWhileTheOldOneIsDrawnWith) {
    offscreen();
    const Scene scene = sceneFrom(kScene);
    Settings fine = small(SurfaceMode::Field);
    fine.aov = Aov::Distance;
    Settings coarse = fine;
    coarse.fieldResolution = 8;
    Drawing drawing(scene, fine);
    const FloatImage before = drawing.output();
    drawing.renderer().configure(coarse);
    Problems problems;
    const Progress progress = drawing.renderer().poll(problems);
    EXPECT_LT(progress.baked, 1);
    EXPECT_FALSE(progress.ready());
    EXPECT_TRUE(drawing.renderer().canDraw());
    EXPECT_EQ(difference(drawing.renderer().readOutput(drawing.view, problems), before), "");
    EXPECT_TRUE(drawing.renderer().finish(problems));
    EXPECT_NE(difference(drawing.output(), before), "");
    drawing.renderer().configure(fine);
    EXPECT_TRUE(drawing.renderer().finish(problems));
    EXPECT_EQ(difference(drawing.output(), before), "");
    EXPECT_TRUE(problems.empty()) << toString(problems);
}

TEST(Field, IsNotInScenesWithoutOne) {
    offscreen();
    Settings settings = small(SurfaceMode::Field);
    Drawing lite(sceneNamed("lite"), settings);
    lite.picture();
    EXPECT_EQ(lite.renderer().source().find("Net("), std::string::npos);
    Drawing patch(sceneFrom(kScene), small(SurfaceMode::Patch));
    patch.picture();
    EXPECT_EQ(patch.renderer().source().find("sampler3D"), std::string::npos);
}

} // namespace
} // namespace gnomon
