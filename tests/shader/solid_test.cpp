/// Distance objects on the GPU against their trees evaluated in double: the generated field, its gradient, and what
/// rays meet in each way of marching.
#include "lab/batch/distance_batch.h"
#include "lab/reference/exact/solid.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tests/support/solids.h"
#include "tracer/plan/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gnomon {
namespace {

using namespace test;

Scene sceneOf(const SolidExample& solid) {
    return sceneFrom(R"({"camera": {"eye": [2.1, 1.4, 3.4], "target": [0, 0, 0]}, "objects": [{)" +
                     std::string(solid.json) + "}]}");
}

const SolidNode& treeOf(const Scene& scene) { return scene.objects[0].shape.solid->root; }

glm::dvec3 slopeOf(const SolidNode& tree, glm::dvec3 p) {
    const double h = 1e-5;
    glm::dvec3 slope;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 step(0);
        step[i] = h;
        slope[i] = (oracle::fieldOf(tree, p + step) - oracle::fieldOf(tree, p - step)) / (2 * h);
    }
    return slope;
}

/// Where the field bends within 1e-4, as about an edge of it, differences say nothing.
bool smoothAt(const SolidNode& tree, glm::dvec3 p) {
    const glm::dvec3 slope = slopeOf(tree, p);
    for (int i = 0; i < 6; ++i) {
        glm::dvec3 step(0);
        step[i / 2] = i % 2 ? 1e-4 : -1e-4;
        if (glm::distance(slopeOf(tree, p + step), slope) > 1e-2) return false;
    }
    return true;
}

std::vector<BatchPoint> pointsAbout(const Scene& scene, int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-1.4, 1.4);
    const Shape& solid = scene.objects[0].shape;
    const glm::dvec3 center = pointOf(solid, "center");
    const double radius = lengthOf(solid, "radius");
    std::vector<BatchPoint> points;
    for (int i = 0; i < count; ++i)
        points.push_back(
            {glm::vec3(center + radius * glm::dvec3(coordinate(random), coordinate(random), coordinate(random)))});
    return points;
}

class Solids : public testing::TestWithParam<SolidExample> {
  protected:
    void SetUp() override { offscreen(); }
    Scene scene_ = sceneOf(GetParam());
    bool estimated_ = scene_.objects[0].shape.solid->root.shape.kind == ShapeKind::Mandelbulb;
};

TEST_P(Solids, TellTheFieldOfTheirTree) {
    Problems problems;
    DistanceBatch batch(scene_, problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    const auto points = pointsAbout(scene_, 20000);
    const auto answers = batch.measure(points);
    // The estimate's orbit doubles what rounding does to it again and again near the set.
    const double roundings = estimated_ ? 3000 : 24;
    const SolidNode& tree = treeOf(scene_);
    int smooth = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 p(points[i].p);
        ASSERT_NEAR(answers[i].distance, oracle::fieldOf(tree, p),
                    roundings * 0x1p-23 * 2 * lengthOf(scene_.objects[0].shape, "radius"))
            << "point " << i;
        if (estimated_ || i % 8 != 0 || !smoothAt(tree, p)) continue;
        ++smooth;
        ASSERT_LE(glm::distance(glm::dvec3(answers[i].gradient), slopeOf(tree, p)), 2e-3) << "point " << i;
    }
    EXPECT_GT(smooth, estimated_ ? -1 : 1000);
}

/// Where a ray first has the solid behind its surface, to a few 1e-6 over its slant; infinity where it never has.
/// `grazed` is the least that the ray receded from beforehand, over the width of the pixel's cone.
double firstHit(const SolidNode& tree, glm::dvec3 eye, glm::dvec3 direction, double pixel, double& grazed) {
    double t = 0, before = 1e30;
    grazed = 1e30;
    for (int i = 0; i < 40000 && t < 10; ++i) {
        const double free = oracle::fieldOf(tree, eye + t * direction);
        if (free < -1e-6) return t;
        const double width = free / (pixel * t + 1e-12);
        if (width > before) grazed = std::min(grazed, before);
        before = width;
        t += std::max(free, 2e-6);
    }
    return INFINITY;
}

struct Seen {
    FloatImage distance, position, normal;
};

Seen look(const Scene& scene, March march) {
    Settings settings;
    settings.size = {64, 48};
    settings.march = march;
    settings.marchSteps = march == March::Steps ? 2000 : 1024;
    return {outputOf(scene, settings, Aov::Distance), outputOf(scene, settings, Aov::Position),
            outputOf(scene, settings, Aov::Normal)};
}

