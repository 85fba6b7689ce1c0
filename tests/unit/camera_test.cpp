// The first-person camera: poses come back, the world stays upright, the scene follows the pointer.
#include "tracer/plan/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace gnomon;

namespace {

constexpr double kHeight = 600; ///< pixels

void expectNear(glm::dvec3 a, glm::dvec3 b, double bound, const std::string& what = {}) {
    EXPECT_LE(glm::distance(a, b), bound)
        << what << ": " << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}

Camera cameraAt(const CameraPose& pose) {
    Camera camera;
    camera.setPose(pose);
    return camera;
}

/// Where a point is seen, in pixels right and down of the middle of the view.
glm::dvec2 pixelOf(const CameraFrame& frame, glm::dvec3 point) {
    const glm::dvec3 way = point - frame.eye;
    const double scale = kHeight / 2 / frame.halfHeight / glm::dot(way, frame.forward);
    return {glm::dot(way, frame.right) * scale, -glm::dot(way, frame.up) * scale};
}

} // namespace

TEST(CameraFrame, IsRightHandedAndOrthonormalForEveryPose) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-50, 50);
    for (int i = 0; i < 1000; ++i) {
        const auto point = [&] { return glm::dvec3{number(random), number(random), number(random)}; };
        const CameraFrame frame = frameOf({point(), point(), point(), 60});
        const glm::dmat3 axes(frame.right, frame.up, -frame.forward);
        EXPECT_NEAR(glm::determinant(axes), 1, 1e-12);
        const glm::dmat3 product = glm::transpose(axes) * axes;
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) EXPECT_NEAR(product[c][r], c == r ? 1 : 0, 1e-12);
    }
}

TEST(CameraFrame, ExistsWhereThePoseLooksAlongItsUpOrAtItsEye) {
    for (glm::dvec3 target :
         {glm::dvec3{0, -9, 0}, glm::dvec3{0, 9, 0}, glm::dvec3{1e-12, 9, 0}, glm::dvec3{0, 0, 0}}) {
        const CameraFrame frame = frameOf({{0, 0, 0}, target, {0, 1, 0}, 40});
        EXPECT_NEAR(glm::length(frame.forward), 1, 1e-12);
        EXPECT_NEAR(glm::length(frame.right), 1, 1e-12);
        EXPECT_NEAR(glm::dot(frame.right, frame.forward), 0, 1e-6);
    }
}

TEST(CameraFrame, HasACanvasOfHalfHeightOneAtDistanceThreeByDefault) {
    EXPECT_NEAR(frameOf(CameraPose{}).halfHeight, 1.0 / 3, 1e-15);
}

TEST(Camera, GivesThePoseBackThatItWasGiven) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-50, 50);
    for (int i = 0; i < 1000; ++i) {
        const auto point = [&] { return glm::dvec3{number(random), number(random), number(random)}; };
        CameraPose pose{point(), point(), i % 2 == 0 ? glm::dvec3{0, 1, 0} : glm::normalize(point()), 47};
        const glm::dvec3 forward = glm::normalize(pose.target - pose.eye);
        if (std::abs(glm::dot(forward, pose.up)) > 0.9999) continue; // the camera tilts these off its pole
        const CameraPose back = cameraAt(pose).pose();
        EXPECT_EQ(back.eye, pose.eye);
        EXPECT_EQ(back.fov, pose.fov);
        expectNear(back.target, pose.target, 1e-11, "target");
        expectNear(frameOf(back).up, frameOf(pose).up, 1e-10, "up");
    }
}

TEST(Camera, KeepsItsPoseThroughManyRoundTrips) {
    const CameraPose pose{{3, 4, 5}, {-7, 1, 2}, {0, 1, 0}, 30};
    Camera camera = cameraAt(pose);
    for (int i = 0; i < 10000; ++i) camera.setPose(camera.pose());
    expectNear(camera.pose().target, pose.target, 1e-9, "target");
}

TEST(Camera, LooksToTheRightAndUpByTheAnglesGiven) {
    Camera camera = cameraAt({{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 40});
    camera.look(std::acos(-1) / 2, 0);
    expectNear(frameOf(camera.pose()).forward, {1, 0, 0}, 1e-12, "a quarter turn right");
    camera.look(0, std::acos(-1) / 4);
    expectNear(frameOf(camera.pose()).forward, {std::sqrt(0.5), std::sqrt(0.5), 0}, 1e-12, "then up");
}

TEST(Camera, NeverFlipsHoweverItIsTurned) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> angle(-4, 4), number(-1, 1);
    for (glm::dvec3 up : {glm::dvec3{0, 1, 0}, glm::dvec3{0, -1, 0}, glm::dvec3{0, 0, 1}, glm::dvec3{1, 2, -3}}) {
        Camera camera = cameraAt({{0, 0, 9}, {number(random), number(random), 0}, up, 40});
        for (int i = 0; i < 2000; ++i) {
            camera.look(angle(random), angle(random));
            const CameraFrame frame = frameOf(camera.pose());
            // Within [0.01, 3.13] of up the frame's own up always has a part along the world's of at least sin 0.01.
            EXPECT_GE(glm::dot(frame.up, glm::normalize(up)), std::sin(0.0099));
        }
    }
}

