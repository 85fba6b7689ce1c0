/// Nets of heights, scene files with patches of them, and the layout of their fields.

#include "tests/support/scenes.h"
#include "tracer/plan/field_layout.h"
#include "tracer/scene/height_patch.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace gnomon {
namespace {

using namespace test;

/// What a patch of these keys is told to be wrong with; empty where it is read.
std::string problemOf(const std::string& keys) {
    Problems problems;
    readScene(R"({"objects": [{"patch": {)" + keys + "}}]}", "test", problems);
    return toString(problems);
}

/// Where the scene's only object, a patch, lies at (u, v).
glm::dvec3 pointAt(const Scene& scene, double u, double v) {
    const Shape& shape = scene.objects.at(0).shape;
    const glm::dvec3 size = pointOf(shape, "size");
    return pointOf(shape, "center") + size * glm::dvec3(u - 0.5, heightAt(*shape.heights, u, v), v - 0.5);
}

TEST(HeightPatch, HasRandomHeightsThatNoControlPointOutdoes) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Heights heights = randomHeights(seed);
        for (std::size_t i = 0; i < 16; ++i) {
            const auto inner = [](std::size_t k) { return k == 1 || k == 2; };
            const double most = (inner(i % 4) ? 2.25 : 1) * (inner(i / 4) ? 2.25 : 1);
            EXPECT_LE(std::abs(heights[i]), most) << seed;
        }
        EXPECT_NE(heights, randomHeights(seed + 1));
    }
    // The same on every machine: these are SplitMix64's first numbers for seed 0.
    EXPECT_EQ(randomHeights(0)[0], 2 * (double(0xe220a8397b1dcdafULL >> 11) * 0x1p-53) - 1);
}

TEST(HeightPatch, IsWhatItsPartsAre) {
    const Heights heights = randomHeights(5);
    const glm::dvec2 low(0.2, 0.9), high(0.7, 0.3); // turned round along v
    const Heights part = partOf(heights, low, high);
    for (const double u : {0.0, 0.3, 1.0})
        for (const double v : {0.0, 0.6, 1.0})
            EXPECT_NEAR(heightAt(part, u, v),
                        heightAt(heights, low.x + u * (high.x - low.x), low.y + v * (high.y - low.y)), 1e-14);
}

TEST(HeightPatch, LiesWithinItsRangeAndComesNearItsEnds) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Heights heights = randomHeights(seed);
        const auto [least, greatest] = heightRange(heights);
        double low = 1e30, high = -1e30;
        for (int i = 0; i <= 200; ++i)
            for (int j = 0; j <= 200; ++j) {
                const double height = heightAt(heights, i / 200.0, j / 200.0);
                low = std::min(low, height);
                high = std::max(high, height);
            }
        EXPECT_LE(least, low) << seed;
        EXPECT_GE(greatest, high) << seed;
        EXPECT_NEAR(least, low, 1e-2) << seed;
        EXPECT_NEAR(greatest, high, 1e-2) << seed;
    }
}

TEST(HeightPatch, IsReadWhereTheFileHasIt) {
    const Scene scene = sceneFrom(R"({"objects": [{"patch": {
        "heights": [0, 1, 2, 3,  4, 5, 6, 7,  8, 9, 10, 11,  12, 13, 14, 15],
        "center": [1, 2, 3], "size": [4, 0.5, 6]}}]})");
    expectNear(pointAt(scene, 0, 0), {-1, 2, 0}, 1e-12, "u = v = 0");
    expectNear(pointAt(scene, 1, 0), {3, 3.5, 0}, 1e-12, "u = 1");
    expectNear(pointAt(scene, 0, 1), {-1, 8, 6}, 1e-12, "v = 1");
    const Scene standard = sceneFrom(R"({"objects": [{"patch": {"random": 7}}]})");
    expectNear(pointAt(standard, 0.25, 0.5), {-0.25, heightAt(randomHeights(7), 0.25, 0.5), 0}, 1e-12, "random");
    const Scene flat = sceneFrom(R"({"objects": [{"patch": {"heights": [2,2,2,2, 2,2,2,2, 2,2,2,2, 2,2,2,2]}}]})");
    expectNear(pointAt(flat, 0.25, 0.5), {-0.25, 2, 0}, 1e-12, "flat");
}

