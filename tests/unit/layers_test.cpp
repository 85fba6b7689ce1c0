#include "tests/support/scenes.h"
#include "tracer/image_memory.h"
#include "tracer/layers.h"
#include "tracer/plan/texture_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gnomon {
namespace {

using test::sceneFrom;

constexpr int kRoom = 4096;
constexpr std::size_t kPlenty = std::size_t(1) << 30;

Image noise(int width, int height) {
    std::mt19937 random(unsigned(width * 31 + height));
    Image image{width, height, {}};
    for (int i = 0; i < width * height * 4; ++i) image.rgba.push_back(std::uint8_t(random() & 255));
    return image;
}

Image plain(int width, int height, std::uint8_t value) {
    return {width, height, std::vector<std::uint8_t>(std::size_t(width * height) * 4, value)};
}

std::uint8_t texel(const Image& image, int x, int y, int channel) {
    const int column = x % image.width, row = y % image.height;
    return image.rgba[std::size_t(row * image.width + column) * 4 + std::size_t(channel)];
}

Layers layersOf(const std::vector<Image>& images, bool srgb, int side, std::size_t bytes) {
    std::vector<glm::ivec2> sizes;
    for (const Image& image : images) sizes.emplace_back(image.width, image.height);
    return Layers(sizes, srgb, side, bytes);
}

/// The whole layer that an image becomes, at that level.
Image levelOf(const Layers& layers, int layer, const Image& image, int level) {
    Image found;
    layers.forEachLevel(layer, image, [&](int at, const Image& whole) {
        if (at == level) found = whole;
    });
    return found;
}

/// Whether `layer` holds `image` again and again.
testing::AssertionResult repeats(const Image& layer, const Image& image) {
    for (int y = 0; y < layer.height; ++y)
        for (int x = 0; x < layer.width; ++x)
            for (int c = 0; c < 4; ++c)
                if (texel(layer, x, y, c) != texel(image, x, y, c))
                    return testing::AssertionFailure() << "differs at " << x << ", " << y << ", channel " << c;
    return testing::AssertionSuccess();
}

TEST(Layers, HaveTheSizeOfTheLargestSides) {
    const Layers layers = layersOf({noise(64, 8), noise(16, 32)}, false, kRoom, kPlenty);
    EXPECT_EQ(layers.count(), 2);
    EXPECT_EQ(layers.width(0), 64);
    EXPECT_EQ(layers.height(0), 32);
    EXPECT_EQ(layers.levels(), 7);
    EXPECT_EQ(layers.width(6), 1);
    EXPECT_EQ(layers.height(6), 1);
    EXPECT_FALSE(layers.reduced());
}

// Every level of the layer repeats the same level of the image alone: so it is sampled as it would be alone.
TEST(Layers, RepeatWhatGoesIntoThemByPowersOfTwoAtEveryLevel) {
    for (const bool srgb : {false, true}) {
        const Image small = noise(16, 8);
        const Layers layers = layersOf({noise(64, 32), small}, srgb, kRoom, kPlenty);
        EXPECT_EQ(layers.tile(0), glm::vec2(1));
        EXPECT_EQ(layers.tile(1), glm::vec2(0.25f));
        Image alone = small;
        for (int level = 0; level < layers.levels(); ++level) {
            const Image whole = levelOf(layers, 1, small, level);
            EXPECT_EQ(whole.width, layers.width(level));
            EXPECT_EQ(whole.height, layers.height(level));
            EXPECT_TRUE(repeats(whole, alone)) << "level " << level;
            alone = halved(alone, srgb);
        }
    }
}

TEST(Layers, StretchWhatDoesNotGoIntoThemAlongThatSideOnly) {
    const Layers layers = layersOf({noise(64, 32), noise(48, 16)}, false, kRoom, kPlenty);
    EXPECT_EQ(layers.tile(1), glm::vec2(1, 0.5f));
    // A ramp that repeats stays one, and nothing of it leaves its range.
    Image ramp = plain(3, 1, 255);
    for (int x = 0; x < 3; ++x) ramp.rgba[std::size_t(x) * 4] = std::uint8_t(60 * x);
    const Image wide = levelOf(layersOf({plain(6, 1, 0), ramp}, false, kRoom, kPlenty), 1, ramp, 0);
    const int expected[] = {30, 15, 45, 75, 105, 90};
    for (int x = 0; x < 6; ++x) EXPECT_EQ(texel(wide, x, 0, 0), expected[x]) << "texel " << x;
    EXPECT_EQ(texel(wide, 2, 0, 3), 255);
}

TEST(Layers, AreHalvedUntilTheyFit) {
    const Layers bySide = layersOf({noise(64, 32), noise(16, 16)}, false, 32, kPlenty);
    EXPECT_TRUE(bySide.reduced());
    EXPECT_EQ(bySide.width(0), 32);
    EXPECT_EQ(bySide.height(0), 16);
    EXPECT_TRUE(repeats(levelOf(bySide, 0, noise(64, 32), 0), halved(noise(64, 32), false)));
    const Layers byBytes = layersOf({noise(64, 64), noise(8, 8)}, false, kRoom, std::size_t(2 * 16 * 16 * 4));
    EXPECT_TRUE(byBytes.reduced());
    EXPECT_EQ(byBytes.width(0), 16);
    EXPECT_TRUE(repeats(levelOf(byBytes, 1, noise(8, 8), 0), noise(8, 8))) << "small ones stay as they are";
    EXPECT_EQ(layersOf({noise(4, 4)}, false, kRoom, 0).width(0), 1) << "one texel always fits";
}

TEST(Layers, ComeTheLargestFirst) {
    const Layers layers = layersOf({noise(8, 8), noise(64, 32), noise(16, 32), noise(5, 5)}, false, kRoom, kPlenty);
    EXPECT_EQ(layers.largestFirst(), (std::vector{1, 0, 2, 3}));
}

// All wait at first; a texture takes a third more than its finest level, and its images go when it is made.
TEST(PeakMemory, IsThatOfTheWorstUpload) {
    EXPECT_EQ(peakMemory(std::vector<ImageUpload>{{300, 300, 10}}), 710U);
    EXPECT_EQ(peakMemory(std::vector<ImageUpload>{{300, 300, 0}, {30, 30, 0}}), 730U);
    EXPECT_EQ(peakMemory(std::vector<ImageUpload>{{30, 30, 0}, {300, 300, 0}}), 740U);
}

TEST(Painted, TakesTheMasksRedAsAlphaAndWhiteForWhatIsMissing) {
    const Image color = noise(8, 4), mask = noise(8, 4);
    const Image both = painted(color, mask);
    for (int i = 0; i < 32; ++i) {
        EXPECT_EQ(texel(both, i % 8, i / 8, 1), texel(color, i % 8, i / 8, 1));
        EXPECT_EQ(texel(both, i % 8, i / 8, 3), texel(mask, i % 8, i / 8, 0));
    }
    EXPECT_EQ(texel(painted(color, {}), 3, 2, 3), 255) << "an image's own alpha is none";
    EXPECT_EQ(texel(painted({}, mask), 3, 2, 0), 255);
    EXPECT_EQ(texel(painted({}, mask), 3, 2, 3), texel(mask, 3, 2, 0));
    const Image larger = painted(noise(4, 4), noise(8, 2));
    EXPECT_EQ(larger.width, 8);
    EXPECT_EQ(larger.height, 4);
}

TEST(TextureSet, HoldsEveryPaintAndEveryNormalMapOnce) {
    const Scene scene = sceneFrom(R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0]},
        "materials": {
            "a": {"texture": "grid", "normal_map": "moon-normal"},
            "b": {"texture": "grid", "coat": {"ior": 1.3, "mask": "earth-water"}},
            "c": {"texture": "grid", "normal_map": "moon-normal"},
            "d": {"coat": {"ior": 1.3, "mask": "earth-water"}},
            "e": {}},
        "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "a"}]})");
    const TextureSet textureSet = textureSetOf(scene);
    EXPECT_EQ(textureSet.paints, (std::vector<Paint>{{"grid", ""}, {"grid", "earth-water"}, {"", "earth-water"}}));
    EXPECT_EQ(textureSet.normals, std::vector<std::string>{"moon-normal"});
    const auto material = [&](const std::string& name) {
        for (const Material& m : scene.materials)
            if (m.name == name) return m;
        return Material{};
    };
    EXPECT_EQ(textureSet.paintOf(material("c")), 0);
    EXPECT_EQ(textureSet.paintOf(material("d")), 2);
    EXPECT_EQ(textureSet.paintOf(material("e")), -1);
    EXPECT_EQ(textureSet.normalOf(material("c")), 0);
    EXPECT_EQ(textureSet.normalOf(material("b")), -1);
    EXPECT_TRUE(textureSet.shows("earth-water"));
    EXPECT_FALSE(textureSet.shows("sun"));
}

} // namespace
} // namespace gnomon
