/// Whole pictures of hard scenes, pixel by pixel against the oracle's (lab/reference/exact/picture.h).
///
/// The claim is always: no isolated pixel. Each pixel lies within what the oracle sees over that pixel and its eight
/// neighbours, four samples a side in each and both brinks of the edges between them, give or take kTolerance. A ray's
/// direction is known to float32 only, 6e-8 of the distance to the side (6e-4 units from 1e4 away, a twentieth of a
/// pixel there): an edge may fall beside the true one by that much, but there is no speck where there is no edge.
/// GNOMON_PICTURES=FOLDER keeps both pictures of each test.

#include "native/file/image_file.h"
#include "lab/reference/exact/picture.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ostream>
#include <string>

namespace gnomon {
namespace {

using namespace test;
using namespace oracle;

/// A quarter of one step of an eight-bit channel. The peak of a highlight may fall between the oracle's samples, at
/// most 1/8 pixel from one: where a pixel turns the normal by a, that is specular * shininess * a² / 128 short of the
/// peak, here at most 7.4e-4 (the still life's torus: 0.3, 20, 0.126; the torus in the open: 0.5, 40, 0.058). Float32
/// adds 1e-5: a few roundings of a unit normal, 2^-22, times shininess.
constexpr double kTolerance = 1.0 / 1024;

Settings sized(int width, int height, int depth = 4) {
    Settings settings;
    settings.size = {width, height};
    settings.depth = depth;
    settings.threshold = 0; // the oracle follows every ray
    return settings;
}

std::uint8_t encoded(double linear) {
    const double c = std::clamp(linear, 0.0, 1.0);
    const double shown = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    return std::uint8_t(std::lround(255 * shown));
}

template<typename ColorAt>
void save(const std::string& name, int width, int height, ColorAt colorAt) {
    const char* folder = std::getenv("GNOMON_PICTURES");
    if (!folder) return;
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 color = colorAt(x, y);
            for (int c = 0; c < 3; ++c) image.rgba.push_back(encoded(color[c]));
            image.rgba.push_back(255);
        }
    Problems problems;
    writeImage(std::string(folder) + "/" + name + ".png", image, problems);
    EXPECT_EQ(toString(problems), "");
}

/// Compares, tells the figures, keeps the pictures.
Difference held(const std::string& name, const FloatImage& image, const Picture& oracle) {
    save(name, image.width, image.height, [&](int x, int y) {
        const float* p = image.at(x, y);
        return glm::dvec3(p[0], p[1], p[2]);
    });
    save(name + "-oracle", image.width, image.height, [&](int x, int y) { return oracle.middle(x, y); });
    const Difference d = compare(image, oracle, kTolerance);
    std::printf("%s: %d outliers, worst %.2g at (%d, %d), %d moved, rmse %.2g\n", name.c_str(), d.outliers, d.worst,
                d.worstAt.x, d.worstAt.y, d.moved, d.rmse);
    return d;
}

Difference differenceOf(const std::string& name, const Scene& scene, const Settings& settings) {
    return held(name, outputOf(scene, settings, Aov::Color),
                Picture(scene, settings.size.x, settings.size.y, settings.depth));
}

// --- a torus in the open
// ------------------------------------------------------------------------------------------------

/// Fills the picture from `distance`; its upper side throws shadows on its lower, and all of it on the disc below.
Scene torusFrom(double distance) {
    Scene scene = sceneFrom(R"({"background": {"color": [0.1, 0.15, 0.25]},
        "lights": [{"point": {"position": [-3.4, 0.2, 1.6]}}],
        "materials": {"tube": {"ambient": [0.06, 0.05, 0.04], "diffuse": [0.7, 0.45, 0.2],
                               "specular": 0.5, "shininess": 40},
                      "floor": {"ambient": 0.05, "diffuse": [0.4, 0.45, 0.5]}},
        "objects": [{"torus": {"center": [0.3, -0.7, 0.2], "axis": [0.3, 0.8, 0.5],
                               "major_radius": 1, "minor_radius": 0.25},
                     "material": "tube"},
                    {"disc": {"center": [0.5, -2, -0.5], "normal": [0, 1, 0], "radius": 3}, "material": "floor"}]})");
    const glm::dvec3 center(0.3, -0.7, 0.2);
    scene.camera.target = center;
    scene.camera.eye = center + distance * glm::normalize(glm::dvec3(-0.35, 0.75, 0.6));
    scene.camera.fov = glm::degrees(2 * std::atan(1.3 / distance)); // from far narrower than scene files allow
    return scene;
}

