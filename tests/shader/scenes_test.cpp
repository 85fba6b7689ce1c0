/// Whole pictures of hard scenes, pixel by pixel against the oracle's (lab/reference/exact/picture.h).
///
/// The claim is always: no isolated pixel. Each pixel lies within what the oracle sees over that pixel and its eight
/// neighbours, four samples a side in each and both brinks of the edges between them, give or take kTolerance. A ray's
/// direction is known to float32 only, 6e-8 of the distance to the side (6e-4 units from 1e4 away, a twentieth of a
/// pixel there): an edge may fall beside the true one by that much, but there is no speck where there is no edge.
/// GNOMON_PICTURES=FOLDER keeps both pictures of each test.

#include "lab/reference/exact/fresnel.h"
#include "tests/support/oracle_pictures.h"

#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <string>

namespace gnomon {
namespace {

using namespace test;
using namespace oracle;

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

/// A steep patch that shadows itself, over a disc, in a mirror that is a patch, too.
constexpr const char* kPatches = R"({"background": {"color": [0.1, 0.15, 0.25]},
    "camera": {"eye": [1.6, 2.2, 2.6], "target": [0, 0, 0], "fov": 40},
    "lights": [{"point": {"position": [-2.4, 1.3, 1.6]}}],
    "materials": {"hills": {"ambient": [0.06, 0.05, 0.04], "diffuse": [0.7, 0.45, 0.2],
                            "specular": 0.3, "shininess": 20},
                  "mirror": {"ambient": 0, "diffuse": 0, "conductor": {"n": [0.15, 0.14, 0.2], "k": [4.0, 3.2, 2.6]}},
                  "floor": {"ambient": 0.05, "diffuse": [0.4, 0.45, 0.5]}},
    "objects": [{"patch": {"random": 5, "size": [1.5, 0.4, 1.5]}, "material": "hills"},
                {"group": {"of": [{"patch": {"size": [2.6, 1, 2.2], "heights": [0, 0.2, 0.2, 0, 0.1, 0.3, 0.3, 0.1,
                                             0.1, 0.3, 0.3, 0.1, 0, 0.2, 0.2, 0]}}],
                           "rotate": [80, 25, 0], "translate": [-0.8, 0.2, -1.6]}, "material": "mirror"},
                {"disc": {"center": [0, -1, 0], "normal": [0, 1, 0], "radius": 3}, "material": "floor"}]})";

TEST(Patches, HaveNoIsolatedPixel) {
    EXPECT_EQ(differenceOf("patches", sceneFrom(kPatches), sized(200, 150, 4)).outliers, 0);
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
    const double cosine = std::sqrt(1 - (1 - k) / (ior * ior));
    const double mirrored = oracle::fresnelReflectance(cosine, std::complex<double>(1 / ior));
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

// For the reflectance b² = n² c² + (1 - n²) stands in for k: n² c² carries six roundings of 2^-24, 1 - n² three, and
// n² c² is n² - 1 at the critical angle.
double errorOfReflectance(double ior) { return (ior * ior - 1) * 9 * 0x1p-24 + errorOfK(ior); }

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
                const double more = errorOfReflectance(ior);
                const double least = redAndGreen(ior, k - more).y, most = redAndGreen(ior, k + more).y;
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

} // namespace
} // namespace gnomon
