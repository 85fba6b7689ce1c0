#include "tracer/render/pace.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

/// Draws `pictures` on a GPU that takes `fullSeconds` for a full one; the last scale.
double settle(Pace& pace, double fullSeconds, int pictures = 20) {
    for (int i = 0; i < pictures; ++i) pace.took(fullSeconds * pace.scale() * pace.scale(), pace.scale());
    return pace.scale();
}

TEST(Pace, BeginsWithAQuickPicture) {
    EXPECT_LT(Pace().scale(), 0.5);
    EXPECT_TRUE(Pace().slow());
}

TEST(Pace, IsFullAfterOnePictureOnAFastGpu) {
    Pace pace;
    EXPECT_EQ(settle(pace, 0.004, 1), 1.0);
    EXPECT_FALSE(pace.slow());
}

TEST(Pace, KeepsAMovingPictureWithinATenthOfASecond) {
    for (double full : {0.15, 0.3, 0.9, 2.0, 5.0}) {
        Pace pace;
        const double scale = settle(pace, full);
        EXPECT_LE(full * scale * scale, 0.1) << full;
        EXPECT_TRUE(pace.slow());
    }
}

TEST(Pace, DoesNotSwingBetweenTwoScales) {
    for (double full = 0.02; full < 6; full *= 1.03) {
        Pace pace;
        const double settled = settle(pace, full);
        EXPECT_EQ(settle(pace, full, 1), settled) << full;
        EXPECT_EQ(settle(pace, full, 1), settled) << full;
    }
}

TEST(Pace, GoesBackToFullWhenTheViewBecomesCheap) {
    Pace pace;
    settle(pace, 3);
    EXPECT_EQ(settle(pace, 0.01), 1.0);
}

TEST(Pace, CutsAStillPictureIntoBandsOfATwentiethOfASecond) {
    Pace pace;
    settle(pace, 2);
    EXPECT_EQ(pace.rows(600), 15);
    settle(pace, 100);
    EXPECT_EQ(pace.rows(600), 1) << "never none";
    settle(pace, 0.01);
    EXPECT_EQ(pace.rows(600), 600) << "never more than there are";
}

} // namespace
} // namespace gnomon