class TorusFromFar : public testing::TestWithParam<int> {};

// From near and from 10 000 units away a torus that shadows itself and a floor shows no isolated pixel.
TEST_P(TorusFromFar, HasNoIsolatedPixel) {
    const double distance = GetParam() / 10.0;
    const Difference d = differenceOf("torus-" + std::to_string(GetParam()), torusFrom(distance), sized(240, 180));
    EXPECT_EQ(d.outliers, 0);
}

INSTANTIATE_TEST_SUITE_P(TenthsOfAUnit, TorusFromFar, testing::Values(18, 100, 1000, 10000, 100000),
                         [](const auto& test) { return std::to_string(test.param); });

// What these pictures are for is in them: shadow of the torus on itself, and on the floor.
TEST(TorusInTheOpen, ShadowsItselfAndTheFloor) {
    Settings settings = sized(240, 180);
    const FloatImage object = outputOf(torusFrom(10), settings, Aov::Object);
    const FloatImage shadowed = outputOf(torusFrom(10), settings, Aov::Color);
    settings.shadows = ShadowModel::Off;
    const FloatImage bare = outputOf(torusFrom(10), settings, Aov::Color);
    int darker[2] = {0, 0};
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 240; ++x)
            if (const int seen = int(*object.at(x, y)); seen >= 0) darker[seen] += *shadowed.at(x, y) < *bare.at(x, y);
    EXPECT_GT(darker[0], 900);
    EXPECT_GT(darker[1], 900);
}

// The measure itself: one pixel off by three times the tolerance, and one that is not a number, are found.
TEST(Comparison, FindsSinglePixels) {
    const Scene scene = torusFrom(10);
    FloatImage image = outputOf(scene, sized(80, 60), Aov::Color);
    const Picture oracle(scene, 80, 60, 4);
    EXPECT_EQ(compare(image, oracle, kTolerance).outliers, 0);
    image.at(3, 0)[1] += float(3 * kTolerance); // in the sky
    image.at(70, 50)[2] = NAN;
    const Difference d = compare(image, oracle, kTolerance);
    EXPECT_EQ(d.outliers, 2);
    EXPECT_EQ(d.worstAt, glm::ivec2(70, 50));
}

// --- rays that bounce and bend
// ------------------------------------------------------------------------------------------

constexpr const char* kNestedGlass = R"({"background": {"color": [0.25, 0.35, 0.5]},
    "camera": {"eye": [0.4, 1.1, 4.2], "target": [0, 0, 0], "fov": 36},
    "lights": [{"point": {"position": [3, 4, 3]}}, {"point": {"position": [-4, 1.5, 2]}, "color": [0.3, 0.3, 0.4]}],
    "materials": {
        "glass": {"ambient": 0, "diffuse": 0, "specular": 0.4, "shininess": 60, "dielectric": {"ior": 1.5}},
        "water": {"ambient": 0, "diffuse": 0, "dielectric": {"ior": 1.33}},
        "red": {"ambient": [0.1, 0.02, 0.02], "diffuse": [0.8, 0.2, 0.1], "specular": 0.3, "shininess": 20},
        "lacquer": {"ambient": 0.05, "diffuse": [0.1, 0.5, 0.3], "coat": {"ior": 1.5}},
        "floor": {"ambient": 0.06, "diffuse": [0.55, 0.5, 0.45]}},
    "objects": [
        {"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "glass", "casts_shadow": false},
        {"sphere": {"center": [0.1, 0.15, 0.2], "radius": 0.6}, "material": "water", "casts_shadow": false},
        {"sphere": {"center": [0.2, 0.05, 0.25], "radius": 0.25}, "material": "red"},
        {"plane": {"point": [0, -1.2, 0], "normal": [0, 1, 0]}, "material": "floor"},
        {"sphere": {"center": [-1.6, -0.6, -1.4], "radius": 0.6}, "material": "lacquer"},
        {"box": {"center": [1.5, -0.5, -1.8], "half_size": [0.4, 0.7, 0.4]}, "material": "red"}]})";

