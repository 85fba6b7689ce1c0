// The scenes we ship say what their source says.
#include "tests/support/scenes.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>

namespace gnomon {
namespace {

using namespace test;

const std::string kScenes = std::string(GNOMON_SOURCE_DIR) + "/assets/scenes/";

Scene shipped(const std::string& name) {
    Problems problems;
    const std::string file = kScenes + name + ".json";
    auto scene = readScene(textOf(file), file, problems, [](const std::string& beside, Problems&) {
        return std::optional(textOf(kScenes + beside));
    });
    EXPECT_TRUE(scene) << toString(problems);
    return scene.value_or(Scene{});
}

int indexOf(const Scene& scene, const std::string& name) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (scene.objects[i].name == name) return int(i);
    ADD_FAILURE() << "no object " << name;
    return 0;
}

const Object& objectOf(const Scene& scene, const std::string& name) {
    return scene.objects[std::size_t(indexOf(scene, name))];
}

const Material& materialOf(const Scene& scene, const std::string& object) {
    return scene.materials[std::size_t(objectOf(scene, object).material)];
}

std::map<ShapeKind, int> countsOf(const Scene& scene) {
    std::map<ShapeKind, int> counts;
    for (const Object& object : scene.objects) ++counts[object.shape.kind];
    return counts;
}

/// Reflectance at normal incidence.
glm::dvec3 f0(const Conductor& metal) {
    const glm::dvec3 one(1), k2 = metal.k * metal.k;
    return ((metal.n - one) * (metal.n - one) + k2) / ((metal.n + one) * (metal.n + one) + k2);
}
double f0(double ior) { return (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1)); }

// ---- lite

TEST(Lite, HasTenSpheresTwoTrianglesADiscAndThreeLights) {
    const Scene lite = shipped("lite");
    EXPECT_EQ(countsOf(lite),
              (std::map<ShapeKind, int>{{ShapeKind::Sphere, 10}, {ShapeKind::Triangle, 2}, {ShapeKind::Disc, 1}}));
    EXPECT_EQ(lite.lights.size(), 3u);
}

TEST(Lite, ListsItsObjectsInTheOrderOfItsSource) {
    std::vector<std::string> names;
    for (const Object& object : shipped("lite").objects) names.push_back(object.name);
    EXPECT_EQ(names, (std::vector<std::string>{"sun", "green", "blue", "earth", "moon", "lamp-2", "lamp-3", "red",
                                               "gold", "glass", "mirror-1", "mirror-2", "ground"}));
}

TEST(Lite, StandsWhereItsSourceSaysAtAnyTime) {
    const Scene lite = shipped("lite");
    for (double t : {0.0, 1.0, 12.5}) {
        const std::vector<Shape> shapes = shapesAt(lite, t);
        const auto expectAt = [&](const std::string& name, glm::dvec3 wanted) {
            expectNear(pointOf(shapes[std::size_t(indexOf(lite, name))], "center"), wanted, 1e-9, name);
        };
        const glm::dvec3 earth(5 * std::cos(t / 5), 0, 5 * std::sin(t / 5));
        expectAt("sun", {0, 0, 0});
        expectAt("green", {2 * std::sin(t / 2), 0, 2 * std::cos(t / 2)});
        expectAt("blue", {2.5 * std::cos(t / 3), 0, 2.5 * std::sin(t / 3)});
        expectAt("earth", earth);
        expectAt("moon", earth + glm::dvec3(std::cos(2 * t), 0, std::sin(2 * t)));
        expectAt("lamp-2", {-2, 20, 0});
        expectAt("lamp-3", {20, 20, 0});
        expectAt("red", {-1.7, 19.4, -0.3});
        expectAt("gold", {6, 0, -10});
        expectAt("glass", {-7, 0, 0});
        expectAt("ground", {0, -10, 0});
    }
}

