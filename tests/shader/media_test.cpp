/// Dielectric bodies within one another, that overlap, touch and absorb, against the oracle's pictures
/// (lab/reference/exact/picture.h) and closed forms; and rays of the largest depth, which lose no light in glass.
///
/// The claim for pictures is that of scenes_test.cpp: no isolated pixel. Chance may break it where a ray comes within
/// its rounding of the critical angle, which lenses magnify: the slope of the reflectance has no bound there
/// (CriticalAngle in scenes_test.cpp). None of these pictures has such a ray; in the pool one pixel of 100 000 has.

#include "tests/support/oracle_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ostream>
#include <random>
#include <string>

namespace gnomon {
namespace {

using namespace test;

constexpr const char* kRoom = R"({"background": {"color": [0.6, 0.75, 0.9]},
    "camera": {"eye": [0.3, 0.5, 6], "target": [0.1, 0.05, 0], "fov": 26},
    "lights": [{"point": {"position": [3, 5, 4]}}],
    "materials": {
        "glass": {"dielectric": {"ior": 1.5}, "specular": 0.4, "shininess": 60},
        "water": {"dielectric": {"ior": 1.333}},
        "air": {"dielectric": {"ior": 1}},
        "thin": {"dielectric": {"ior": 0.7}},
        "ice": {"dielectric": {"ior": 1.31, "priority": 1}},
        "diamond": {"dielectric": {"ior": 2.4, "priority": -1}},
        "wine": {"dielectric": {"ior": 1.34, "absorption": [0.2, 1.5, 2.5]}},
        "green": {"dielectric": {"ior": 1.5, "absorption": [1.2, 0.1, 0.8]}},
        "gold": {"conductor": {"n": [0.17, 0.35, 1.5], "k": [3.1, 2.7, 1.9]}},
        "varnish": {"ambient": 0.1, "diffuse": [0.2, 0.3, 0.8], "coat": {"ior": 1.6}},
        "red": {"ambient": [0.1, 0.02, 0.02], "diffuse": [0.8, 0.2, 0.1], "specular": 0.3, "shininess": 20},
        "wall": {"ambient": 0.2, "diffuse": [0.3, 0.5, 0.2]},
        "floor": {"ambient": 0.2, "diffuse": [0.7, 0.6, 0.5]}},
    "objects": [{"plane": {"point": [0, -1, 0], "normal": [0, 1, 0]}, "material": "floor"},
                {"box": {"center": [0.6, 0, -3], "half_size": [0.5, 1, 0.5]}, "material": "wall"})";

/// The room with more in it.
Scene room(const std::string& objects) { return sceneFrom(kRoom + ("," + objects + "]}")); }

std::string ball(const std::string& material, const std::string& center, double radius, const std::string& more = {}) {
    return R"({"sphere": {"center": )" + center + R"(, "radius": )" + std::to_string(radius) + R"(}, "material": ")" +
           material + R"(", "casts_shadow": false)" + more + "}";
}

const std::string kMiddle = "[0, 0, 0]";

std::string pane(double z) {
    return R"({"box": {"center": [0, 0, )" + std::to_string(z) +
           R"(], "half_size": [0.9, 0.9, 0.05]}, "material": "glass", "casts_shadow": false})";
}

/// A box of twelve triangles, their outside without.
std::string skin(const std::string& material, glm::dvec3 half) {
    std::string text;
    const auto corner = [&](int i) {
        return "[" + std::to_string(i & 1 ? half.x : -half.x) + "," + std::to_string(i & 2 ? half.y : -half.y) + "," +
               std::to_string(i & 4 ? half.z : -half.z) + "]";
    };
    constexpr int kSides[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    for (const auto& side : kSides)
        text += std::string(text.empty() ? "" : ",") + R"({"triangle": {"vertices": [)" + corner(side[0]) + "," +
                corner(side[1]) + "," + corner(side[2]) + R"(]}, "material": ")" + material +
                R"(", "casts_shadow": false})";
    return text;
}