// A ball in a bubble of water in a ball of glass, eight rays deep, shows no isolated pixel.
TEST(NestedGlass, HasNoIsolatedPixel) {
    EXPECT_EQ(differenceOf("nested-glass", sceneFrom(kNestedGlass), sized(160, 120, 8)).outliers, 0);
}

constexpr const char* kInfinityMirror = R"({"background": {"color": [0.02, 0.03, 0.05]},
    "camera": {"eye": [-0.3, 1.6, 0.6], "target": [0, 0.9, -0.9], "fov": 70},
    "lights": [{"point": {"position": [0.5, 2.5, 0.2]}}],
    "materials": {
        "mirror": {"ambient": 0, "diffuse": 0, "conductor": {"n": [0.15, 0.14, 0.2], "k": [4.0, 3.2, 2.6]}},
        "red": {"ambient": [0.1, 0.02, 0.02], "diffuse": [0.8, 0.2, 0.1], "specular": 0.3, "shininess": 20},
        "blue": {"ambient": [0.02, 0.04, 0.1], "diffuse": [0.2, 0.3, 0.8], "specular": 0.3, "shininess": 20},
        "floor": {"ambient": 0.06, "diffuse": [0.55, 0.5, 0.45]}},
    "objects": [
        {"plane": {"point": [0, 0, -0.75], "normal": [0, 0, 1]}, "material": "mirror"},
        {"plane": {"point": [0, 0, 0.75], "normal": [0, 0, -1]}, "material": "mirror"},
        {"sphere": {"center": [0.1, -0.2, -0.3], "radius": 0.3}, "material": "red"},
        {"torus": {"center": [-0.4, 0.5, 0], "axis": [0.4, 0.3, 0.9], "major_radius": 0.4, "minor_radius": 0.12},
         "material": "blue"},
        {"plane": {"point": [0, -0.5, 0], "normal": [0, 1, 0]}, "material": "floor"}]})";

// Between two parallel mirrors, eight rays deep, shows no isolated pixel.
TEST(InfinityMirror, HasNoIsolatedPixel) {
    EXPECT_EQ(differenceOf("infinity-mirror", sceneFrom(kInfinityMirror), sized(240, 180, 8)).outliers, 0);
}

// --- the critical angle
// ---------------------------------------------------------------------------------------------------

/// Inside of a block of index `ior`, at the origin, under its top, y = 1. What the top reflects is a red lamp just
/// below the eye, what it lets through a green sky a thousand times as bright.
Scene underTheTop(double ior) {
    Scene scene = sceneFrom(R"({"materials": {"clear": {"ambient": 0, "diffuse": 0, "dielectric": {"ior": 1.5}},
                                             "lamp": {"ambient": 0, "diffuse": 0, "emission": [1, 0, 0]}},
        "objects": [{"box": {"center": [0, -3, 0], "half_size": [8, 4, 8]}, "material": "clear"},
                    {"disc": {"center": [0, -0.5, 0], "normal": [0, 1, 0], "radius": 7}, "material": "lamp"}]})");
    for (Material& material : scene.materials)
        if (auto* dielectric = std::get_if<Dielectric>(&material.optics)) dielectric->ior = ior;
    scene.background.color = {0, 1000, 0};
    return scene;
}

