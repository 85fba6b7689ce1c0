/// What rays see that meet nothing: where each image of the background lies, and which way round.
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/plan/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace gnomon {
namespace {

using namespace test;

using Color = std::array<int, 3>;

Color texel(const Image& image, int x, int y) {
    const std::uint8_t* at = &image.rgba[(std::size_t(y) * image.width + x) * 4];
    return {at[0], at[1], at[2]};
}

/// Of one colour, with a white square at its top left.
Image label(Color color) {
    const int size = 64, square = size / 4;
    Image image{size, size, {}};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Color c = x < square && y < square ? Color{255, 255, 255} : color;
            image.rgba.insert(image.rgba.end(), {std::uint8_t(c[0]), std::uint8_t(c[1]), std::uint8_t(c[2]), 255});
        }
    return image;
}

/// Anything, where no ray of these tests comes.
const char* const kBelow =
    R"("encoding": "display", "objects": [{"sphere": {"center": [3, -500, 2], "radius": 0.1}}]})";

struct Face {
    const char* name;
    Color color;
    glm::dvec3 towards, top;
};
const std::array<Face, 6> kFaces{{
    {"sky-px", {255, 0, 0}, {-1, 0, 0}, {0, 1, 0}},
    {"sky-nx", {0, 255, 255}, {1, 0, 0}, {0, 1, 0}},
    {"sky-py", {0, 255, 0}, {0, 1, 0}, {0, 0, -1}},
    {"sky-ny", {255, 0, 255}, {0, -1, 0}, {0, 0, 1}},
    {"sky-pz", {0, 0, 255}, {0, 0, 1}, {0, 1, 0}},
    {"sky-nz", {255, 255, 0}, {0, 0, -1}, {0, 1, 0}},
}};

TEST(CubeMap, IsSeenFromWithinAsItsImagesAre) {
    offscreen();
    Settings settings;
    settings.size = {64, 64};
    Drawing drawing(sceneFrom(std::string(R"({"background": {"cubemap": "sky"},)") + kBelow), settings);
    for (const Face& face : kFaces) drawing.renderer().setImage(face.name, label(face.color));
    for (const Face& face : kFaces) {
        drawing.view.camera = {glm::dvec3(0), face.towards, face.top, 89};
        const Image picture = drawing.picture();
        EXPECT_EQ(texel(picture, 3, 3), (Color{255, 255, 255})) << face.name;
        for (const auto& [x, y] : {std::pair{60, 3}, {3, 60}, {60, 60}, {32, 32}})
            EXPECT_EQ(texel(picture, x, y), face.color) << face.name << " at " << x << ", " << y;
    }
}

TEST(Gradient, GoesFromStraightDownToStraightUpByTheSine) {
    offscreen();
    Settings settings;
    settings.size = {41, 41};
    Drawing drawing(
        sceneFrom(std::string(R"({"background": {"gradient": {"top": [0.2, 0.5, 3], "bottom": [1, 0, 0.25]}},
        "camera": {"eye": [0, 0, 0], "target": [1, 0.3, -2], "fov": 140},)") +
                  kBelow),
        settings);
    for (const glm::dvec3 target : {glm::dvec3(1, 0.3, -2), glm::dvec3(0.1, 1, 0), glm::dvec3(0, -1, 0.2)}) {
        drawing.view.camera.target = target;
        const FloatImage image = drawing.output();
        const CameraFrame camera = frameOf(drawing.view.camera);
        double worst = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const double up = camera.halfHeight * (1 - (2 * y + 1.0) / image.height),
                             right = camera.halfHeight * ((2 * x + 1.0) / image.width - 1);
                const glm::dvec3 d = glm::normalize(camera.forward + right * camera.right + up * camera.up);
                const glm::dvec3 wanted = glm::mix(glm::dvec3(1, 0, 0.25), glm::dvec3(0.2, 0.5, 3), (1 + d.y) / 2);
                for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(image.at(x, y)[c] - wanted[c]));
            }
        EXPECT_LE(worst, 1e-6);
    }
}

// --- an image all around
// -----------------------------------------------------------------------------------------------

const std::string kAround = std::string(R"({"background": {"image": "grid"}, "camera": {"eye": [0, 0, 0],
    "target": [0, 0, -1]}, )") +
                            kBelow;

/// Columns from -180 to 180 degrees, rows from 90 to -90.
Image panorama(int width, const std::function<Color(glm::dvec3)>& colorTowards) {
    Image image{width, width / 2, {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double longitude = 2 * M_PI * ((x + 0.5) / image.width - 0.5),
                         latitude = M_PI * (0.5 - (y + 0.5) / image.height);
            const Color c = colorTowards({std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                          -std::cos(latitude) * std::cos(longitude)});
            image.rgba.insert(image.rgba.end(), {std::uint8_t(c[0]), std::uint8_t(c[1]), std::uint8_t(c[2]), 255});
        }
    return image;
}

/// Smooth over all directions: what is read there tells where it was read.
glm::dvec3 smooth(glm::dvec3 d) { return 127.5 + 120.0 * d; }
Color rounded(glm::dvec3 c) { return {int(std::lround(c.x)), int(std::lround(c.y)), int(std::lround(c.z))}; }

/// Farthest of any pixel from the smooth image's own colour in the direction of its ray, of 255.
double offBy(const FloatImage& image, const CameraPose& pose) {
    const CameraFrame camera = frameOf(pose);
    const double aspect = double(image.width) / image.height;
    double worst = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double up = camera.halfHeight * (1 - (2 * y + 1.0) / image.height),
                         right = camera.halfHeight * aspect * ((2 * x + 1.0) / image.width - 1);
            const glm::dvec3 wanted = smooth(glm::normalize(camera.forward + right * camera.right + up * camera.up));
            for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(255.0 * image.at(x, y)[c] - wanted[c]));
        }
    return worst;
}

