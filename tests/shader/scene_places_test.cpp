/// One scene at other sizes and places is one picture, within what the oracle sees about each pixel.
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
            for (double& value : valuesOf(object.shape, field.key)) value *= factor;
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

Scene stillLifeOn(const Shape& ground) {
    Scene scene = plainStillLife();
    scene.objects[0].shape = ground;
    return scene;
}
Scene stillLifeOnALargeSphere() { return stillLifeOn(makeShape(ShapeKind::Sphere, {{0, -10000, 0}}, {10000})); }
/// Slanted; it passes through the middle of the floor that it replaces.
Scene stillLifeOnAPlane() { return stillLifeOn(makeShape(ShapeKind::Plane, {{0, 0, 0}, {0.28, 0.96, 0}})); }

const Variant kVariants[] = {{"plain", plainStillLife},
                             {"shiny", shinyStillLife},
                             {"large_sphere", stillLifeOnALargeSphere},
                             {"plane", stillLifeOnAPlane}};
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