/// What leaves towards the eye where the squared cosine beyond the surface is k.
glm::dvec2 redAndGreen(double ior, double k) {
    if (k < 0) return {1, 0};
    const double atNormal = std::pow((ior - 1) / (ior + 1), 2);
    const double mirrored = atNormal + (1 - atNormal) * std::pow(1 - std::sqrt(std::min(k, 1.0)), 5);
    return {mirrored, 1000 * (1 - mirrored)};
}

/// One ray that meets the top at sin(angle) = (1 + `off`) / ior, `turn` about the vertical.
CameraPose towardsTheTop(double ior, double off, double turn) {
    const double sine = (1 + off) / ior;
    CameraPose pose;
    pose.eye = {0, 0, 0};
    pose.target = {sine * std::cos(turn), std::sqrt(1 - sine * sine), sine * std::sin(turn)};
    pose.fov = 1;
    return pose;
}

/// k = 1 - ior² sin² of the middle ray, as the rounding of its direction to float32 left it.
double squaredCosineBeyond(const CameraPose& pose, double ior) {
    Vec origin, direction;
    pixelRay(pose, 0, 0, 1, 1, origin, direction);
    const long double across = direction.x * direction.x + direction.z * direction.z;
    return double(1 - (long double)(float(ior)) * float(ior) * across);
}

// The shader has k = 1 - n² (1 - c²) of a cosine c that carries the two roundings of normalising, 2^-23 c, and one each
// of c², n², the product and, at an index below √2, the difference: |error| <= n² (2^-22 c² + 2^-24 c² + 2^-25) +
// 2^-23.
double errorOfK(double ior) {
    const double square = ior * ior, cosine2 = 1 - 1 / square;
    return square * (0x1p-22 * cosine2 + 0x1p-24 * cosine2 + 0x1p-25) + 0x1p-23;
}

// Total reflection is decided as by exact arithmetic from errorOfK() on, which holds for the sine of the critical angle
// times 1 ± 1e-6 and ± 1e-5; within, at ± 1e-7, it is one of the two, and what is not reflected goes through.
TEST(CriticalAngle, DecidesBetweenReflectionAndTransmission) {
    offscreen();
    for (const double ior : {1.33, 1.5, 2.4}) {
        Drawing drawing(underTheTop(ior), sized(1, 1, 8));
        const double error = errorOfK(ior);
        int decided = 0, wrong = 0, lost = 0, off = 0;
        for (const double by : {-1e-5, -1e-6, -1e-7, 1e-7, 1e-6, 1e-5})
            for (int i = 0; i < 100; ++i) {
                drawing.view.camera = towardsTheTop(ior, by, 0.0628 * i + 0.01);
                const FloatImage image = drawing.output();
                const double red = image.at(0, 0)[0], green = image.at(0, 0)[1];
                const double k = squaredCosineBeyond(drawing.view.camera, ior);
                if (std::abs(k) > error) {
                    ++decided;
                    wrong += (green > 0) != (k > 0);
                }
                // Green shows 1000 (1 - F), which float32 has to 1000 * 2^-24 only, and so has red + green / 1000.
                lost += !(std::abs(red + green / 1000 - 1) <= 0x1p-21);
                const double least = redAndGreen(ior, k - error).y, most = redAndGreen(ior, k + error).y;
                off += !(green >= least - 2e-3 && green <= most + 2e-3);
            }
        std::printf("ior %g: %d decided beyond |k| > %.2g, %d wrong, %d lost, %d off\n", ior, decided, error, wrong,
                    lost, off);
        EXPECT_GE(decided, 400) << "all of 1e-6 and 1e-5";
        EXPECT_EQ(wrong, 0);
        EXPECT_EQ(lost, 0) << "neither black nor NaN nor both";
        EXPECT_EQ(off, 0);
    }
}

// --- inside of closed shapes
// --------------------------------------------------------------------------------------------

struct Inside {
    const char* name;
    const char* shape;
    glm::dvec3 eye, target, light;
    const char* pebble; ///< centre of a small ball within, so that the walls hold a shadow
};
std::ostream& operator<<(std::ostream& out, const Inside& in) { return out << in.name; }