TEST(HeightPatch, IsMovedByGroupsAsItsPointsAre) {
    const std::string patch = R"({"patch": {"random": 3, "center": [1, 0, 0], "size": [2, 1, 1]}})";
    const Scene alone = sceneFrom("{\"objects\": [" + patch + "]}");
    const Scene scaled = sceneFrom(R"({"objects": [{"group": {"of": [)" + patch +
                                   R"(], "scale": [2, 3, 4], "rotate": [0, 90, 0], "translate": [0, 1, 0]}}]})");
    const Shape& shape = scaled.objects.at(0).shape;
    const glm::dvec3 before = pointOf(alone.objects.at(0).shape, "center"), size = pointOf(shape, "size");
    expectNear(pointOf(shape, "center"), {0, 1 + 3 * before.y, -2 * before.x}, 1e-12, "centre");
    expectNear(size, glm::dvec3(2, 3, 4) * pointOf(alone.objects.at(0).shape, "size"), 1e-12, "size");
    Problems problems;
    readScene(R"({"objects": [{"group": {"of": [{"group": {"of": [)" + patch +
                  R"(], "rotate": [0, 45, 0]}}], "scale": [1, 1, 2]}}]})",
              "test", problems);
    EXPECT_NE(toString(problems).find("scale it before it is rotated"), std::string::npos) << toString(problems);
}

TEST(HeightPatch, IsRefusedWithOneReason) {
    const std::string sixteen = "1,2,3,4, 1,2,3,4, 1,2,3,4, 1,2,3,4";
    EXPECT_EQ(problemOf("\"heights\": [" + sixteen + "]"), "");
    EXPECT_NE(problemOf("\"heights\": [1, 2, 3]").find("expected a list of 16 numbers, found 3"), std::string::npos);
    EXPECT_NE(problemOf("\"heights\": [" + sixteen + ", 5]").find("found 17 entries"), std::string::npos);
    EXPECT_NE(problemOf("\"heights\": [" + sixteen + "], \"random\": 1").find("more than one net"), std::string::npos);
    EXPECT_NE(problemOf("").find("no net"), std::string::npos);
    EXPECT_NE(problemOf("\"random\": 1.5").find("no whole number"), std::string::npos);
    EXPECT_NE(problemOf("\"random\": -1").find("outside the limits"), std::string::npos);
    EXPECT_NE(problemOf("\"heights\": [1e7,2,3,4, 1,2,3,4, 1,2,3,4, 1,2,3,4]").find("outside the limits"),
              std::string::npos);
    EXPECT_NE(problemOf("\"random\": 1, \"size\": [1, 1, 1e5]").find("10000 times"), std::string::npos);
    EXPECT_NE(problemOf("\"heights\": [" + sixteen + "], \"size\": [1e3, 1e6, 1e3]").find("its heights span 3000000"),
              std::string::npos);
}

TEST(FieldLayout, SharesWhatIsEqualAndHasRoomForTheRest) {
    const std::string a = R"({"patch": {"random": 3}})", b = R"({"patch": {"random": 4}})";
    const Scene scene = sceneFrom(R"({"objects": [
        {"sphere": {"center": [0, 0, 0], "radius": 1}}, {"instance": {"of": "a"}},
        {"instance": {"of": "a", "translate": [5, 0, 0]}}, )" + b + R"(], "definitions": {"a": )" + a + "}}");
    const FieldLayout layout = fieldLayoutOf(scene, 32, 256, 1e9);
    ASSERT_EQ(layout.slots.size(), 2U);
    EXPECT_EQ(layout.slotOf, (std::vector<int>{-1, 0, 0, 1}));
    EXPECT_EQ(layout.samples, 32);
    EXPECT_EQ(layout.size, glm::ivec3(64, 32, 32));
    EXPECT_EQ(fieldLayoutOf(scene, 32, 256, 2 * 16 * 16 * 16).samples, 16) << "all texels that there may be";
    EXPECT_EQ(fieldLayoutOf(scene, 64, 32, 1e9).size, glm::ivec3(32, 16, 16)) << "no side longer than the GL has";
    EXPECT_TRUE(fieldLayoutOf(sceneNamed("lite"), 64, 256, 1e9).slots.empty());
}

} // namespace
} // namespace gnomon