TEST(Lite, HasTheRadiiOfItsSource) {
    const Scene lite = shipped("lite");
    const std::map<std::string, double> radii{{"sun", 1.4},  {"green", 0.26},  {"blue", 0.18},   {"earth", 0.366},
                                              {"moon", 0.1}, {"lamp-2", 0.05}, {"lamp-3", 0.05}, {"red", 0.3},
                                              {"gold", 1.4}, {"glass", 1.4},   {"ground", 30}};
    for (const auto& [name, radius] : radii) EXPECT_EQ(lengthOf(objectOf(lite, name).shape, "radius"), radius) << name;
}

TEST(Lite, HangsItsMirrorBehindTheScene) {
    const Scene lite = shipped("lite");
    const Shape &one = objectOf(lite, "mirror-1").shape, &two = objectOf(lite, "mirror-2").shape;
    using Values = std::array<double, kMaxShapeValues>;
    EXPECT_EQ(one.values, (Values{-14, 14, -14, -14, -5, -12, 14, -5, -12}));
    EXPECT_EQ(two.values, (Values{-14, 14, -14, 14, -5, -12, 14, 14, -14}));
}

TEST(Lite, IsLitByThreeWhiteLightsAndSeenFromThirtyFive) {
    const Scene lite = shipped("lite");
    const glm::dvec3 positions[] = {{0, 0, 0}, {-2, 20, 0}, {20, 20, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(lite.lights[i].position, positions[i]);
        EXPECT_EQ(lite.lights[i].color, glm::dvec3(1));
    }
    EXPECT_EQ(lite.camera.eye, glm::dvec3(0, 0, 35));
    EXPECT_EQ(lite.camera.target, glm::dvec3(0));
    EXPECT_DOUBLE_EQ(std::tan(glm::radians(lite.camera.fov) / 2), 1.0 / 3) << "a canvas of half height 1 at distance 3";
}

TEST(Lite, KeepsDisplayValuesAndShowsTheSky) {
    const Scene lite = shipped("lite");
    EXPECT_EQ(lite.encoding, Encoding::Display);
    EXPECT_EQ(lite.background.cubemap, "sky");
}

TEST(Lite, LetsTheLightsOutOfTheSunAndTheLamps) {
    for (const Object& object : shipped("lite").objects) {
        const bool lamp = object.name == "sun" || object.name == "lamp-2" || object.name == "lamp-3";
        EXPECT_EQ(object.castsShadow, !lamp) << object.name;
    }
}

TEST(Lite, HasTheColoursOfItsSource) {
    struct Row {
        std::string object;
        glm::dvec3 ambient, diffuse, specular;
        double shininess;
    };
    const Row rows[] = {
        {"green", {0, 0.2, 0}, {0, 0.4, 0}, glm::dvec3(0.8), 20},
        {"blue", {0, 0, 0.2}, {0, 0, 0.4}, glm::dvec3(0.8), 20},
        {"earth", glm::dvec3(0.5), glm::dvec3(0.5), glm::dvec3(0.5), 30},
        {"moon", glm::dvec3(0.5), glm::dvec3(0.5), glm::dvec3(0.5), 20},
        {"lamp-2", glm::dvec3(0.5), {0.8, 0.5, 0.8}, glm::dvec3(0.9), 20},
        {"lamp-3", glm::dvec3(0.5), {0.8, 0.5, 0.8}, glm::dvec3(0.9), 20},
        {"red", {0.2, 0, 0}, {0.5, 0, 0}, glm::dvec3(0.8), 66},
        {"gold", {0, 0, 0}, {0, 0, 0}, {0.628, 0.556, 0.366}, 51.2},
        {"glass", {0, 0, 0}, {0, 0, 0}, glm::dvec3(0.8), 70},
        {"mirror-1", {0, 0, 0}, glm::dvec3(0.01), glm::dvec3(0.8), 120},
        {"ground", {0.03, 0.034, 0.036}, {0.3, 0.34, 0.36}, glm::dvec3(0.8), 60},
    };
    const Scene lite = shipped("lite");
    for (const Row& row : rows) {
        const Material& material = materialOf(lite, row.object);
        EXPECT_EQ(material.ambient, row.ambient) << row.object;
        EXPECT_EQ(material.diffuse, row.diffuse) << row.object;
        EXPECT_EQ(material.specular, row.specular) << row.object;
        EXPECT_EQ(material.shininess, row.shininess) << row.object;
    }
}

TEST(Lite, ReflectsGoldAndSilverAsTheirComplexIndicesSay) {
    const Scene lite = shipped("lite");
    const glm::dvec3 gold = f0(std::get<Conductor>(materialOf(lite, "gold").optics));
    const glm::dvec3 silver = f0(std::get<Conductor>(materialOf(lite, "mirror-1").optics));
    const glm::dvec3 goldWanted(0.938, 0.846, 0.391), silverWanted(0.969, 0.904, 0.952);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(gold[i], goldWanted[i], 0.0005) << "channel " << i;
        EXPECT_NEAR(silver[i], silverWanted[i], 0.0005) << "channel " << i;
    }
}