class InsideOf : public testing::TestWithParam<Inside> {};

// The picture from inside of a closed shape, with the light in there too, shows no isolated pixel.
TEST_P(InsideOf, HasNoIsolatedPixel) {
    const Inside& in = GetParam();
    Scene scene =
        sceneFrom(std::string(R"({"background": {"color": [1, 0, 1]}, "lights": [{"point": {"position": [0, 0, 0]}}],
        "materials": {"wall": {"ambient": 0.04, "diffuse": [0.3, 0.5, 0.6], "specular": 0.4, "shininess": 30},
                      "pebble": {"ambient": 0.04, "diffuse": [0.8, 0.4, 0.1]}},
        "objects": [{)") +
                  in.shape + R"(, "material": "wall"}, {"sphere": {"center": )" + in.pebble +
                  R"(, "radius": 0.05}, "material": "pebble"}]})");
    scene.camera = {in.eye, in.target, {0, 1, 0}, 95};
    scene.lights[0].position = in.light;
    EXPECT_EQ(differenceOf(std::string("inside-") + in.name, scene, sized(240, 180)).outliers, 0);
}

INSTANTIATE_TEST_SUITE_P(
    ClosedShapes, InsideOf,
    testing::Values(
        Inside{"sphere",
               R"("sphere": {"center": [0.3, -0.7, 0.2], "radius": 1})",
               {0.5, -0.4, 0.8},
               {0.1, -0.9, -0.3},
               {0.2, -0.1, 0.3},
               "[0.25, -0.75, 0.1]"},
        Inside{"torus",
               R"("torus": {"center": [0.3, -0.7, 0.2], "axis": [0, 1, 0], "major_radius": 1, "minor_radius": 0.25})",
               {1.25, -0.65, 0.25},
               {1.1, -0.75, -0.4},
               {1.15, -0.6, -0.1},
               "[1.1, -0.78, -0.3]"},
        Inside{"box",
               R"("box": {"center": [0.3, -0.7, 0.2], "half_size": [1, 0.6, 0.8]})",
               {0.9, -0.4, 0.8},
               {0.1, -0.9, -0.3},
               {0.2, -0.2, 0.3},
               "[0.2, -0.9, 0.1]"},
        Inside{"cylinder",
               R"("cylinder": {"from": [-0.6, -0.9, 0.3], "to": [0.9, 0.4, -0.5], "radius": 0.6})",
               {0.7, 0.3, -0.2},
               {-0.3, -0.7, 0.1},
               {0.2, 0.2, 0.1},
               "[0.05, -0.35, 0.05]"},
        Inside{"capsule",
               R"("capsule": {"from": [-0.6, -0.9, 0.3], "to": [0.9, 0.4, -0.5], "radius": 0.6})",
               {0.7, 0.3, -0.2},
               {-0.3, -0.7, 0.1},
               {0.2, 0.2, 0.1},
               "[0.05, -0.35, 0.05]"},
        Inside{"cone",
               R"("cone": {"from": [-0.6, -0.9, 0.3], "to": [0.9, 0.9, -0.5], "radius": 1.1})",
               {-0.3, -0.9, 0.7},
               {0.2, 0.1, -0.1},
               {-0.3, -0.3, 0.3},
               "[-0.1, -0.35, 0.05]"}),
    [](const auto& test) { return std::string(test.param.name); });

// --- one scene at other sizes and places
// ----------------------------------------------------------------------------------

/// All coordinates are multiples of 1/64: float32 holds them at 1e5, too.
constexpr const char* kStillLife = R"({"background": {"color": [0.2, 0.25, 0.35]},
    "camera": {"eye": [1.5, 4, 7], "target": [0, 0.5, 0], "fov": 40},
    "lights": [{"point": {"position": [5, 6, 3]}}],
    "materials": {
        "red": {"ambient": [0.1, 0.02, 0.02], "diffuse": [0.8, 0.2, 0.1], "specular": 0.3, "shininess": 20},
        "green": {"ambient": [0.02, 0.08, 0.03], "diffuse": [0.2, 0.6, 0.3], "specular": 0.3, "shininess": 20},
        "blue": {"ambient": [0.02, 0.04, 0.1], "diffuse": [0.2, 0.3, 0.8], "specular": 0.3, "shininess": 20},
        "floor": {"ambient": 0.06, "diffuse": [0.55, 0.5, 0.45]}},
    "objects": [
        {"disc": {"center": [0, 0, 0], "normal": [0, 1, 0], "radius": 3.5}, "material": "floor"},
        {"sphere": {"center": [-1.5, 0.75, 0.5], "radius": 0.75}, "material": "red"},
        {"torus": {"center": [0.5, 0.75, 1.25], "axis": [0.25, 0.75, 0.5], "major_radius": 0.75, "minor_radius": 0.25},
         "material": "blue"},
        {"box": {"center": [1.75, 0.625, -0.75], "half_size": [0.5, 0.625, 0.5]}, "material": "green"},
        {"cone": {"from": [-0.5, 0.125, -1.5], "to": [-0.25, 1.875, -1.25], "radius": 0.75}, "material": "blue"}]})";

