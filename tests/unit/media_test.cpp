/// Which media a scene has, by what rank, and which of them the eye is in.

#include "lab/reference/exact/exact_shape.h"
#include "lab/reference/exact/solid.h"
#include "tests/support/scenes.h"
#include "tests/support/solids.h"
#include "tracer/plan/media.h"
#include "tracer/plan/plan.h"
#include "tracer/scene/signed_distance.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace gnomon {
namespace {

using namespace test;

Scene clear(const std::string& objects) {
    return sceneFrom(R"({"materials": {"glass": {"dielectric": {"ior": 1.5}}, "water": {"dielectric": {"ior": 1.33}},
        "thin": {"dielectric": {"ior": 0.9}}, "dye": {"dielectric": {"ior": 1.3, "absorption": 1}},
        "ice": {"dielectric": {"ior": 1.31, "priority": 2}}, "clay": {"diffuse": 1},
        "gold": {"conductor": {"n": 0.2, "k": 3}}}, "objects": [)" +
                     objects + "]}");
}

std::string ball(const char* material, double x, double radius, const std::string& more = {}) {
    return R"({"sphere": {"center": [)" + std::to_string(x) + R"(, 0, 0], "radius": )" + std::to_string(radius) +
           R"(}, "material": ")" + material + "\"" + more + "}";
}

using Ranks = std::vector<int>;

// The stated priority first, then the smaller body, then the first of the file.
TEST(MediaRanks, FollowPriorityThenSizeThenOrder) {
    const auto ranks = [](const std::string& objects) { return mediaOf(clear(objects)).ranks; };
    EXPECT_EQ(ranks(ball("glass", 0, 2) + "," + ball("water", 0, 1) + "," + ball("clay", 0, 0.5)), (Ranks{1, 2, 0}));
    EXPECT_EQ(ranks(ball("water", 0, 1) + "," + ball("glass", 0, 2)), (Ranks{2, 1}));
    EXPECT_EQ(ranks(ball("ice", 0, 3) + "," + ball("glass", 0, 2)), (Ranks{2, 1}));
    EXPECT_EQ(ranks(ball("glass", 0, 1) + "," + ball("water", 1, 1)), (Ranks{2, 1}));
    EXPECT_EQ(
        ranks(R"({"box": {"center": [0,0,0], "half_size": [1,1,1]}, "material": "glass"},)" + ball("water", 0, 1)),
        (Ranks{1, 2}))
        << "they fill the same box";
    EXPECT_EQ(ranks(R"({"plane": {"point": [0,0,0], "normal": [0,1,0]}, "material": "water"},)" + ball("glass", 0, 9)),
              (Ranks{1, 2}));
}

TEST(MediaRanks, TakeDiscsAndTrianglesOfAMaterialAsOneSkin) {
    const std::string side = R"({"triangle": {"vertices": [[0,0,0],[4,0,0],[0,4,0]]}, "material": "glass"})";
    EXPECT_EQ(mediaOf(clear(side + "," + side + "," + ball("water", 0, 1))).ranks, (Ranks{-1, -1, 2}));
    EXPECT_FALSE(mediaOf(clear(side + "," + side)).tracked);
}

// Rays need not know where they are as long as bodies lie apart.
TEST(Media, AreTrackedOnlyWhereAScenesBodiesMayMeet) {
    const auto tracked = [](const std::string& objects) { return mediaOf(clear(objects)).tracked; };
    const std::string orbit = R"(, "motion": {"orbit": {"cos": [1, 0, 0], "sin": [0, 0, 1]}})";
    const std::string pool = R"(, {"plane": {"point": [0, -1.5, 0], "normal": [0, 1, 0]}, "material": "water"})";
    EXPECT_FALSE(tracked(ball("glass", 0, 1)));
    EXPECT_FALSE(tracked(ball("glass", 0, 1) + "," + ball("clay", 0, 0.5)));
    EXPECT_TRUE(tracked(ball("glass", 0, 1) + "," + ball("gold", 0, 0.5))) << "which reflects otherwise in glass";
    EXPECT_FALSE(tracked(ball("glass", 0, 1) + "," + ball("gold", 2, 1))) << "they touch";
    EXPECT_FALSE(tracked(ball("gold", 0, 1) + "," + ball("gold", 0, 0.5)));
    EXPECT_FALSE(tracked(ball("glass", 0, 1) + "," + ball("glass", 2.1, 1)));
    EXPECT_TRUE(tracked(ball("glass", 0, 1) + "," + ball("glass", 2.1, 1, orbit)));
    EXPECT_TRUE(tracked(ball("glass", 0, 1) + "," + ball("glass", 2, 1))) << "they touch";
    EXPECT_TRUE(tracked(ball("glass", 0, 1) + "," + ball("water", 0, 0.5)));
    EXPECT_FALSE(tracked(ball("glass", 0, 1) + pool));
    EXPECT_TRUE(tracked(ball("glass", 0, 1.6) + pool));
    EXPECT_TRUE(tracked(ball("dye", 0, 1)));
    EXPECT_TRUE(tracked(ball("thin", 0, 1)));
    for (const char* name : {"lite", "pro", "shapes", "solids"})
        EXPECT_FALSE(mediaOf(sceneNamed(name)).tracked) << name;
}