TEST(Lite, BendsLightInTheGlassSphereOnly) {
    const Scene lite = shipped("lite");
    for (const Object& object : lite.objects) {
        const auto* glass = std::get_if<Dielectric>(&lite.materials[std::size_t(object.material)].optics);
        EXPECT_EQ(glass != nullptr, object.name == "glass") << object.name;
        if (!glass) continue;
        EXPECT_NEAR(f0(glass->ior), 0.04, 1e-12);
    }
}

TEST(Lite, MakesTheSunShineThroughItsTextureAndGlow) {
    const Scene lite = shipped("lite");
    const Material& sun = materialOf(lite, "sun");
    EXPECT_EQ(sun.emission, glm::dvec3(1, 0.95, 0.85));
    EXPECT_EQ(sun.ambient + sun.diffuse + sun.specular, glm::dvec3(0));
    EXPECT_EQ(sun.texture.value().scroll, glm::dvec2(0.2, 0.2));
    const Glow glow = objectOf(lite, "sun").glow.value();
    EXPECT_EQ(glow.color, glm::dvec3(1, 0.95, 0.1));
    EXPECT_EQ(glow.strength, 2);
    EXPECT_EQ(glow.softness, 0.5);
}

TEST(Lite, TurnsEarthAndMoonUnderTheirTextures) {
    const Scene lite = shipped("lite");
    const Material &earth = materialOf(lite, "earth"), &moon = materialOf(lite, "moon");
    EXPECT_EQ(earth.texture.value().scroll, glm::dvec2(0.5, 0));
    EXPECT_EQ(earth.normalMap.value().scroll, glm::dvec2(0.5, 0));
    EXPECT_NEAR(moon.texture.value().scroll.x, 1.0 / 7, 1e-12);
    EXPECT_NEAR(moon.normalMap.value().scroll.x, 1.0 / 7, 1e-12);
    EXPECT_EQ(std::get<Coat>(earth.optics).mask, "earth-water");
    EXPECT_EQ(materialOf(lite, "ground").texture.value().scale, glm::dvec2(0.15));
}

TEST(Lite, NamesEveryImageItNeedsOnce) {
    const std::vector<std::string> images = imagesOf(shipped("lite"));
    EXPECT_EQ(images, (std::vector<std::string>{"sky-px", "sky-nx", "sky-py", "sky-ny", "sky-pz", "sky-nz", "sun",
                                                "earth-color", "earth-normal", "earth-water", "moon-color",
                                                "moon-normal", "grid"}));
}

// ---- pro

TEST(Pro, BeginsWithAllOfLite) {
    const Scene lite = shipped("lite"), pro = shipped("pro");
    ASSERT_GE(pro.objects.size(), lite.objects.size());
    for (std::size_t i = 0; i < lite.objects.size(); ++i) {
        EXPECT_EQ(pro.objects[i].name, lite.objects[i].name);
        EXPECT_EQ(pro.objects[i].shape.values, lite.objects[i].shape.values) << lite.objects[i].name;
        EXPECT_EQ(pro.materials[std::size_t(pro.objects[i].material)].name,
                  lite.materials[std::size_t(lite.objects[i].material)].name);
    }
}