TEST_P(Solids, AreMetWhereTheirFieldIsZero) {
    const CameraFrame camera = frameOf(scene_.camera);
    const double pixel = 2 * camera.halfHeight / 48;
    for (const March march : {March::Steps, March::Sphere, March::Cone, March::Relaxed}) {
        const Seen seen = look(scene_, march);
        int met = 0, compared = 0, smooth = 0, across = 0;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) {
                const double u = (2 * (x + 0.5) / 64 - 1) * 64.0 / 48, v = 1 - 2 * (y + 0.5) / 48;
                const glm::dvec3 direction =
                    glm::normalize(camera.forward + camera.halfHeight * (u * camera.right + v * camera.up));
                double grazed;
                const double exact = firstHit(treeOf(scene_), camera.eye, direction, pixel, grazed);
                const float t = *seen.distance.at(x, y);
                if (estimated_ && grazed < 1) continue; // a pixel wide, it may be either
                ++compared;
                ASSERT_EQ(std::isinf(t), std::isinf(exact)) << "pixel " << x << " " << y << " march " << int(march);
                if (std::isinf(exact)) continue;
                ++met;
                const glm::dvec3 normal(seen.normal.at(x, y)[0], seen.normal.at(x, y)[1], seen.normal.at(x, y)[2]);
                if (estimated_ && march >= March::Cone) { // where the cone first holds some of the surface
                    ASSERT_LE(t, exact + 1e-4) << "pixel " << x << " " << y;
                    ASSERT_LE(oracle::fieldOf(treeOf(scene_), camera.eye + double(t) * direction), 0.51 * pixel * t);
                } else if (!estimated_) {
                    const double slant = std::max(-glm::dot(normal, direction), 0.05); // against the ray
                    ASSERT_NEAR(t, exact, 2e-4 / slant) << "pixel " << x << " " << y << " march " << int(march);
                }
                const glm::dvec3 p(seen.position.at(x, y)[0], seen.position.at(x, y)[1], seen.position.at(x, y)[2]);
                // An estimate jumps where an orbit escapes a round later.
                const double cone = 0.5 * pixel * exact;
                const double off = !estimated_ ? 2e-5 : march >= March::Cone ? cone : 2e-3;
                ASSERT_LE(std::abs(oracle::fieldOf(treeOf(scene_), p)), off) << "pixel " << x << " " << y;
                ASSERT_NEAR(glm::length(normal), 1, 1e-5);
                across += glm::dot(normal, direction) > -0.01;
                const double miss = oracle::fieldOf(treeOf(scene_), camera.eye + double(t) * direction);
                if (!estimated_) { // the bound of sdf/solid.glsl, and roundings of t
                    ASSERT_LE(std::abs(miss), 0x1p-18 * lengthOf(scene_.objects[0].shape, "radius") + 0x1p-23 * t)
                        << "pixel " << x << " " << y << " march " << int(march);
                }
                if (!estimated_ && smoothAt(treeOf(scene_), p)) {
                    ++smooth;
                    ASSERT_GT(glm::dot(normal, glm::normalize(slopeOf(treeOf(scene_), p))), 0.9998) // a degree
                        << "pixel " << x << " " << y << " march " << int(march);
                }
            }
        EXPECT_GT(met, 100) << int(march);
        EXPECT_LT(across, met / 4) << int(march) << ": normals that are turned, not seen from outside";
        EXPECT_GT(compared, 1500) << int(march);
        EXPECT_GT(smooth, estimated_ ? -1 : 100) << int(march);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Solids, testing::ValuesIn(kSolids),
                         [](const auto& test) { return std::string(test.param.name); });

/// Marching goes the same steps whatever was met before, so that of equal solids the first is met.
TEST(EqualSolids, AreMetAtTheFirst) {
    offscreen();
    const std::string two = R"({"union": [{"sphere": {"center": [0, 0, 0], "radius": 1}},
        {"box": {"center": [1, 0, 0], "half_size": [0.5, 0.5, 0.5]}}]})";
    const Scene scene =
        sceneFrom(R"({"camera": {"eye": [0, 1, 4], "target": [0, 0, 0]}, "objects": [)" + two + ", " + two + "]}");
    Settings settings;
    settings.size = {64, 48};
    for (const March march : {March::Steps, March::Sphere, March::Cone, March::Relaxed})
        for (const Accel accel : {Accel::None, Accel::Hierarchy}) {
            settings.march = march;
            settings.accel = accel;
            const FloatImage objects = outputOf(scene, settings, Aov::Object);
            EXPECT_EQ(std::count(objects.pixels.begin(), objects.pixels.end(), 1.0f), 0) << int(march) << int(accel);
            EXPECT_GT(std::count(objects.pixels.begin(), objects.pixels.end(), 0.0f), 1000);
        }
}

/// What is taken from itself is gone: its surface has nothing behind it.
TEST(EqualSolids, LeaveNothingOfOneAnother) {
    offscreen();
    const Scene scene = sceneFrom(R"({"camera": {"eye": [0, 1, 4], "target": [0, 0, 0]}, "objects": [{"difference": [
        {"sphere": {"center": [0, 0, 0], "radius": 1}}, {"sphere": {"center": [0, 0, 0], "radius": 1}}]}]})");
    Settings settings;
    settings.size = {64, 48};
    for (const March march : {March::Steps, March::Sphere, March::Cone, March::Relaxed}) {
        settings.march = march;
        const FloatImage objects = outputOf(scene, settings, Aov::Object);
        EXPECT_EQ(std::count(objects.pixels.begin(), objects.pixels.end(), 0.0f), 0) << int(march);
    }
}

TEST(Mandelbulb, EstimatesFromBelow) {
    offscreen();
    const Scene scene =
        sceneFrom(R"({"objects": [{"mandelbulb": {"center": [0, 0, 0], "radius": 1, "power": 8, "iterations": 8}}]})");
    Problems problems;
    DistanceBatch batch(scene, problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    const auto points = pointsAbout(scene, 4000);
    const auto answers = batch.measure(points);
    std::mt19937 random(3);
    std::normal_distribution<double> any;
    int outside = 0, inside = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (answers[i].distance <= 0) {
            ++inside;
            continue;
        }
        ++outside;
        for (int k = 0; k < 64; ++k) {
            const glm::dvec3 way = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
            const glm::dvec3 at = glm::dvec3(points[i].p) + 0.99 * double(answers[i].distance) * way;
            ASSERT_GT(oracle::fieldOf(treeOf(scene), at), 0) << "point " << i << " told " << answers[i].distance;
        }
    }
    EXPECT_GT(outside, 1000);
    EXPECT_GT(inside, 40);
}

} // namespace
} // namespace gnomon