struct Case {
    const char* name;
    std::string objects;
    int depth;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class Media : public testing::TestWithParam<Case> {};

TEST_P(Media, HaveNoIsolatedPixel) {
    const Case& c = GetParam();
    EXPECT_EQ(differenceOf(c.name, room(c.objects), sized(160, 120, c.depth)).outliers, 0);
}

const std::string kBubble = ball("glass", kMiddle, 1) + "," + ball("air", kMiddle, 0.5);

INSTANTIATE_TEST_SUITE_P(
    Scenes, Media,
    testing::Values(
        Case{"bubble", kBubble, 6}, Case{"hollow", ball("glass", kMiddle, 1) + "," + ball("air", kMiddle, 0.9), 4},
        Case{"panes", pane(-0.9) + "," + pane(-0.3) + "," + pane(0.3) + "," + pane(0.9), 4},
        Case{"three",
             ball("glass", kMiddle, 1) + "," + ball("water", "[0, -0.1, 0]", 0.8) + "," +
                 ball("air", "[0.1, -0.1, 0.2]", 0.4),
             6},
        Case{"overlap", ball("glass", "[-0.4, 0, 0]", 0.7) + "," + ball("ice", "[0.4, 0, 0]", 0.75), 6},
        Case{"overlap-other", ball("glass", "[-0.4, 0, 0]", 0.7) + "," + ball("diamond", "[0.4, 0, 0]", 0.65), 5},
        Case{"one-body", ball("glass", "[-0.4, 0, 0]", 0.7) + "," + ball("glass", "[0.4, 0, 0]", 0.7), 5},
        Case{"thinner", ball("glass", kMiddle, 1) + "," + ball("thin", kMiddle, 0.6), 5},
        Case{"absorbing", ball("green", kMiddle, 1) + "," + ball("red", "[0.2, 0.1, 0.1]", 0.3), 5},
        Case{"wine",
             ball("glass", kMiddle, 1) + "," + ball("wine", kMiddle, 0.85) + "," + ball("air", "[0, 0.3, 0]", 0.3), 6},
        Case{"skin", skin("green", {0.9, 0.6, 0.7}) + "," + ball("air", kMiddle, 0.4), 5},
        Case{"gold-in-water", ball("water", kMiddle, 1) + "," + ball("gold", "[0.2, 0.1, 0.1]", 0.5), 5},
        Case{"varnish-in-glass", ball("glass", kMiddle, 1) + "," + ball("varnish", "[-0.2, 0, 0.1]", 0.5), 5},
        Case{"pool",
             R"({"plane": {"point": [0, -0.4, 0], "normal": [0.1, 1, 0]}, "material": "wine"},)" +
                 ball("glass", "[-0.31, -0.3, 0]", 0.6),
             5}),
    [](const auto& test) {
        std::string name = test.param.name;
        std::ranges::replace(name, '-', '_');
        return name;
    });

/// Spheres, boxes and cylinders of all materials, crowded about the middle.
Scene crowd(unsigned seed, int count) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto vector = [&](double size) {
        return "[" + std::to_string(size * number(random)) + "," + std::to_string(size * number(random)) + "," +
               std::to_string(size * number(random)) + "]";
    };
    constexpr const char* kMaterials[] = {"glass", "water", "air", "thin", "ice", "diamond", "wine", "green", "red"};
    std::string objects;
    for (int i = 0; i < count; ++i) {
        const std::string size = std::to_string(0.4 + 0.2 * number(random));
        const std::string center = vector(0.5), from = vector(0.7), to = vector(0.7);
        const std::string shapes[] = {R"("sphere": {"center": )" + center + R"(, "radius": )" + size + "}",
                                      R"("box": {"center": )" + center + R"(, "half_size": [0.3, )" + size + ", 0.4]}",
                                      R"("cylinder": {"from": )" + from + R"(, "to": )" + to + R"(, "radius": 0.4})"};
        objects += std::string(i > 0 ? "," : "") + "{" + shapes[random() % 3] + R"(, "material": ")" +
                   kMaterials[random() % std::size(kMaterials)] + R"(", "casts_shadow": false})";
    }
    return room(objects);
}

// Up to four bodies lie in one another here: more than the shader keeps are not compared.
TEST(Media, OfRandomCrowdsHaveNoIsolatedPixel) {
    for (unsigned seed = 1; seed <= 12; ++seed)
        EXPECT_EQ(differenceOf("crowd-" + std::to_string(seed), crowd(seed, 4), sized(64, 48, 4)).outliers, 0) << seed;
}

