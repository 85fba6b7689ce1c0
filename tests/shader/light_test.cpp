/// What light does in the ray tree: shadows, textures, reflection and refraction, each in a scene made for it.

#include "native/file/asset_folder.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gnomon {
namespace {

using namespace test;

Settings sized(int width, int height) {
    Settings settings;
    settings.size = {width, height};
    settings.depth = 8;
    return settings;
}

/// Looks straight down on a floor at y = 0 from a height of 10; `objects` and the light stand over it.
Scene floorUnder(const std::string& light, const std::string& objects) {
    return sceneFrom(R"({"camera": {"eye": [0, 10, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov": 30},
        "lights": [{"point": {"position": )" +
                     light + R"(}}],
        "objects": [{"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}})" +
                     (objects.empty() ? "" : ",") + objects + "]}");
}

double visibilityInTheMiddle(const Scene& scene) {
    const FloatImage image = outputOf(scene, sized(9, 9), Aov::Visibility);
    return *image.at(4, 4);
}

TEST(Shadow, FallsBehindAnOccluderBetweenPointAndLight) {
    EXPECT_EQ(visibilityInTheMiddle(floorUnder("[4, 4, 0]", R"({"sphere": {"center": [2, 2, 0], "radius": 0.5}})")),
              0.0);
}

TEST(Shadow, DoesNotComeFromAnOccluderBehindTheLight) {
    EXPECT_EQ(visibilityInTheMiddle(floorUnder("[4, 4, 0]", R"({"sphere": {"center": [6, 6, 0], "radius": 0.5}})")),
              1.0);
}

TEST(Shadow, DoesNotComeFromAnObjectThatCastsNone) {
    EXPECT_EQ(visibilityInTheMiddle(floorUnder(
                  "[4, 4, 0]", R"({"sphere": {"center": [2, 2, 0], "radius": 0.5}, "casts_shadow": false})")),
              1.0);
}

TEST(Shadow, ComesFromEveryKindOfShape) {
    for (const char* shape :
         {R"({"sphere": {"center": [2, 2, 0], "radius": 0.5}})",
          R"({"disc": {"center": [2, 2, 0], "normal": [1, 1, 0], "radius": 0.5}})",
          R"({"plane": {"point": [2, 2, 0], "normal": [1, 0, 0]}})",
          R"({"triangle": {"vertices": [[2, 2, -1], [2, 2.5, 1], [2, 1.5, 1]]}})",
          R"({"torus": {"center": [2, 2.5, 0], "axis": [0, 0, 1], "major_radius": 0.5, "minor_radius": 0.2}})",
          R"({"box": {"center": [2, 2, 0], "half_size": [0.5, 0.2, 0.3]}})",
          R"({"cylinder": {"from": [2, 1.5, 0], "to": [2, 2.5, 0], "radius": 0.5}})",
          R"({"capsule": {"from": [2, 2, -1], "to": [2, 2, 1], "radius": 0.3}})",
          R"({"cone": {"from": [2, 1.5, 0], "to": [2, 2.5, 0], "radius": 0.5}})"})
        EXPECT_EQ(visibilityInTheMiddle(floorUnder("[4, 4, 0]", shape)), 0.0) << shape;
}

TEST(Shadow, IsCastByAnObjectOnItself) {
    // From above one sees the tube's inner slope on the far side of the hole; the light stands low behind the near
    // side.
    const Scene scene = sceneFrom(R"({"camera": {"eye": [0, 10, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov": 20},
        "lights": [{"point": {"position": [20, 1, 0]}}],
        "objects": [{"torus": {"center": [0, 0, 0], "axis": [0, 1, 0], "major_radius": 1, "minor_radius": 0.4}}]})");
    const FloatImage image = outputOf(scene, sized(101, 101), Aov::Visibility);
    const auto at = [&](double x) { return *image.at(int(50 + x * 50 / (10 * std::tan(glm::radians(10.0)))), 50); };
    EXPECT_EQ(at(1.2), 1.0f) << "the outer slope towards the light";
    EXPECT_EQ(at(-0.75), 0.0f) << "the inner slope that faces the light, behind the near half of the ring";
}

TEST(Shadow, LeavesNoSpecksWhereTheLightStandsBehindTheEye) {
    Scene scene = sceneFrom(R"({"camera": {"eye": [0, 0, 1000], "target": [0, 0, 0]},
        "lights": [{"point": {"position": [0, 0, 1500]}}], "objects": [
        {"sphere": {"center": [0, 0, 0], "radius": 1}},
        {"torus": {"center": [0, 0, 0], "axis": [0, 0, 1], "major_radius": 1.4, "minor_radius": 0.25}}]})");
    scene.camera.fov = 0.2; // narrower than scene files allow: fills the picture from 1000 units away
    const FloatImage image = outputOf(scene, sized(200, 200), Aov::Visibility);
    int dark = 0;
    for (float v : image.pixels) dark += v < 1;
    EXPECT_EQ(dark, 0) << "everything seen is lit";
}

TEST(Shadow, LeavesNoSpecksOnConvexShapesEither) {
    Scene scene = sceneFrom(R"({"camera": {"eye": [0, 0, 1000], "target": [0, 0, 0]},
        "lights": [{"point": {"position": [0, 0, 1500]}}], "objects": [
        {"box": {"center": [-0.8, 0.8, 0], "half_size": [0.6, 0.5, 0.4]}},
        {"cylinder": {"from": [0.4, 0.4, 0.3], "to": [1.2, 1.2, -0.5], "radius": 0.4}},
        {"cylinder": {"from": [0, 0, -0.3], "to": [0, 0, 0.3], "radius": 0.25}},
        {"capsule": {"from": [-1.2, -1.2, 0.4], "to": [-0.5, -0.5, -0.4], "radius": 0.3}},
        {"cone": {"from": [0.9, -0.7, -0.5], "to": [0.7, -0.9, 0.8], "radius": 0.6}}]})");
    scene.camera.fov = 0.2; // narrower than scene files allow: fills the picture from 1000 units away
    const FloatImage object = outputOf(scene, sized(200, 200), Aov::Object);
    const FloatImage image = outputOf(scene, sized(200, 200), Aov::Visibility);
    std::vector<int> seen(5);
    int dark = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (object.pixels[i] >= 0) ++seen[std::size_t(object.pixels[i])];
        dark += image.pixels[i] < 1;
    }
    EXPECT_EQ(dark, 0) << "everything seen is lit";
    for (int count : seen) EXPECT_GT(count, 400);
}

