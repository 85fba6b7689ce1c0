/// Solids as data: where they end, what their form is, what of them becomes source and what stays a number.
#include "lab/reference/exact/solid.h"
#include "tests/support/scenes.h"
#include "tests/support/solids.h"
#include "tracer/plan/scene_packer.h"
#include "tracer/plan/solid_texels.h"
#include "tracer/scene/read_scene.h"
#include "tracer/shader/shader_builder.h"
#include "tracer/shader/solid_source.h"

#include <gtest/gtest.h>

#include <random>

namespace gnomon {
namespace {

using namespace test;

Scene sceneOf(std::string_view object) { return sceneFrom(R"({"objects": [{)" + std::string(object) + "}]}"); }

std::string problemsOf(std::string_view object) {
    Problems problems;
    EXPECT_FALSE(readScene(R"({"objects": [{)" + std::string(object) + "}]}", "test.json", problems));
    return toString(problems);
}

std::string sourceOf(const Scene& scene) {
    Problems problems;
    const std::string text =
        buildShader("pass/trace.frag", planOf(*prepare(scene), {}, {.blockTexels = 1 << 20}), problems).text;
    EXPECT_TRUE(problems.empty()) << toString(problems);
    return text;
}

class Solid_ : public testing::TestWithParam<SolidExample> {};

TEST_P(Solid_, StandsInItsBall) {
    const Scene scene = sceneOf(GetParam().json);
    const Shape& shape = scene.objects[0].shape;
    ASSERT_EQ(shape.kind, ShapeKind::Solid);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(-2, 2);
    int inside = 0;
    for (int i = 0; i < 40000; ++i) {
        const glm::dvec3 away(coordinate(random), coordinate(random), coordinate(random));
        const glm::dvec3 p = pointOf(shape, "center") + away;
        if (oracle::fieldOf(shape.solid->root, p) > 0) continue;
        ++inside;
        EXPECT_LE(glm::length(away), lengthOf(shape, "radius"));
    }
    EXPECT_GT(inside, 50);
}

TEST_P(Solid_, HasAsManyTexelsAsItsSourceReads) {
    const Scene scene = sceneOf(GetParam().json);
    const Shape& shape = scene.objects[0].shape;
    std::vector<glm::vec4> texels;
    appendTexels(shape, texels);
    EXPECT_EQ(int(texels.size()), texelsOf(*shape.solid));
    EXPECT_NE(sourceOf(scene).find("vec4 fieldSolid0(int at, vec3 p)"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, Solid_, testing::ValuesIn(kSolids),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Solid, NumbersAreNoSource) {
    const char* form =
        R"("difference": [{"sphere": {"center": [0, 0, 0], "radius": %s}}, {"box": {"center": [0, %s, 0],
             "half_size": [1, 1, 1]}}])";
    const auto object = [&](const char* radius, const char* height) {
        char text[400];
        std::snprintf(text, sizeof text, form, radius, height);
        return std::string(text);
    };
    EXPECT_EQ(sourceOf(sceneOf(object("1", "0.5"))), sourceOf(sceneOf(object("2", "-0.7"))));
}

TEST(Solid, SolidsOfOneFormAreOneKind) {
    const std::string ball = R"({"offset": {"by": 0.1, "of": {"sphere": {"center": [0, 0, 0], "radius": 1}}}})";
    const std::string cube = R"({"offset": {"by": 0.2, "of": {"box": {"center": [3, 0, 0], "half_size": [1, 1, 1]}}}})";
    const Scene scene = sceneFrom(R"({"objects": [)" + ball + "," + cube + "," + ball + "]}");
    const SceneFeatures features = planOf(*prepare(scene), {}, {.blockTexels = 1 << 20}).scene;
    ASSERT_EQ(features.shapes.size(), 2u);
    EXPECT_EQ(features.shapes[0].type(), "Solid0");
    EXPECT_EQ(features.shapes[0].count, 2);
    EXPECT_EQ(features.shapes[1].count, 1);
}

TEST(Solid, MovesWithItsBall) {
    const Scene scene = sceneFrom(R"({"objects": [{"motion": {"orbit": {"cos": [2, 0, 0], "rate": 1}},
        "union": [{"sphere": {"center": [5, 0, 0], "radius": 1}}]}]})");
    const Shape moved = shapesAt(scene, 0)[0];
    EXPECT_EQ(pointOf(moved, "center"), glm::dvec3(7, 0, 0));
    std::vector<glm::vec4> texels;
    appendTexels(moved, texels);
    EXPECT_EQ(texels[1], glm::vec4(0, 0, 0, 1)) << "its parts are told from its middle";
}

TEST(Solid, BadOnesAreRefusedWithAReason) {
    EXPECT_NE(
        problemsOf(R"("union": [{"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}}])").find("the solid has no end"),
        std::string::npos);
    EXPECT_NE(problemsOf(R"("union": [])").find("0 entries"), std::string::npos);
    EXPECT_NE(
        problemsOf(R"("union": [{"spere": {"center": [0, 0, 0], "radius": 1}}])").find("did you mean \"sphere\"?"),
        std::string::npos);
    EXPECT_NE(problemsOf(
                  R"("repetition": {"of": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "period": [3, 0, 0],
                 "count": [2, 2, 1]})")
                  .find("period above 0"),
              std::string::npos);
    EXPECT_NE(problemsOf(R"("repetition": {"of": {"sphere": {"center": [0, 0, 0], "radius": 3}}, "period": [1, 1, 1],
                           "count": [9, 9, 9]})")
                  .find("copies that reach over 7 x 7 x 7 of one another"),
              std::string::npos);
    EXPECT_NE(problemsOf(R"("offset": {"by": 1})").find("missing key \"of\""), std::string::npos);
    EXPECT_NE(problemsOf(R"("mandelbulb": {"center": [0, 0, 0], "radius": 1, "power": 1.5, "iterations": 4})")
                  .find("power: 1.5 is outside the limits; use a number from 2 to 16"),
              std::string::npos);
    std::string many = R"("union": [)";
    for (int i = 0; i < 32; ++i)
        many += R"({"offset": {"by": 0.1, "of": {"sphere": {"center": [0, 0, 0], "radius": 1}}}},)";
    many.back() = ']';
    EXPECT_NE(problemsOf(many).find("a solid of 65 parts, operations counted"), std::string::npos);
    const auto spheres = [](int count) {
        std::string all = R"("union": [)";
        for (int i = 0; i < count; ++i) all += R"({"sphere": {"center": [0, 0, 0], "radius": 1}},)";
        all.back() = ']';
        return all;
    };
    EXPECT_EQ(sceneOf(spheres(63)).objects.size(), 1U);
    EXPECT_NE(problemsOf(spheres(64)).find("64 entries; use 1 to 63 entries"), std::string::npos);
}

} // namespace
} // namespace gnomon