// However objects are searched, the same is met next to the nearest, too.
TEST(Media, AreTheSameInEverySearch) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-0.8, 0.8);
    std::string bubbles = R"({"box": {"center": [0, 0, 0], "half_size": [0.9, 0.9, 0.9]}, "material": "green"})";
    for (int i = 0; i < 60; ++i)
        bubbles += "," + ball(i % 3 > 0 ? "air" : "wine",
                              "[" + std::to_string(number(random)) + "," + std::to_string(number(random)) + "," +
                                  std::to_string(number(random)) + "]",
                              0.12);
    const Scene scene = room(bubbles);
    Settings settings = sized(120, 90, 6);
    settings.accel = Accel::None;
    const FloatImage all = outputOf(scene, settings, Aov::Color);
    for (const Accel accel : {Accel::Hierarchy, Accel::Auto}) {
        settings.accel = accel;
        EXPECT_EQ(difference(outputOf(scene, settings, Aov::Color), all), "");
    }
}

// From inside: of a bubble in glass, of the overlap, and of the half space behind a plane.
TEST(Media, AreKnownWhereTheEyeIs) {
    const auto from = [](Scene scene, glm::dvec3 eye) {
        scene.camera = {eye, {0.1, -0.2, -3}, {0, 1, 0}, 70};
        return scene;
    };
    const Settings settings = sized(120, 90, 5);
    EXPECT_EQ(differenceOf("eye-bubble", from(room(kBubble), {0.1, 0.2, 0.1}), settings).outliers, 0);
    EXPECT_EQ(differenceOf("eye-glass", from(room(kBubble), {0.1, 0.2, 0.8}), settings).outliers, 0);
    const Scene overlap = room(ball("wine", "[-0.4, 0, 0]", 0.7) + "," + ball("ice", "[0.4, 0, 0]", 0.75));
    EXPECT_EQ(differenceOf("eye-overlap", from(overlap, {0, 0.1, 0.2}), settings).outliers, 0);
    const Scene pool = room(R"({"plane": {"point": [0, 2, 0], "normal": [0, 1, 0]}, "material": "wine"},)" +
                            ball("air", "[0, 0, -1]", 0.5));
    EXPECT_EQ(differenceOf("eye-pool", from(pool, {0.2, 0.3, 1}), settings).outliers, 0);
}

// Bodies that move through one another, and about an eye at rest, are ranked and found where they are.
TEST(Media, MoveAsTheirBodiesDo) {
    Settings settings = sized(120, 90, 5);
    settings.time = 1.3;
    const std::string orbit = R"(, "motion": {"orbit": {"cos": [0.5, 0.1, 0], "sin": [0, 0.2, 0.6]}})";
    for (const double eye : {6.0, 0.95}) {
        Scene moving = room(ball("glass", kMiddle, 1) + "," + ball("wine", "[0.1, 0, 0]", 0.6, orbit));
        moving.camera.eye = {0, 0, eye};
        Scene resting = moving;
        const std::vector<Shape> shapes = shapesAt(moving, settings.time);
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            resting.objects[i].shape = shapes[i];
            resting.objects[i].motion.reset();
        }
        const FloatImage image = outputOf(moving, settings, Aov::Color);
        EXPECT_EQ(held("moving", image, Picture(resting, 120, 90, 5)).outliers, 0) << eye;
    }
}

// All light that enters glass leaves it: before a sky of one colour nothing is to be seen of clear bodies at any depth.
TEST(DepthLimit, EndsNoLightInDielectrics) {
    for (const std::string& objects : {ball("glass", kMiddle, 1), kBubble, pane(-0.3) + "," + pane(0.3),
                                       ball("glass", "[-0.4, 0, 0]", 0.7) + "," + ball("ice", "[0.4, 0, 0]", 0.75)}) {
        Scene scene = room(objects);
        scene.objects.erase(scene.objects.begin(), scene.objects.begin() + 2);
        scene.lights.clear();
        scene.background.color = glm::dvec3(1);
        for (int depth = 1; depth <= 8; ++depth) {
            const FloatImage image = outputOf(scene, sized(60, 45, depth), Aov::Color);
            const auto [least, most] = std::ranges::minmax(image.pixels);
            EXPECT_NEAR(least, 1, 2e-5) << depth; // throughput is kept to a millionth on the stack
            EXPECT_NEAR(most, 1, 2e-5) << depth;
        }
    }
}

TEST(DepthLimit, IsDarkWhereTheSceneSaysSo) {
    Scene scene = room(kBubble);
    scene.depthLimit = DepthLimit::Dark;
    EXPECT_EQ(differenceOf("dark", scene, sized(120, 90, 4)).outliers, 0);
}

