/// Regions of a picture hold what they say of every pixel: no ray through the sky meets a box, none through the usual
/// one that is rare; and they are worth having: most of what could be sky is.
#include "tests/support/clouds.h"
#include "tracer/render/regions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gnomon {
namespace {

using test::Dice;

struct Picture {
    CameraFrame camera;
    int width, height;

    glm::dvec3 ray(int x, int y) const {
        const double up = camera.halfHeight, across = up * width / height;
        return camera.forward + (2 * (x + 0.5) / width - 1) * across * camera.right +
               (2 * (y + 0.5) / height - 1) * up * camera.up;
    }
};

/// Along a ray from the eye, in double.
bool meets(const Picture& picture, glm::dvec3 ray, const Sight& sight) {
    if (!sight.bounds) return true;
    const glm::dvec3 low = glm::dvec3(sight.bounds->low) - picture.camera.eye;
    const glm::dvec3 high = glm::dvec3(sight.bounds->high) - picture.camera.eye;
    if (sight.round) {
        const glm::dvec3 middle = 0.5 * (low + high);
        const double radius = 0.5 * (high.x - low.x), along = glm::dot(middle, ray) / glm::dot(ray, ray);
        const double away = glm::length(middle - std::max(along, 0.0) * ray);
        return away <= radius;
    }
    double from = 0, to = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
        if (ray[axis] == 0) {
            if (low[axis] > 0 || high[axis] < 0) return false;
            continue;
        }
        const double a = low[axis] / ray[axis], b = high[axis] / ray[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

struct Counts {
    int sky = 0, usual = 0, rare = 0;  ///< pixels of the regions
    int emptySeen = 0, commonSeen = 0; ///< pixels that see nothing; nothing rare, but something
    int wrong = 0, uncovered = 0, doubled = 0;
};

Counts countIn(const Picture& picture, const std::vector<Sight>& sights) {
    const Regions regions = regionsOf(sights, picture.camera, picture.width, picture.height);
    std::vector<int> region(std::size_t(picture.width) * picture.height, -1);
    Counts counts;
    const std::vector<Rectangle>* lists[] = {&regions.sky, &regions.usual, &regions.rare};
    for (int which = 0; which < 3; ++which)
        for (const Rectangle& r : *lists[which])
            for (int y = r.y; y < r.y + r.height; ++y)
                for (int x = r.x; x < r.x + r.width; ++x) {
                    int& at = region.at(std::size_t(y) * picture.width + x);
                    counts.doubled += at >= 0;
                    at = which;
                }
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            bool any = false, rare = false;
            for (const Sight& sight : sights) {
                if (!meets(picture, picture.ray(x, y), sight)) continue;
                any = true;
                rare |= sight.rare;
            }
            const int at = region[std::size_t(y) * picture.width + x];
            counts.uncovered += at < 0;
            counts.wrong += (at == 0 && any) || (at == 1 && rare);
            counts.sky += at == 0;
            counts.usual += at == 1;
            counts.rare += at == 2;
            counts.emptySeen += !any;
            counts.commonSeen += any && !rare;
        }
    return counts;
}

Sight box(glm::dvec3 middle, glm::dvec3 half, bool rare = false, bool round = false) {
    return {Bounds{glm::vec3(middle - half), glm::vec3(middle + half)}, round, rare};
}

Picture pictureFrom(glm::dvec3 eye, glm::dvec3 target, double fov, int width = 203, int height = 151) {
    return {frameOf({eye, target, {0, 1, 0}, fov}), width, height};
}

void expectRight(const Counts& counts, const std::string& what) {
    EXPECT_EQ(counts.wrong, 0) << what;
    EXPECT_EQ(counts.uncovered, 0) << what;
    EXPECT_EQ(counts.doubled, 0) << what;
}

TEST(Regions, HoldWhatTheySayFromAnywhere) {
    Dice dice(7);
    for (int scene = 0; scene < 60; ++scene) {
        std::vector<Sight> sights;
        const int objects = 1 + scene % 9;
        for (int i = 0; i < objects; ++i) {
            const bool round = i % 2 == 0;
            const double radius = dice.number(0.02, 0.4);
            const glm::dvec3 half =
                round ? glm::dvec3(radius) : glm::dvec3(dice.number(0, 0.5), dice.number(0, 0.5), dice.number(0, 0.5));
            sights.push_back(box(dice.point(1.5), half, i % 3 == 1, round));
        }
        // From outside, from within, past things, with all angles of view.
        const glm::dvec3 eye = dice.point(scene % 3 == 0 ? 0.7 : 6), target = dice.point(1);
        const Picture picture = pictureFrom(eye, target, dice.number(5, 150), 97 + scene, 61 + 2 * scene);
        expectRight(countIn(picture, sights), "scene " + std::to_string(scene));
    }
}

TEST(Regions, AreWorthIt) {
    Dice dice(11);
    std::vector<Sight> sights;
    for (int i = 0; i < 12; ++i) sights.push_back(box(dice.point(1), glm::dvec3(0.15), i < 3, true));
    const Counts counts = countIn(pictureFrom({0, 0, 6}, {0, 0, 0}, 40, 800, 600), sights);
    expectRight(counts, "cloud");
    EXPECT_GT(counts.sky, 0.85 * counts.emptySeen);
    EXPECT_GT(counts.usual, 0.6 * counts.commonSeen);
    EXPECT_GT(counts.rare, 0);
}

TEST(Regions, OfNothingAreAllSky) {
    const Regions regions = regionsOf({}, frameOf({}), 100, 75);
    EXPECT_EQ(regions.sky, (std::vector<Rectangle>{{0, 0, 100, 75}}));
    EXPECT_TRUE(regions.usual.empty());
    EXPECT_TRUE(regions.rare.empty());
}

TEST(Regions, WithoutBoundsAreWhatMayBeThere) {
    const Sight plane{{}, false, false}, rarePlane{{}, false, true}, ball = box({0, 0, 0}, glm::dvec3(0.1), true, true);
    const Regions usual = regionsOf(std::vector{plane, ball}, frameOf({}), 160, 120);
    EXPECT_TRUE(usual.sky.empty());
    EXPECT_FALSE(usual.usual.empty());
    EXPECT_FALSE(usual.rare.empty());
    EXPECT_EQ(regionsOf(std::vector{rarePlane}, frameOf({}), 160, 120).rare,
              (std::vector<Rectangle>{{0, 0, 160, 120}}));
}

TEST(Regions, LeaveOutWhatLiesBehindTheEye) {
    const Regions regions = regionsOf(std::vector{box({0, 0, 9}, glm::dvec3(2), true, true)}, frameOf({}), 64, 48);
    EXPECT_EQ(regions.sky, (std::vector<Rectangle>{{0, 0, 64, 48}}));
}

} // namespace
} // namespace gnomon