TEST(Media, OfAPointAreTheFourOfHighestRank) {
    std::string objects;
    for (int i = 0; i < 6; ++i) objects += (i > 0 ? "," : "") + ball("glass", 0, 6 - i);
    const Scene scene = clear(objects);
    const Media media = mediaOf(scene);
    const auto at = [&](double x) { return mediaAt(media, shapesAt(scene, 0), {x, 0, 0}); };
    EXPECT_EQ(at(7), glm::ivec4(0));
    EXPECT_EQ(at(4.5), glm::ivec4(2, 1, 0, 0));
    EXPECT_EQ(at(0), glm::ivec4(6, 5, 4, 3));
}

// What is told of a body's inside is what the oracle says.
TEST(SignedDistance, IsTheOracles) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1.5, 1.5);
    const Scene scene = sceneFrom(R"({"objects": [
        {"sphere": {"center": [0.1, 0, 0.2], "radius": 0.8}}, {"plane": {"point": [0, 0.2, 0], "normal": [0.2, 1, 0]}},
        {"torus": {"center": [0, 0.1, 0], "axis": [0.2, 1, 0.1], "major_radius": 0.8, "minor_radius": 0.3}},
        {"box": {"center": [0, 0.1, 0], "half_size": [0.8, 0.4, 0.6]}},
        {"box": {"center": [0, 0.1, 0], "half_size": [0.8, 0.4, 0.6], "rotate": [10, 40, -70]}},
        {"ellipsoid": {"center": [0, 0.1, 0], "radii": [0.9, 0.2, 0.5], "rotate": [10, 40, -70]}},
        {"cylinder": {"from": [0, -0.7, 0.1], "to": [0.3, 0.8, 0], "radius": 0.5}},
        {"capsule": {"from": [0, -0.7, 0.1], "to": [0.3, 0.8, 0], "radius": 0.5}},
        {"cone": {"from": [0, -0.7, 0.1], "to": [0.3, 0.8, 0], "radius": 0.9}},
        {"disc": {"center": [0, 0.1, 0], "normal": [0.2, 1, 0.1], "radius": 0.7}},
        {"triangle": {"vertices": [[-0.7, -0.5, 0], [0.7, -0.4, 0.2], [0.1, 0.7, -0.1]]}}]})");
    for (const Object& object : scene.objects)
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 p(number(random), number(random), number(random));
            const oracle::ExactShape<double> exact(object.shape, oracle::Values::OfTheScene);
            const auto from = oracle::Vec3<long double>(p) - exact.middle();
            ASSERT_NEAR(signedDistance(object.shape, p), exact.boundedDistance(oracle::Vec3<double>(from)), 1e-12);
        }
}

// Solids, a Mandelbulb only by its sign, wherever they have moved.
TEST(SignedDistance, OfSolidsIsTheOraclesToo) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const SolidExample& sample : kSolids) {
        const Scene scene = sceneFrom(std::string(R"({"objects": [{)") + std::string(sample.json) + "}]}");
        const Shape shape = translated(scene.objects[0].shape, {1, 2, 3});
        for (int i = 0; i < 500; ++i) {
            const glm::dvec3 p =
                shape.home + lengthOf(shape, "radius") * glm::dvec3(number(random), number(random), number(random));
            const double field = oracle::fieldOf(shape.solid->root, p),
                         told = signedDistance(shape, p + glm::dvec3(1, 2, 3));
            if (std::abs(field) > 1e-3) {
                ASSERT_EQ(told < 0, field < 0) << sample.name;
            }
        }
    }
}

} // namespace
} // namespace gnomon
