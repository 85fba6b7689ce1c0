/// ScreenPartition of a picture hold what they say of every pixel: no ray through the sky meets a box, none through the
/// base one that is uncommon; and they are worth having: most of what could be sky is.
#include "tests/support/clouds.h"
#include "tracer/software/screen_partition.h"

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
bool meets(const Picture& picture, glm::dvec3 ray, const ScreenBounds& seen) {
    if (!seen.bounds) return true;
    const glm::dvec3 low = glm::dvec3(seen.bounds->low) - picture.camera.eye;
    const glm::dvec3 high = glm::dvec3(seen.bounds->high) - picture.camera.eye;
    if (seen.round) {
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
    int sky = 0, base = 0, uncommon = 0; ///< pixels of the partition
    int emptySeen = 0, commonSeen = 0;   ///< pixels that see nothing; nothing uncommon, but something
    int wrong = 0, uncovered = 0, doubled = 0;
};

Counts countIn(const Picture& picture, const std::vector<ScreenBounds>& screenBounds) {
    const ScreenPartition partition = partitionOf(screenBounds, picture.camera, picture.width, picture.height);
    std::vector<int> region(std::size_t(picture.width) * picture.height, -1);
    Counts counts;
    const std::vector<Rectangle>* lists[] = {&partition.sky, &partition.base, &partition.uncommon};
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
            bool any = false, uncommon = false;
            for (const ScreenBounds& seen : screenBounds) {
                if (!meets(picture, picture.ray(x, y), seen)) continue;
                any = true;
                uncommon |= seen.uncommon;
            }
            const int at = region[std::size_t(y) * picture.width + x];
            counts.uncovered += at < 0;
            counts.wrong += (at == 0 && any) || (at == 1 && uncommon);
            counts.sky += at == 0;
            counts.base += at == 1;
            counts.uncommon += at == 2;
            counts.emptySeen += !any;
            counts.commonSeen += any && !uncommon;
        }
    return counts;
}

ScreenBounds box(glm::dvec3 middle, glm::dvec3 half, bool uncommon = false, bool round = false) {
    return {Bounds{glm::vec3(middle - half), glm::vec3(middle + half)}, round, uncommon};
}

Picture pictureFrom(glm::dvec3 eye, glm::dvec3 target, double fov, int width = 203, int height = 151) {
    return {frameOf({eye, target, {0, 1, 0}, fov}), width, height};
}

void expectRight(const Counts& counts, const std::string& what) {
    EXPECT_EQ(counts.wrong, 0) << what;
    EXPECT_EQ(counts.uncovered, 0) << what;
    EXPECT_EQ(counts.doubled, 0) << what;
}

TEST(ScreenPartition, HoldWhatTheySayFromAnywhere) {
    Dice dice(7);
    for (int scene = 0; scene < 60; ++scene) {
        std::vector<ScreenBounds> screenBounds;
        const int objects = 1 + scene % 9;
        for (int i = 0; i < objects; ++i) {
            const bool round = i % 2 == 0;
            const double radius = dice.number(0.02, 0.4);
            const glm::dvec3 half =
                round ? glm::dvec3(radius) : glm::dvec3(dice.number(0, 0.5), dice.number(0, 0.5), dice.number(0, 0.5));
            screenBounds.push_back(box(dice.point(1.5), half, i % 3 == 1, round));
        }
        // From outside, from within, past things, with all angles of view.
        const glm::dvec3 eye = dice.point(scene % 3 == 0 ? 0.7 : 6), target = dice.point(1);
        const Picture picture = pictureFrom(eye, target, dice.number(5, 150), 97 + scene, 61 + 2 * scene);
        expectRight(countIn(picture, screenBounds), "scene " + std::to_string(scene));
    }
}

TEST(ScreenPartition, AreWorthIt) {
    Dice dice(11);
    std::vector<ScreenBounds> screenBounds;
    for (int i = 0; i < 12; ++i) screenBounds.push_back(box(dice.point(1), glm::dvec3(0.15), i < 3, true));
    const Counts counts = countIn(pictureFrom({0, 0, 6}, {0, 0, 0}, 40, 800, 600), screenBounds);
    expectRight(counts, "cloud");
    EXPECT_GT(counts.sky, 0.85 * counts.emptySeen);
    EXPECT_GT(counts.base, 0.6 * counts.commonSeen);
    EXPECT_GT(counts.uncommon, 0);
}

TEST(ScreenPartition, OfNothingAreAllSky) {
    const ScreenPartition partition = partitionOf({}, frameOf({}), 100, 75);
    EXPECT_EQ(partition.sky, (std::vector<Rectangle>{{0, 0, 100, 75}}));
    EXPECT_TRUE(partition.base.empty());
    EXPECT_TRUE(partition.uncommon.empty());
}

TEST(ScreenPartition, WithoutBoundsAreWhatMayBeThere) {
    const ScreenBounds plane{{}, false, false}, rarePlane{{}, false, true},
        ball = box({0, 0, 0}, glm::dvec3(0.1), true, true);
    const ScreenPartition base = partitionOf(std::vector{plane, ball}, frameOf({}), 160, 120);
    EXPECT_TRUE(base.sky.empty());
    EXPECT_FALSE(base.base.empty());
    EXPECT_FALSE(base.uncommon.empty());
    EXPECT_EQ(partitionOf(std::vector{rarePlane}, frameOf({}), 160, 120).uncommon,
              (std::vector<Rectangle>{{0, 0, 160, 120}}));
}

TEST(ScreenPartition, LeaveOutWhatLiesBehindTheEye) {
    const ScreenPartition partition =
        partitionOf(std::vector{box({0, 0, 9}, glm::dvec3(2), true, true)}, frameOf({}), 64, 48);
    EXPECT_EQ(partition.sky, (std::vector<Rectangle>{{0, 0, 64, 48}}));
}

} // namespace
} // namespace gnomon