/// Mean over the pixels of the worst channel's difference, as a screen shows it.
double meanError(const FloatImage& image, const Picture& oracle) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            double worst = 0;
            for (int c = 0; c < 3; ++c)
                worst = std::max(worst, std::abs(std::min<double>(image.at(x, y)[c], 1) -
                                                 std::min<double>(oracle.middle(x, y)[c], 1)));
            sum += worst;
        }
    return sum / (double(image.width) * image.height);
}

class DepthCut : public testing::TestWithParam<Case> {};

// What the depth cuts is told as the error of the colours, with a depth that would do; there is nothing to tell there.
// The oracle, which goes to depth 10, finds the same error but for what depth 8 lacks itself, and little at that depth.
TEST_P(DepthCut, IsToldAsTheErrorOfTheColours) {
    offscreen();
    const Scene scene = room(GetParam().objects);
    const auto told = [&](int depth) {
        Drawing drawing(scene, sized(160, 120, depth));
        return drawing.renderer().depthCut(drawing.view);
    };
    const std::string few = told(2);
    std::printf("%s\n", few.c_str());
    const std::size_t number = few.find("colours ") + 8, at = few.find("; depth ");
    ASSERT_NE(at, std::string::npos);
    EXPECT_NE(few.find("leaves less than 1 %"), std::string::npos);
    const int enough = few[at + 8] - '0';
    EXPECT_GT(enough, 2);
    EXPECT_EQ(told(enough), "");
    EXPECT_NE(told(enough - 1), "");
    const Picture oracle(scene, 32, 24, 10);
    const auto error = [&](int depth) { return meanError(outputOf(scene, sized(32, 24, depth), Aov::Color), oracle); };
    const double off = error(2), left = error(enough), least = error(8);
    std::printf("%g at depth 2, %g at %d, %g at 8\n", off, left, enough, least);
    EXPECT_NEAR(std::stod(few.substr(number)) / 100, off, 0.006 + least);
    EXPECT_LE(left, 0.01 + 1.5 * least);
}

INSTANTIATE_TEST_SUITE_P(Scenes, DepthCut,
                         testing::Values(Case{"hollow", ball("glass", kMiddle, 1) + "," + ball("air", kMiddle, 0.9), 0},
                                         Case{"panes",
                                              pane(-0.9) + "," + pane(-0.3) + "," + pane(0.3) + "," + pane(0.9), 0}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(DepthCutNote, IsNotToldWhereNothingIsCut) {
    offscreen();
    const auto told = [](const Scene& scene, int depth) {
        Drawing drawing(scene, sized(160, 120, depth));
        return drawing.renderer().depthCut(drawing.view);
    };
    EXPECT_EQ(told(room(ball("red", kMiddle, 1)), 1), "") << "nothing is mirrored";
    Scene hollow = room(ball("glass", kMiddle, 1) + "," + ball("air", kMiddle, 0.9));
    EXPECT_EQ(told(hollow, 8), "") << "there is no more";
    hollow.depthLimit = DepthLimit::Dark;
    EXPECT_EQ(told(hollow, 2), "") << "the scene wants it so";
}

// Through a body that bends nothing, the sky is exp(-absorption * thickness) of itself.
TEST(Absorption, IsBeersLaw) {
    const Scene scene = sceneFrom(R"({"background": {"color": [1, 1, 1]},
        "camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "fov": 1},
        "materials": {"dye": {"dielectric": {"ior": 1, "absorption": [0, 0.5, 1.25]}}},
        "objects": [{"box": {"center": [0, 0, 0], "half_size": [1, 1, 0.75]}, "material": "dye"}]})");
    const FloatImage image = outputOf(scene, sized(5, 5), Aov::Color);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(image.at(2, 2)[c], std::exp(-1.5 * std::vector{0.0, 0.5, 1.25}[std::size_t(c)]), 2e-6);
}

// A ray that passes on into a Mandelbulb, whose gradient may lie, is not held up where it does: no pixel of these
// passes more than 64 surfaces that are none.
TEST(Media, AreEnteredWhereTheGradientJumps) {
    offscreen();
    const Scene scene = room(R"({"mandelbulb": {"center": [0, 0, 0], "radius": 1, "power": 8, "iterations": 4},
                                 "material": "glass", "casts_shadow": false},)" +
                             ball("glass", "[0.6, 0, 0.4]", 0.5));
    std::string fewer(shaderText("integrator/whitted.glsl"));
    const std::string most = "kMostPassed = 256";
    ASSERT_NE(fewer.find(most), std::string::npos);
    fewer.replace(fewer.find(most), most.size(), "kMostPassed = 64");
    const ShaderFile overrides[] = {{"integrator/whitted.glsl", fewer}};
    for (const March march : {March::Steps, March::Sphere, March::Cone, March::Relaxed}) {
        Settings settings = sized(64, 48, 3);
        settings.march = march;
        EXPECT_EQ(difference(Drawing(scene, settings, overrides).output(), outputOf(scene, settings, Aov::Color)), "")
            << int(march);
    }
}