/// All lengths times `factor`, the camera's and the lights' as well.
Scene scaled(Scene scene, double factor) {
    for (Object& object : scene.objects)
        for (const ShapeField& field : shapeRow(object.shape.kind).fields) {
            if (field.type == FieldType::Direction) continue;
            const int texels = field.type == FieldType::Vertices ? 3 : 1, one = field.type == FieldType::Length;
            for (int i = 0; i < texels; ++i)
                for (int c = field.component; c < field.component + (one ? 1 : 3); ++c)
                    object.shape.texels[std::size_t(field.texel + i)][c] *= factor;
        }
    for (Light& light : scene.lights) light.position *= factor;
    scene.camera.eye *= factor;
    scene.camera.target *= factor;
    return scene;
}

const Picture& stillLife() {
    static const Picture picture(sceneFrom(kStillLife), 240, 180, 4);
    return picture;
}

// A scene of 1e-4, of 1 and of 1e4 times the size is one picture.
TEST(Scale, ChangesNoPicture) {
    for (const double factor : {1e-4, 1.0, 1e4}) {
        const Scene scene = scaled(sceneFrom(kStillLife), factor);
        char name[40];
        std::snprintf(name, sizeof name, "scaled-%g", factor);
        EXPECT_EQ(held(name, outputOf(scene, sized(240, 180), Aov::Color), stillLife()).outliers, 0) << factor;
    }
}

// A scene far away, where float32 has steps of 1/128 or 1/16, is the picture it is at home: the shader works relative
// to a point near it. Each variant is one that the world's coordinates spoil there.
struct Variant {
    const char* name;
    Scene (*scene)();
};

Scene plainStillLife() { return sceneFrom(kStillLife); }

/// Its ball of glass, its box lacquered, all else of metal.
Scene shinyStillLife() {
    Scene scene = plainStillLife();
    for (Material& material : scene.materials) {
        if (material.name == "red") material.optics = Dielectric{1.5};
        if (material.name == "green") material.optics = Coat{1.5, {}};
        if (material.name == "blue" || material.name == "floor")
            material.optics = Conductor{{0.15, 0.14, 0.2}, {4.0, 3.2, 2.6}};
    }
    return scene;
}

Scene stillLifeOn(ShapeKind kind, glm::dvec4 first, glm::dvec4 second) {
    Scene scene = plainStillLife();
    scene.objects[0].shape = {kind, {first, second, glm::dvec4(0)}};
    return scene;
}
Scene stillLifeOnALargeSphere() { return stillLifeOn(ShapeKind::Sphere, {0, -10000, 0, 10000}, {0, 0, 0, 0}); }
/// Slanted; it passes through the middle of the floor that it replaces.
Scene stillLifeOnAPlane() { return stillLifeOn(ShapeKind::Plane, {0, 0, 0, 0}, {0.28, 0.96, 0, 0}); }