TEST(Pro, AddsAHundredSpheresACubeAndATorus) {
    EXPECT_EQ(countsOf(shipped("pro")), (std::map<ShapeKind, int>{{ShapeKind::Sphere, 110},
                                                                  {ShapeKind::Triangle, 2},
                                                                  {ShapeKind::Disc, 1},
                                                                  {ShapeKind::Torus, 1},
                                                                  {ShapeKind::Box, 1}}));
}

TEST(Pro, SetsItsMirrorSpheresInRowsOfTen) {
    const Scene pro = shipped("pro");
    std::size_t next = 13;
    for (int i = 10; i < 20; ++i)
        for (int j = 0; j < 10; ++j, ++next) {
            const Object& ball = pro.objects[next];
            EXPECT_EQ(pointOf(ball.shape, "center"), glm::dvec3(2 * i - 30, -7, 5 + 2 * j));
            EXPECT_EQ(lengthOf(ball.shape, "radius"), 0.8);
            const Material& material = pro.materials[std::size_t(ball.material)];
            EXPECT_NEAR(f0(std::get<Coat>(material.optics).ior), 0.04, 1e-12);
        }
}

TEST(Pro, HangsAGlassCubeThatCastsNoShadow) {
    const Scene pro = shipped("pro");
    const Object& cube = objectOf(pro, "cube");
    EXPECT_EQ(cube.shape.kind, ShapeKind::Box);
    EXPECT_EQ(pointOf(cube.shape, "center"), glm::dvec3(10, 0, 0));
    EXPECT_EQ(pointOf(cube.shape, "half_size"), glm::dvec3(2));
    EXPECT_EQ(std::get<Dielectric>(materialOf(pro, "cube").optics).ior, 1.5);
    EXPECT_FALSE(cube.castsShadow);
}

TEST(Pro, HidesATorusInTheCube) {
    const Scene pro = shipped("pro");
    const Shape& torus = objectOf(pro, "torus").shape;
    EXPECT_EQ(pointOf(torus, "center"), glm::dvec3(10, 0, 0));
    EXPECT_EQ(pointOf(torus, "axis"), glm::dvec3(0, 0, 1));
    EXPECT_EQ(lengthOf(torus, "major_radius"), 1);
    EXPECT_EQ(lengthOf(torus, "minor_radius"), 0.25);
    const Material& material = materialOf(pro, "torus");
    EXPECT_EQ(material.ambient, glm::dvec3(0, 0, 0.4));
    EXPECT_EQ(material.diffuse, glm::dvec3(0, 0, 0.4));
    EXPECT_EQ(material.specular, glm::dvec3(0.8));
    EXPECT_EQ(material.shininess, 30);
}

// ---- torus

TEST(TorusScene, StandsItsTorusOnTheGround) {
    const Scene scene = shipped("torus");
    const Shape& torus = objectOf(scene, "torus").shape;
    EXPECT_EQ(pointOf(torus, "center"), glm::dvec3(0));
    EXPECT_EQ(lengthOf(torus, "major_radius"), 1);
    EXPECT_EQ(lengthOf(torus, "minor_radius"), 0.25);
    EXPECT_NEAR(glm::length(pointOf(torus, "axis")), 1, 1e-15) << "directions are normalised on reading";
    EXPECT_EQ(pointOf(objectOf(scene, "ground").shape, "center").y, -1.25);
}

TEST(ShippedScenes, AllHaveATitleADescriptionAndTheNameOfTheirFile) {
    for (const char* name :
         {"lite", "pro", "torus", "shapes", "simple", "complex", "solids", "mandelbulb", "patches", "teapot",
          "goblet"}) {
        const Scene scene = shipped(name);
        EXPECT_EQ(scene.name, name);
        EXPECT_FALSE(scene.title.empty()) << name;
        EXPECT_FALSE(scene.description.empty()) << name;
    }
}

TEST(Schema, IsTheOneInTheSceneFolder) {
    EXPECT_EQ(textOf(kScenes + "scene.schema.json"), sceneSchema())
        << "write it anew: the text on the right is what assets/scenes/scene.schema.json must hold";
}

} // namespace
} // namespace gnomon
