/// What rays see that meet nothing: where each image of the background lies, and which way round.
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <array>
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
    R"("encoding": "display", "objects": [{"sphere": {"center": [0, -500, 0], "radius": 0.1}}]})";

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

} // namespace
} // namespace gnomon
