#include "tracer/render/pace.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon {
namespace {

/// A GPU that takes `full` seconds for a full picture, in a host that adds `overhead` to every one.
struct Gpu {
    double full, overhead = 0.02;
};

/// Draws so many moving pictures; how many of them took longer than 0.15 s.
int draw(Pace& pace, Gpu gpu, int pictures) {
    int slow = 0;
    for (int i = 0; i < pictures; ++i) {
        const double seconds = gpu.overhead + gpu.full * pace.scale() * pace.scale();
        slow += seconds > 0.15;
        pace.tookPicture(seconds);
    }
    return slow;
}

TEST(Pace, BeginsWithAQuickPicture) {
    EXPECT_LT(Pace().scale(), 0.5);
    EXPECT_TRUE(Pace().slow());
}

TEST(Pace, IsFullAfterAFewPicturesOnAFastGpuHoweverLongTheHostTakesToTell) {
    for (double overhead : {0.001, 0.017, 0.05}) {
        Pace pace;
        draw(pace, {0.004, overhead}, 4);
        EXPECT_EQ(pace.scale(), 1.0) << overhead;
        EXPECT_FALSE(pace.slow());
    }
}

TEST(Pace, KeepsNearlyAllMovingPicturesWithinTheirTimeOnASlowGpu) {
    for (double full : {0.2, 0.3, 0.9, 2.0, 3.0}) {
        Pace pace;
        draw(pace, {full}, 20);
        EXPECT_LE(draw(pace, {full}, 400), 8) << full;
    }
}

TEST(Pace, DoesNotStayCoarserThanItMust) {
    for (double full : {0.2, 0.5, 1.0, 2.0}) {
        Pace pace;
        draw(pace, {10}, 5); // something very slow before
        draw(pace, {full}, 800);
        const double seconds = 0.02 + full * pace.scale() * pace.scale();
        EXPECT_GE(seconds, 0.05) << full << ": a picture that quick could be finer";
    }
}

TEST(Pace, GoesBackToFullWhenTheViewBecomesCheap) {
    Pace pace;
    draw(pace, {3}, 20);
    draw(pace, {0.01}, 100);
    EXPECT_EQ(pace.scale(), 1.0);
}

TEST(Pace, CutsAStillPictureIntoBandsOfATenthOfASecond) {
    for (double full : {0.01, 0.5, 4.0, 60.0}) {
        Pace pace;
        const int height = 600;
        double seconds = 0;
        for (int i = 0; i < 30; ++i) pace.tookBand(seconds = 0.01 + full * pace.rows(height) / height);
        EXPECT_LE(seconds, 0.16) << full;
        EXPECT_TRUE(seconds >= 0.05 || pace.rows(height) == height) << full;
    }
}

TEST(Pace, NeverGivesABandOfNoRows) {
    Pace pace;
    for (int i = 0; i < 30; ++i) pace.tookBand(100);
    EXPECT_EQ(pace.rows(600), 1);
}

} // namespace
} // namespace gnomon