/// Colour at the middle of a small picture.
glm::vec3 colorInTheMiddle(const Scene& scene, Settings settings = sized(9, 9)) {
    const FloatImage image = outputOf(scene, settings, Aov::Color);
    const float* c = image.at(settings.size.x / 2, settings.size.y / 2);
    return {c[0], c[1], c[2]};
}

TEST(Texture, ColoursItsOwnSurfaceOnly) {
    // A mirror coat over a dark textured ball reflects a white sky: the texture must not dim the reflection.
    const auto scene = [](const char* texture) {
        return sceneFrom(std::string(R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0]},
            "background": {"color": [1, 1, 1]}, "materials": {"m": {"ambient": 0, "diffuse": 0,
                "coat": {"ior": 1.5})") +
                         texture +
                         R"(}}, "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "m"}]})");
    };
    const glm::vec3 plain = colorInTheMiddle(scene(""));
    const glm::vec3 textured = colorInTheMiddle(scene(R"(, "texture": "earth-color")"));
    EXPECT_NEAR(plain.r, 0.04, 1e-4) << "at normal incidence of index 1.5";
    EXPECT_EQ(plain, textured);
}

/// A floor far into the distance and a ball with all that images can do, in front of a bright sky; `more` materials.
Scene pictured(const std::string& more) {
    return sceneFrom(R"({"camera": {"eye": [0, 1, 5], "target": [0, 0, 0]}, "background": {"color": [1, 1, 1]},
        "lights": [{"point": {"position": [3, 5, 5]}}],
        "materials": {
            "floor": {"texture": {"image": "grid", "scale": 0.37}},
            "ball": {"texture": "moon-color", "normal_map": {"image": "moon-normal", "scale": [2, 3]},
                     "coat": {"ior": 2, "mask": "sun"}})" +
                     more + R"(},
        "objects": [{"plane": {"point": [0, -1, 0], "normal": [0, 1, 0]}, "material": "floor"},
                    {"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "ball"}]})");
}

// All images lie in layers of one size: larger ones beside them must not be seen, near or far, straight or at a slant.
TEST(Texture, LooksTheSameBesideLargerImages) {
    const FloatImage alone = outputOf(pictured(""), sized(120, 90), Aov::Color);
    const FloatImage beside =
        outputOf(pictured(R"(, "unseen": {"texture": "earth-color", "normal_map": "earth-normal"})"), sized(120, 90),
                 Aov::Color);
    EXPECT_EQ(alone.pixels, beside.pixels);
}

// Until an image has come it is told by one flat texel; the picture that follows is that of an image that was there.
TEST(Texture, LooksTheSameHoweverLateItComes) {
    offscreen();
    const Scene scene = pictured("");
    Drawing early(scene, sized(60, 45)), late(scene, sized(60, 45));
    const FloatImage expected = early.output();
    const Image small{1, 1, {255, 0, 0, 255}};
    Problems problems;
    const auto images = AssetFolder(std::string(GNOMON_SOURCE_DIR) + "/assets").readImages(scene, problems);
    ASSERT_TRUE(images);
    for (const auto& [name, image] : *images) late.renderer().setImage(name, small);
    EXPECT_NE(late.output().pixels, expected.pixels);
    for (const auto& [name, image] : *images) {
        late.renderer().setImage(name, image);
        late.output();
    }
    EXPECT_EQ(late.output().pixels, expected.pixels);
}

TEST(Conductor, ReflectsByItsComplexIndexPerChannel) {
    const glm::vec3 gold = colorInTheMiddle(sceneFrom(R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0]},
        "background": {"color": [1, 1, 1]},
        "materials": {"gold": {"ambient": 0, "diffuse": 0, "conductor": {"n": [0.17, 0.35, 1.5],
            "k": [3.1, 2.7, 1.9]}}},
        "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "gold"}]})"));
    EXPECT_NEAR(gold.r, 0.938, 1e-3);
    EXPECT_NEAR(gold.g, 0.846, 1e-3);
    EXPECT_NEAR(gold.b, 0.391, 1e-3);
}