TEST(Camera, TiltsOffTheZenithByAHundredthAndStaysUsable) {
    Camera camera = cameraAt({{0, 5, 0}, {0, 0, 0}, {0, 1, 0}, 40});
    EXPECT_NEAR(std::acos(glm::dot(frameOf(camera.pose()).forward, {0, -1, 0})), std::acos(-1) - 3.13, 1e-6);
    camera.look(1, 1);
    EXPECT_TRUE(std::isfinite(camera.pose().target.x));
}

TEST(Camera, MovesAlongItsOwnAxes) {
    Camera camera = cameraAt({{1, 2, 3}, {1, 2, -7}, {0, 1, 0}, 40});
    camera.move({2, 3, 4});
    expectNear(camera.pose().eye, {4, 6, 1}, 1e-12, "eye");
    expectNear(camera.pose().target, {4, 6, -9}, 1e-12, "target goes along");
}

// Exact straight up and down, and level to the right; the middle is what a drag of any length starts from.
TEST(Camera, MovesThePointInTheMiddleUnderThePointerOfADrag) {
    for (double fov : {20.0, 36.87, 90.0})
        for (glm::dvec2 drag : {glm::dvec2{100, 0}, {-250, 0}, {0, 80}, {0, -120}, {0.5, 0}}) {
            Camera camera = cameraAt({{0, 0, 35}, {0, 0, 0}, {0, 1, 0}, fov});
            camera.drag(drag.x, drag.y, kHeight);
            const glm::dvec2 seen = pixelOf(frameOf(camera.pose()), {0, 0, 0});
            EXPECT_NEAR(seen.x, drag.x, 1e-9) << fov;
            EXPECT_NEAR(seen.y, drag.y, 1e-9) << fov;
        }
}

// Away from the horizon a turn about the world's up bends the way: within a tenth of the drag up to 60 degrees.
TEST(Camera, FollowsThePointerAlsoWhereItLooksDown) {
    for (double depth : {0.2, 0.6, 1.0, 1.7}) { // tan of the angle below the horizon: 11, 31, 45, 60 degrees
        Camera camera = cameraAt({{0, 0, 10}, {0, -10 * depth, 0}, {0, 1, 0}, 36.87});
        camera.drag(60, 40, kHeight);
        const glm::dvec2 seen = pixelOf(frameOf(camera.pose()), {0, -10 * depth, 0});
        EXPECT_LE(glm::distance(seen, {60, 40}), 0.1 * std::hypot(60, 40)) << depth;
    }
}

TEST(Camera, TurnsByTheAngleOfViewForADragOverTheWholeHeight) {
    Camera camera = cameraAt({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 40});
    for (int pixel = 0; pixel < 600; ++pixel) camera.drag(0, -1, kHeight);
    const double turned = glm::degrees(std::acos(glm::dot(frameOf(camera.pose()).forward, {0, 0, -1})));
    EXPECT_NEAR(turned, 40, 2);
}

TEST(Camera, PansSoThatWhatItLooksAtFollowsThePointer) {
    Camera camera = cameraAt({{3, 4, 20}, {1, 0, 0}, {0, 1, 0}, 50});
    camera.pan(37, -91, kHeight);
    const glm::dvec2 seen = pixelOf(frameOf(camera.pose()), {1, 0, 0});
    EXPECT_NEAR(seen.x, 37, 1e-9);
    EXPECT_NEAR(seen.y, -91, 1e-9);
}

TEST(Camera, HalvesTheDistanceForAPinchToTwice) {
    Camera camera = cameraAt({{0, 0, 8}, {0, 0, 0}, {0, 1, 0}, 50});
    camera.zoom(2);
    expectNear(camera.pose().eye, {0, 0, 4}, 1e-12, "eye");
    camera.zoom(0);
    camera.zoom(-1);
    expectNear(camera.pose().eye, {0, 0, 4}, 1e-12, "no pinch at all");
}

TEST(Camera, IgnoresADragInAViewWithoutHeight) {
    Camera camera = cameraAt(CameraPose{});
    camera.drag(5, 5, 0);
    camera.pan(5, 5, 0);
    EXPECT_EQ(camera.pose().eye, CameraPose{}.eye);
}