const Variant kVariants[] = {
    {"plain", plainStillLife}, {"shiny", shinyStillLife}, {"large_sphere", stillLifeOnALargeSphere}, {"plane", stillLifeOnAPlane}};
/// The last is no multiple of any grid, and leaves the scene far from the grid's points.
constexpr glm::dvec3 kPlaces[] = {{1e5, -1e5, 1e5}, {1e6, 0, 0}, {-123456.7, 98765.4, 999999.1}};

class Place : public testing::TestWithParam<Variant> {
  protected:
    Scene home = GetParam().scene();
    std::string name(int place) const { return std::string("place-") + GetParam().name + "-" + std::to_string(place); }
};
std::ostream& operator<<(std::ostream& out, const Variant& v) { return out << v.name; }

TEST_P(Place, ChangesNoPicture) {
    const Picture oracle(home, 240, 180, 4);
    const Difference atHome = held(name(0), outputOf(home, sized(240, 180), Aov::Color), oracle);
    EXPECT_EQ(atHome.outliers, 0);
    for (int i = 0; i < 3; ++i) {
        const Scene there = moved(home, kPlaces[i]);
        const Difference d = held(name(i + 1), outputOf(there, sized(240, 180), Aov::Color), oracle);
        EXPECT_EQ(d.outliers, 0);
        EXPECT_EQ(d.moved, atHome.moved);
    }
}

/// All outputs but the colour.
struct Outputs {
    FloatImage object, visibility, normal, distance, position;
    explicit Outputs(const Scene& scene)
        : object(of(scene, Aov::Object)), visibility(of(scene, Aov::Visibility)), normal(of(scene, Aov::Normal)),
          distance(of(scene, Aov::Distance)), position(of(scene, Aov::Position)) {}
    static FloatImage of(const Scene& scene, Aov aov) { return outputOf(scene, sized(240, 180), aov); }
    static glm::dvec3 vector(const FloatImage& image, int x, int y) {
        return glm::dvec3(glm::make_vec3(image.at(x, y)));
    }

    /// Something is hit, and the pixels about this one show one surface in one light: rounding decides nothing here.
    bool certain(int x, int y) const {
        if (x == 0 || y == 0 || x == object.width - 1 || y == object.height - 1 || *object.at(x, y) < 0) return false;
        bool alike = true;
        for (int i = 0; i < 9; ++i) {
            const int atX = x + i % 3 - 1, atY = y + i / 3 - 1;
            alike &= *object.at(atX, atY) == *object.at(x, y) && *visibility.at(atX, atY) == *visibility.at(x, y) &&
                     glm::distance(vector(normal, atX, atY), vector(normal, x, y)) < 0.3;
        }
        return alike;
    }
};

// About its own origin the still life has coordinates below 128: an ulp of them is the most that t, across the surface,
// and the surface point move. The normal turns with the point, most on the torus' tube, whose radius is 1/4. The
// position output is the world's and has half a step of float32 there.
class PlaceOfOutputs : public Place {};