// Clear glass in a white room is invisible: what is reflected and what goes through add up to all the light.
TEST(Glass, NeitherAddsNorLosesLightInAWhiteRoom) {
    const Scene scene =
        sceneFrom(R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}, "background": {"color": [1, 1, 1]},
        "materials": {"glass": {"ambient": 0, "diffuse": 0, "dielectric": {"ior": 1.5}}},
        "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "glass"}]})");
    Settings settings = sized(96, 96);
    settings.threshold = 0;
    const FloatImage image = outputOf(scene, settings, Aov::Color);
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            const float value = *image.at(x, y);
            ASSERT_LE(value, 1.0f + 1e-5f) << x << ' ' << y;
            // What is still inside when the depth ends: (1 - F) F^6, at most 0.057 over all F.
            ASSERT_GE(value, 1.0f - 0.057f) << x << ' ' << y;
        }
}

// Light that total reflection keeps inside for longer than the ray tree is deep is lost, but none is ever added. In a
// box it leaves, always at one angle, by the faces opposite to each other that it came in by, and has met both of them
// before the tree ends: what is left inside is at most (1 - F) F^2 <= 4/27.
TEST(Glass, InConvexShapesAddsNoLightAndInABoxLosesNone) {
    for (const char* body : {R"("box": {"center": [0, 0, 0], "half_size": [0.7, 0.8, 0.6]})",
                             R"("cylinder": {"from": [-0.4, -0.7, 0], "to": [0.4, 0.7, 0], "radius": 0.5})",
                             R"("capsule": {"from": [-0.4, -0.7, 0], "to": [0.4, 0.7, 0], "radius": 0.5})",
                             R"("cone": {"from": [0, -0.7, 0], "to": [0.2, 0.7, 0.1], "radius": 0.7})"})
        for (const char* eye : {"[0, 0, 5]", "[2.2, 1.7, 4]", "[-3, 4, 1]"}) {
            SCOPED_TRACE(std::string(body) + " from " + eye);
            const Scene scene = sceneFrom(std::string(R"({"camera": {"eye": )") + eye +
                                          R"(, "target": [0, 0, 0], "fov": 30}, "background": {"color": [1, 1, 1]},
                "materials": {"glass": {"ambient": 0, "diffuse": 0, "dielectric": {"ior": 1.5}}},
                "objects": [{)" + body + R"(, "material": "glass"}]})");
            Settings settings = sized(96, 96);
            settings.threshold = 0;
            const FloatImage image = outputOf(scene, settings, Aov::Color);
            const bool box = std::string(body).find("box") != std::string::npos;
            for (int y = 0; y < 96; ++y)
                for (int x = 0; x < 96; ++x) {
                    const float value = *image.at(x, y);
                    ASSERT_LE(value, 1.0f + 1e-5f) << x << ' ' << y;
                    if (box) {
                        ASSERT_GE(value, 1.0f - 4.0f / 27 - 1e-5f) << x << ' ' << y;
                    }
                }
        }
}

