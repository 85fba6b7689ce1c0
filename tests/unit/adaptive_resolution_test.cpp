#include "tracer/render/adaptive_resolution.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon {
namespace {

/// A GPU that takes `full` seconds for a full picture, in a host that adds `overhead` to every one.
struct Gpu {
    double full, overhead = 0.02;
};

/// Draws so many moving pictures; how many of them took longer than 0.15 s.
int draw(AdaptiveResolution& adaptive, Gpu gpu, int pictures) {
    int slow = 0;
    for (int i = 0; i < pictures; ++i) {
        const double seconds = gpu.overhead + gpu.full * adaptive.scale() * adaptive.scale();
        slow += seconds > 0.15;
        adaptive.tookPicture(seconds);
    }
    return slow;
}

TEST(AdaptiveResolution, BeginsWithAQuickPicture) {
    EXPECT_LT(AdaptiveResolution().scale(), 0.5);
    EXPECT_TRUE(AdaptiveResolution().slow());
}

TEST(AdaptiveResolution, IsFullAfterAFewPicturesOnAFastGpuHoweverLongTheHostTakesToTell) {
    for (double overhead : {0.001, 0.017, 0.05}) {
        AdaptiveResolution adaptive;
        draw(adaptive, {0.004, overhead}, 4);
        EXPECT_EQ(adaptive.scale(), 1.0) << overhead;
        EXPECT_FALSE(adaptive.slow());
    }
}

TEST(AdaptiveResolution, KeepsNearlyAllMovingPicturesWithinTheirTimeOnASlowGpu) {
    for (double full : {0.2, 0.3, 0.9, 2.0, 3.0}) {
        AdaptiveResolution adaptive;
        draw(adaptive, {full}, 20);
        EXPECT_LE(draw(adaptive, {full}, 400), 8) << full;
    }
}

TEST(AdaptiveResolution, DoesNotStayCoarserThanItMust) {
    for (double full : {0.2, 0.5, 1.0, 2.0}) {
        AdaptiveResolution adaptive;
        draw(adaptive, {10}, 5); // something very slow before
        draw(adaptive, {full}, 800);
        const double seconds = 0.02 + full * adaptive.scale() * adaptive.scale();
        EXPECT_GE(seconds, 0.05) << full << ": a picture that quick could be finer";
    }
}

TEST(AdaptiveResolution, GoesBackToFullWhenTheViewBecomesCheap) {
    AdaptiveResolution adaptive;
    draw(adaptive, {3}, 20);
    draw(adaptive, {0.01}, 100);
    EXPECT_EQ(adaptive.scale(), 1.0);
}

TEST(AdaptiveResolution, CutsAStillPictureIntoBandsOfATenthOfASecond) {
    for (double full : {0.01, 0.5, 4.0, 60.0}) {
        AdaptiveResolution adaptive;
        const int height = 600;
        double seconds = 0;
        for (int i = 0; i < 30; ++i) adaptive.tookBand(seconds = 0.01 + full * adaptive.rows(height) / height);
        EXPECT_LE(seconds, 0.16) << full;
        EXPECT_TRUE(seconds >= 0.05 || adaptive.rows(height) == height) << full;
    }
}

TEST(AdaptiveResolution, NeverGivesABandOfNoRows) {
    AdaptiveResolution adaptive;
    for (int i = 0; i < 30; ++i) adaptive.tookBand(100);
    EXPECT_EQ(adaptive.rows(600), 1);
}

} // namespace
} // namespace gnomon