TEST_P(PlaceOfOutputs, ChangesNoneButThePosition) {
    constexpr double kStep = 0x1p-17;
    const Outputs here(home);
    for (const glm::dvec3 by : kPlaces) {
        const Scene scene = moved(home, by);
        const Outputs there(scene);
        int certain = 0, wrong = 0;
        double t = 0, turn = 0, off = 0;
        for (int y = 0; y < 180; ++y)
            for (int x = 0; x < 240; ++x) {
                if (!here.certain(x, y)) continue;
                ++certain;
                wrong += *there.object.at(x, y) != *here.object.at(x, y) ||
                         *there.visibility.at(x, y) != *here.visibility.at(x, y);
                const glm::dvec3 normal = Outputs::vector(here.normal, x, y);
                const glm::dvec3 position = Outputs::vector(here.position, x, y);
                const glm::dvec3 way = glm::normalize(position - home.camera.eye);
                const double cosine = std::abs(glm::dot(normal, way));
                t = std::max(t, cosine * std::abs(double(*there.distance.at(x, y)) - *here.distance.at(x, y)));
                turn = std::max(turn, cosine * glm::distance(Outputs::vector(there.normal, x, y), normal));
                const glm::dvec3 world = Outputs::vector(there.position, x, y);
                const glm::dvec3 error = glm::abs(world - by - position) - 0x1p-24 * glm::abs(world);
                off = std::max(off, cosine * std::max({error.x, error.y, error.z}));
            }
        std::printf("%s at %g: %d wrong of %d, t %.2g, normal %.2g, position %.2g\n", GetParam().name, by.x, wrong,
                    certain, t / kStep, turn / kStep, off / kStep);
        EXPECT_GT(certain, 240 * 180 / 3);
        EXPECT_EQ(wrong, 0);
        EXPECT_LE(t, kStep);
        EXPECT_LE(turn, 4 * kStep);
        EXPECT_LE(off, kStep);
    }
}

INSTANTIATE_TEST_SUITE_P(StillLife, Place, testing::ValuesIn(kVariants),
                         [](const auto& test) { return std::string(test.param.name); });
INSTANTIATE_TEST_SUITE_P(StillLife, PlaceOfOutputs, testing::Values(kVariants[0], kVariants[2], kVariants[3]),
                         [](const auto& test) { return std::string(test.param.name); });

// Where a plane's stated point is does not matter either: here 4e5 units away from what lies on it.
TEST(PlaceOfAPlane, ChangesNoPicture) {
    const Scene home = stillLifeOnAPlane();
    const Picture oracle(home, 240, 180, 4);
    for (const glm::dvec3 by : kPlaces) {
        Scene there = moved(home, by);
        there.objects[0].shape = translated(there.objects[0].shape, 4e5 * glm::dvec3(-0.96, 0.28, 0));
        const Difference d = held("plane-from-far", outputOf(there, sized(240, 180), Aov::Color), oracle);
        EXPECT_EQ(d.outliers, 0);
        EXPECT_EQ(d.moved, 0);
    }
}

// A window shows the fractions of the position, which a whole number of units does not change.
TEST(PlaceInAWindow, ChangesNoFractionOfThePosition) {
    offscreen();
    Settings settings = sized(240, 180);
    settings.aov = Aov::Position;
    const Image home = Drawing(plainStillLife(), settings).picture();
    for (const glm::dvec3 by : {kPlaces[0], kPlaces[1]}) {
        const Image there = Drawing(moved(plainStillLife(), by), settings).picture();
        int wrong = 0;
        for (std::size_t i = 0; i < home.rgba.size(); ++i) // 255 is next to 0
            wrong += std::abs(std::int8_t(std::uint8_t(home.rgba[i] - there.rgba[i]))) > 1;
        EXPECT_EQ(wrong, 0) << by.x;
    }
}

// Images, relief, glow, sky and motion go along. A pixel may lie on an edge.
TEST(PlaceOfLite, ChangesNoPicture) {
    Settings settings = sized(240, 180);
    settings.time = 3.7;
    const FloatImage home = outputOf(sceneNamed("lite"), settings, Aov::Color);
    for (const glm::dvec3 by : kPlaces) {
        const FloatImage there = outputOf(moved(sceneNamed("lite"), by), settings, Aov::Color);
        int differ = 0;
        double sum = 0;
        for (std::size_t i = 0; i < home.pixels.size(); ++i) {
            const double d = std::abs(double(home.pixels[i]) - there.pixels[i]);
            sum += d;
            differ += !(d <= kTolerance);
        }
        std::printf("lite at %g: %d values differ, %.2g on average\n", by.x, differ, sum / double(home.pixels.size()));
        EXPECT_LE(differ, 6) << "two pixels";
    }
}

} // namespace
} // namespace gnomon