TEST(Glass, BoxShiftsWhatIsBehindItByThePlatesFormula) {
    // Through a plate of thickness d at 45 degrees a ray leaves parallel to itself, shifted across itself by
    // d sin(a) (1 - cos(a) / sqrt(n^2 - sin^2(a))): 0.3291 d for n = 1.5. An edge of light that far to the side says
    // so.
    const auto bright = [](double shift) {
        const double edge = shift * std::sqrt(2.0); // along the wall y = -4 that the ray meets at 45 degrees
        return colorInTheMiddle(sceneFrom(R"({"camera": {"eye": [-4, 4, 0], "target": [0, 0, 0], "fov": 5},
            "materials": {"glass": {"ambient": 0, "diffuse": 0, "dielectric": {"ior": 1.5}},
                          "bright": {"ambient": 0, "diffuse": 0, "emission": 1}},
            "objects": [{"box": {"center": [0, 0, 0], "half_size": [3, 0.5, 3]}, "material": "glass"},
                        {"box": {"center": [)" +
                                          std::to_string(4 - edge + 5) +
                                          R"(, -4.0001, 0], "half_size": [5, 0.0001, 5]}, "material": "bright"}]})"))
                   .r > 0.5;
    };
    EXPECT_TRUE(bright(0.3291 + 0.002));
    EXPECT_FALSE(bright(0.3291 - 0.002));
}

TEST(Glass, TurnsWhatIsBehindItUpsideDown) {
    // Far behind the ball the upper half is bright, the lower dark.
    const Scene scene = sceneFrom(R"({"camera": {"eye": [0, 0, 12], "target": [0, 0, 0], "fov": 14},
        "materials": {"glass": {"ambient": 0, "diffuse": 0, "dielectric": {"ior": 1.5}},
                      "bright": {"ambient": 0, "diffuse": 0, "emission": 1}},
        "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "glass"},
                    {"triangle": {"vertices": [[-900, 0, -20], [900, 0, -20], [0, 900, -20]]},
                        "material": "bright"}]})");
    const FloatImage image = outputOf(scene, sized(60, 60), Aov::Color);
    EXPECT_GT(*image.at(30, 4), 0.9f) << "above the ball: bright";
    EXPECT_LT(*image.at(30, 55), 0.1f) << "below the ball: dark";
    EXPECT_LT(*image.at(30, 24), 0.2f) << "upper part of the ball: the dark lower half";
    EXPECT_GT(*image.at(30, 36), 0.7f) << "lower part of the ball: the bright upper half";
}

TEST(Glass, ReflectsTotallyBeyondTheCriticalAngle) {
    // The eye is inside a block of glass under a flat surface: sin θc = 1/1.5, θc = 41.8°.
    const auto lookingUpAt = [](double degrees) {
        const double a = glm::radians(degrees);
        const std::string target = "[" + std::to_string(std::sin(a)) + ", " + std::to_string(-1 + std::cos(a)) + ", 0]";
        return sceneFrom(R"({"camera": {"eye": [0, -1, 0], "up": [0, 0, 1], "target": )" + target + R"(},
            "background": {"color": [1, 1, 1]},
            "materials": {"glass": {"ambient": 0, "diffuse": 0, "dielectric": {"ior": 1.5}},
                          "floor": {"ambient": 0, "diffuse": 0, "emission": [0, 1, 0]}},
            "objects": [{"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}, "material": "glass"},
                        {"plane": {"point": [0, -2, 0], "normal": [0, 1, 0]}, "material": "floor"}]})");
    };
    EXPECT_NEAR(colorInTheMiddle(lookingUpAt(43)).r, 0.0, 1e-6) << "only the floor's mirror image";
    EXPECT_NEAR(colorInTheMiddle(lookingUpAt(43)).g, 1.0, 1e-6);
    EXPECT_GT(colorInTheMiddle(lookingUpAt(40)).r, 0.2) << "the white outside shines in";
    EXPECT_NEAR(colorInTheMiddle(lookingUpAt(0)).r, 0.96, 1e-3);
}

// The picture a window shows is the colour output, clamped, sRGB-encoded where the scene is linear, in eight bits.
TEST(Picture, EncodesLinearLightAndLeavesDisplayValues) {
    for (const bool linear : {true, false}) {
        const Scene scene = sceneFrom(std::string(R"({"encoding": ")") + (linear ? "linear" : "display") + R"(",
            "camera": {"eye": [0, 0, 5], "target": [0, 0, 9]}, "background": {"color": [0.002, 0.2159, 7]},
            "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}}]})");
        offscreen();
        const Image picture = Drawing(scene, sized(2, 2)).picture();
        const std::vector<std::uint8_t> pixel(picture.rgba.begin(), picture.rgba.begin() + 3);
        EXPECT_EQ(pixel, linear ? (std::vector<std::uint8_t>{7, 128, 255}) : (std::vector<std::uint8_t>{1, 55, 255}));
    }
}

TEST(Picture, ShowsTheChannelsOfTheColourMode) {
    const Scene scene = sceneFrom(R"({"encoding": "display", "camera": {"eye": [0, 0, 5], "target": [0, 0, 9]},
        "background": {"color": [0.2, 0.4, 0.6]}, "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}}]})");
    offscreen();
    for (int mode = 0; mode < 27; ++mode) {
        Settings settings = sized(1, 1);
        settings.colorMode = mode;
        const Image picture = Drawing(scene, settings).picture();
        const int channels[] = {mode / 9, mode / 3 % 3, mode % 3};
        for (int c = 0; c < 3; ++c) EXPECT_EQ(picture.rgba[c], 51 * (channels[c] + 1)) << colorModes()[mode];
    }
}

TEST(Depth, LimitsHowOftenLightBounces) {
    // Two facing mirrors: each bounce adds one more dim image of the emitter.
    const Scene scene = sceneFrom(R"({"camera": {"eye": [0, 0, 0.5], "target": [0, 0, -1]},
        "materials": {"silver": {"ambient": 0, "diffuse": 0, "emission": 0.1,
                                 "conductor": {"n": [0.14, 0.16, 0.13], "k": [4.1, 2.3, 3.1]}}},
        "objects": [{"plane": {"point": [0, 0, -1], "normal": [0, 0, 1]}, "material": "silver"},
                    {"plane": {"point": [0, 0, 1], "normal": [0, 0, -1]}, "material": "silver"}]})");
    Settings settings = sized(9, 9);
    double sum = 0, bounce = 0.1;
    const double f0 = ((0.14 - 1) * (0.14 - 1) + 4.1 * 4.1) / ((0.14 + 1) * (0.14 + 1) + 4.1 * 4.1);
    for (settings.depth = 1; settings.depth <= 8; ++settings.depth) {
        sum += bounce;
        bounce *= f0;
        EXPECT_NEAR(colorInTheMiddle(scene, settings).r, sum, 1e-5) << settings.depth;
    }
}

TEST(Glow, FollowsItsFormulaAtTheDistanceOfTheLine) {
    const Scene scene = sceneFrom(R"({"camera": {"eye": [3, 0, 20], "target": [3, 0, 0]}, "objects": [
        {"sphere": {"center": [0, 0, 0], "radius": 1},
         "glow": {"color": [1, 0.95, 0.1], "strength": 2, "softness": 0.5}}]})");
    const glm::vec3 color = colorInTheMiddle(scene);
    const double expected = 2 / (0.5 + 9);
    EXPECT_NEAR(color.r, expected, 1e-4);
    EXPECT_NEAR(color.b, expected * 0.1, 1e-5);
}

TEST(Glow, IsOffWhereTheSettingSaysSo) {
    Settings settings = sized(9, 9);
    settings.glow = false;
    const Scene scene = sceneFrom(R"({"camera": {"eye": [3, 0, 20], "target": [3, 0, 0]}, "objects": [
        {"sphere": {"center": [0, 0, 0], "radius": 1}, "glow": {"strength": 2, "softness": 0.5}}]})");
    EXPECT_EQ(colorInTheMiddle(scene, settings), glm::vec3(0));
}

} // namespace
} // namespace gnomon