/// Of the pixels of two pictures, the fraction that differs by more than `by` in some channel.
double differing(const FloatImage& a, const FloatImage& b, double by) {
    int off = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
        double worst = 0;
        for (std::size_t c = i; c < i + 3; ++c) worst = std::max(worst, double(std::abs(a.pixels[c] - b.pixels[c])));
        off += !(worst <= by);
    }
    return 3.0 * off / double(a.pixels.size());
}

// A bubble is the hole that a difference leaves, but for the highlights, which a hole has of the glass.
TEST(Bubble, IsTheHoleOfADifference) {
    const auto picture = [](const std::string& objects) {
        Scene scene = room(objects);
        for (Material& material : scene.materials) material.specular = glm::dvec3(0);
        return outputOf(scene, sized(160, 120, 8), Aov::Color);
    };
    const FloatImage hole = picture(R"({"difference": [{"sphere": {"center": [0, 0, 0], "radius": 1}},
        {"sphere": {"center": [0, 0, 0], "radius": 0.5}}], "material": "glass", "casts_shadow": false})");
    EXPECT_LE(differing(picture(kBubble), hole, 2e-3), 0.003);
}

/// A tumbler with water that overlaps its wall and its bottom by so much, standing on the floor.
Scene tumbler(double overlap) {
    const std::string radius = std::to_string(0.6 + overlap), bottom = std::to_string(-0.8 - overlap);
    return room(R"({"difference": [{"cylinder": {"from": [0, -1, 0], "to": [0, 0.8, 0], "radius": 0.7}},
        {"cylinder": {"from": [0, -0.8, 0], "to": [0, 1, 0], "radius": 0.6}}], "material": "glass",
        "casts_shadow": false},
        {"cylinder": {"from": [0, )" +
                bottom + R"(, 0], "to": [0, 0.4, 0], "radius": )" + radius +
                R"(}, "material": "wine", "casts_shadow": false})");
}

// Water that just touches its glass is seen as water that overlaps it a little: there is no film of air between, and
// none between the glass and the floor.
TEST(Touching, LeavesNoFilmOfAir) {
    const FloatImage touching = outputOf(tumbler(0), sized(160, 120, 6), Aov::Color);
    const FloatImage overlapping = outputOf(tumbler(1e-3), sized(160, 120, 6), Aov::Color);
    save("touching", 160, 120,
         [&](int x, int y) { return glm::dvec3(touching.at(x, y)[0], touching.at(x, y)[1], touching.at(x, y)[2]); });
    save("overlapping", 160, 120, [&](int x, int y) {
        return glm::dvec3(overlapping.at(x, y)[0], overlapping.at(x, y)[1], overlapping.at(x, y)[2]);
    });
    std::printf("%g of the pixels differ by more than 0.02\n", differing(touching, overlapping, 0.02));
    EXPECT_LE(differing(touching, overlapping, 0.02), 0.02);
}

// A ray that has lost its entry on the ray stack is traced anew through the same media.
TEST(Media, AreTheSameOnARetrace) {
    offscreen();
    const Scene scene = room(ball("glass", kMiddle, 1) + "," + ball("wine", "[0, -0.1, 0]", 0.8) + "," +
                             ball("air", "[0.1, -0.1, 0.2]", 0.4));
    const auto with = [&](const char* entries) {
        std::string text(shaderText("integrator/ray_stack.glsl"));
        text.replace(text.find("kRayStack = 3"), 13, std::string("kRayStack = ") + entries);
        const ShaderFile overrides[] = {{"integrator/ray_stack.glsl", text}};
        return Drawing(scene, sized(120, 90, 8), overrides).output();
    };
    const FloatImage seven = with("7");
    EXPECT_LE(differing(with("3"), seven, 1e-6), 0);
    EXPECT_LE(differing(with("1"), seven, 1e-6), 0);
}

} // namespace
} // namespace gnomon