struct Look {
    const char* where;
    glm::dvec3 towards;
    double fov;
};

class Panorama : public testing::TestWithParam<Look> {};

// Half a step of rounding, and half a step between two rounded texels, and what a texel's corner is off a sphere.
TEST_P(Panorama, ShowsTheColourOfEveryDirection) {
    offscreen();
    Settings settings;
    settings.size = {240, 180};
    Drawing drawing(sceneFrom(kAround), settings);
    drawing.renderer().setImage("grid", panorama(512, [](glm::dvec3 d) { return rounded(smooth(d)); }));
    drawing.view.camera = {glm::dvec3(0), GetParam().towards, {0.1, 1, 0.05}, GetParam().fov};
    EXPECT_LE(offBy(drawing.output(), drawing.view.camera), 1.3) << GetParam().where;
}

INSTANTIATE_TEST_SUITE_P(Looks, Panorama,
                         testing::Values(Look{"middle", {0, 0, -1}, 60}, Look{"right", {1, 0, 0}, 60},
                                         Look{"seam", {0, 0, 1}, 60}, Look{"seamClose", {0, 0, 1}, 1},
                                         Look{"above", {0, 1, 0}, 90}, Look{"aboveClose", {0, 1, 0}, 1},
                                         Look{"below", {0, -1, 0}, 90}, Look{"wide", {0.5, 0.2, -1}, 110}),
                         [](const auto& test) { return std::string(test.param.where); });

// A picture of few pixels sees coarse levels: no pixel at the seam or a pole sees more than its cone covers.
TEST_P(Panorama, IsAveragedOverWhatAPixelCovers) {
    offscreen();
    Settings settings;
    settings.size = {9, 9};
    Drawing drawing(sceneFrom(kAround), settings);
    drawing.renderer().setImage("grid", panorama(2048, [](glm::dvec3 d) { return rounded(smooth(d)); }));
    drawing.view.camera = {glm::dvec3(0), GetParam().towards, {0.1, 1, 0.05}, std::min(GetParam().fov, 90.0)};
    // A pixel of 10 degrees: the mean over its square and that over its texels differ where the colour is curved.
    EXPECT_LE(offBy(drawing.output(), drawing.view.camera), 4) << GetParam().where;
}

// Stripes of two texels that a distant view cannot show: they are grey, not a pattern, along the seam too.
TEST(PanoramaImage, HasNoSeamInAnyLevel) {
    offscreen();
    Settings settings;
    settings.size = {64, 8};
    Drawing drawing(sceneFrom(kAround), settings);
    drawing.renderer().setImage("grid", panorama(4096, [](glm::dvec3 d) {
                                    const int column = int(std::floor((std::atan2(d.x, -d.z) / M_PI + 1) * 2048));
                                    const int light = column % 2 ? 200 : 40;
                                    return Color{light, light, light};
                                }));
    drawing.view.camera = {glm::dvec3(0), {0, 0, 1}, {0, 1, 0}, 12};
    const FloatImage image = drawing.output();
    for (int x = 0; x < image.width; ++x) EXPECT_NEAR(255 * image.at(x, 4)[0], 120, 1.01) << x;
}

// --- a narrow view
// -----------------------------------------------------------------------------------------------------

/// Pixels of a ball that are drawn where it is not, or not where it is, farther than `margin` pixels from its rim.
int wrongPixels(glm::dvec3 towards, double margin) {
    const int size = 300;
    const double distance = 1e4, radius = 0.05, fov = 0.001;
    const glm::dvec3 center = distance * glm::normalize(towards);
    Scene scene = sceneFrom(R"({"objects": [{"sphere": {"center": [0, 0, 0], "radius": 0.05}}]})");
    scene.objects[0].shape = makeShape(ShapeKind::Sphere, {center}, {radius});
    scene.camera = {glm::dvec3(0), center, {0, 1, 0}, fov};
    Settings settings;
    settings.size = {size, size};
    const FloatImage objects = outputOf(scene, settings, Aov::Object);
    const double rim = radius / (distance * std::tan(glm::radians(fov) / 2)) * size / 2;
    int wrong = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double off = std::hypot(x + 0.5 - size / 2.0, y + 0.5 - size / 2.0) - rim;
            wrong += std::abs(off) > margin && (*objects.at(x, y) >= 0) != (off < 0);
        }
    return wrong;
}

// A pixel is 5.8e-8 rad. Along an axis float32 directions are as fine as that; across all axes they are 6e-8 apart.
TEST(NarrowView, ShowsAFarBallRound) {
    offscreen();
    EXPECT_EQ(wrongPixels({0, 0, -1}, 0.02), 0);
    EXPECT_EQ(wrongPixels({1, 0, 0}, 0.02), 0);
    EXPECT_EQ(wrongPixels({-5, 3, -8}, 2), 0);
    EXPECT_EQ(wrongPixels({1, 1, 1}, 2), 0);
}

} // namespace
} // namespace gnomon
