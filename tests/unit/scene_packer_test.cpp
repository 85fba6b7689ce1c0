#include "tests/support/clouds.h"
#include "tests/support/scenes.h"
#include "tests/support/texel_walk.h"
#include "tracer/clock.h"
#include "tracer/plan/drawn.h"
#include "tracer/plan/scene_offsets.h"
#include "tracer/plan/scene_packer.h"
#include "tracer/plan/shape_texels.h"
#include "tracer/shader/scene_constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <random>
#include <string>

namespace gnomon {
namespace {

using test::moved;
using test::sceneFrom;
using test::sceneNamed;

/// What one picture takes, relative to `origin`.
std::vector<glm::vec4> packed(const Scene& scene, const Plan& plan, double time, glm::dvec3 origin) {
    ScenePacker packer(prepare(scene), origin);
    const auto texels = packer.pack(plan, time, scene.camera.eye);
    return {texels.begin(), texels.end()};
}

std::map<std::string, int> constants(const SceneFeatures& features) {
    std::map<std::string, int> map;
    for (const auto& [name, value] : constantsOf(features)) map[name] = value;
    return map;
}

/// In the names of its constants.
std::string nameOf(const KindCount& kind) { return "k" + kind.type(); }

class SceneData : public testing::TestWithParam<const char*> {
  protected:
    Scene scene = sceneNamed(GetParam());
    PreparedScenePtr prepared = prepare(scene);
    Plan plan = planOf(*prepared, {}, {.blockTexels = 1 << 20});
    std::map<std::string, int> at = constants(plan.scene);
    std::vector<glm::vec4> texels = packScene(prepared, plan, 0);
};

TEST_P(SceneData, IsAsLongAsItsConstantsSay) {
    EXPECT_EQ(int(texels.size()), at["kSceneTexels"]);
    EXPECT_EQ(int(texels.size()), sceneTexels(plan.scene));
}

TEST_P(SceneData, NamesEveryObjectOnceByItsPlaceInTheFile) {
    std::vector<int> seen(scene.objects.size(), 0);
    for (int i = 0; i < at["kObjectCount"]; ++i) ++seen.at(std::size_t(texels[at["kObjectBase"] + i].y));
    for (int count : seen) EXPECT_EQ(count, 1);
}

TEST_P(SceneData, PutsCastersFirstInTheirKind) {
    for (const KindCount& kind : plan.scene.shapes) {
        const std::string name = nameOf(kind);
        for (int i = 0; i < kind.count; ++i) {
            const int index = int(texels[at["kObjectBase"] + at[name + "First"] + i].y);
            EXPECT_EQ(scene.objects[index].castsShadow, i < kind.casters) << name << i;
            EXPECT_EQ(scene.objects[index].shape.kind, kind.kind);
        }
    }
}

TEST_P(SceneData, PacksEveryShapeWhereItsConstantsSay) {
    const auto shapes = shapesAt(scene, 0);
    for (const KindCount& kind : plan.scene.shapes) {
        const std::string name = nameOf(kind);
        for (int i = 0; i < kind.count; ++i) {
            const int index = int(texels[at["kObjectBase"] + at[name + "First"] + i].y);
            const int own = kind.solid ? 1 : at[name + "Texels"]; // what a solid is made of: tests/unit/solid_test.cpp
            for (int k = 0; k < own; ++k) {
                const glm::vec4 packed = texels[at[name + "Base"] + i * at[name + "Texels"] + k];
                const glm::vec4 told(packedShape(shapes[index])[k]);
                EXPECT_EQ(glm::vec3(packed), glm::vec3(told));
                if (kind.kind != ShapeKind::Triangle) {
                    EXPECT_EQ(packed.w, told.w); // else the middle of all
                }
            }
        }
    }
}

// A scene relative to where it was moved to has the numbers it has at home, but for what its doubles lose on the way.
TEST_P(SceneData, IsTheSameAboutItsOwnOriginWhereverItIs) {
    const glm::dvec3 by(0x1p17, -0x1p18, 0x1p19);
    const Scene there = moved(scene, by);
    for (const double time : {0.0, 3.7}) {
        const auto here = packed(scene, plan, time, glm::dvec3(0)), far = packed(there, plan, time, by);
        ASSERT_EQ(far.size(), here.size());
        for (std::size_t i = 0; i < here.size(); ++i)
            for (int c = 0; c < 4; ++c)
                ASSERT_NEAR(far[i][c], here[i][c], 0x1p-23 * std::abs(here[i][c]) + 0x1p-32) << i << ' ' << c;
    }
}

TEST_P(SceneData, IsInTheWorldsCoordinatesAtHome) {
    const glm::dvec3 origin = originOf(scene);
    EXPECT_EQ(origin, glm::dvec3(0));
    for (int c = 0; c < 3; ++c) EXPECT_FALSE(std::signbit(origin[c]));
    EXPECT_EQ(packed(scene, plan, 0, origin), texels);
}

/// The boxes of one kind's objects as the shader numbers them.
std::vector<Bounds> boundsInOrder(const std::vector<Shape>& shapes, const std::vector<glm::vec4>& texels,
                                  std::map<std::string, int>& at, const KindCount& kind) {
    std::vector<Bounds> bounds;
    for (int i = 0; i < kind.count; ++i)
        bounds.push_back(*boundsOf(shapes[std::size_t(texels[at["kObjectBase"] + at[nameOf(kind) + "First"] + i].y)]));
    return bounds;
}

// For each kind that has one, also after a while: the tree that was built first, about where things are now.
TEST_P(SceneData, HoldsTheHierarchiesOfItsKinds) {
    Settings settings;
    settings.accel = Accel::Hierarchy;
    plan = planOf(*prepared, settings, {.blockTexels = 1 << 20});
    at = constants(plan.scene);
    ScenePacker packer(prepared, glm::dvec3(0));
    std::map<ShapeKind, Hierarchy> trees;
    for (const double time : {0.0, 0.1, 3.7}) {
        const auto span = packer.pack(plan, time, scene.camera.eye);
        const std::vector<glm::vec4> now(span.begin(), span.end());
        ASSERT_EQ(int(now.size()), at["kSceneTexels"]);
        for (const KindCount& kind : plan.scene.shapes) {
            if (kind.search != Search::Hierarchy) continue;
            Hierarchy& tree = trees[kind.kind];
            update(tree, boundsInOrder(shapesAt(scene, time), now, at, kind));
            const auto wanted = test::texelsOf(tree, scene.camera.eye);
            const auto first = now.begin() + at[nameOf(kind) + "Quantisation"];
            EXPECT_EQ(std::vector(first, first + std::ptrdiff_t(wanted.size())), wanted) << nameOf(kind);
            EXPECT_EQ(at[nameOf(kind) + "Nodes"], 2 * kind.count - 1);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneData,
                         testing::Values("lite", "pro", "torus", "shapes", "complex", "solids", "mandelbulb"));

TEST(SceneData, TellsEveryTriangleTheMiddleOfAll) {
    const Scene scene = test::sceneFrom(R"({"objects": [{"triangle": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 2, 0]]}},
        {"sphere": {"center": [90, 90, 90], "radius": 1}},
            {"triangle": {"vertices": [[5, 0, -8], [6, 0, 0], [5, 2, 0]]}}]})");
    const PreparedScenePtr prepared = prepare(scene);
    const Plan plan = planOf(*prepared, {}, {});
    const auto texels = packScene(prepared, plan, 0);
    const int base = constants(plan.scene)["kTriangleBase"];
    for (const int triangle : {0, 1})
        for (int i = 0; i < 3; ++i) EXPECT_EQ(texels[base + 3 * triangle + i].w, glm::vec3(3, 1, -4)[i]);
}

TEST(SceneDataOfLite, GivesGoldTheReflectanceOfTheSource) {
    const Scene scene = sceneNamed("lite");
    const PreparedScenePtr prepared = prepare(scene);
    const Plan plan = planOf(*prepared, {}, {});
    const auto texels = packScene(prepared, plan, 0);
    int gold = -1;
    for (const Object& object : scene.objects)
        if (object.name == "gold") gold = object.material;
    ASSERT_GE(gold, 0);
    const glm::vec4 f0 = texels[constants(plan.scene)["kMaterialBase"] + gold * kMaterialTexels + 3];
    EXPECT_NEAR(f0.r, 0.938, 5e-4);
    EXPECT_NEAR(f0.g, 0.846, 5e-4);
    EXPECT_NEAR(f0.b, 0.391, 5e-4);
}

TEST(SceneDataOfLite, ReducesTextureMotionToOnePeriodAlsoAfterADay) {
    const Scene scene = sceneNamed("lite");
    const PreparedScenePtr prepared = prepare(scene);
    const Plan plan = planOf(*prepared, {}, {});
    const double day = 86400.25;
    const auto texels = packScene(prepared, plan, day);
    const int first = constants(plan.scene)["kMaterialBase"];
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const auto& use = scene.materials[m].texture;
        if (!use) continue;
        const glm::vec4 placement = texels[first + int(m) * kMaterialTexels + 4];
        const double exact = use->scroll.x * day - std::floor(use->scroll.x * day);
        EXPECT_NEAR(placement.z, exact, 1e-6) << scene.materials[m].name;
    }
}

double largest(glm::dvec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

const char* const kBall = R"({"sphere": {"center": [0, 0, 0], "radius": 1}})";
const char* const kGround = R"({"sphere": {"center": [0, -10001, 0], "radius": 10000}})";
const char* const kFloor = R"({"plane": {"point": [0, -1, 0], "normal": [0, 1, 0]}})";

/// Of these objects, seen from (0, 1, 5).
Scene with(const std::string& objects) {
    return sceneFrom(R"({"camera": {"eye": [0, 1, 5], "target": [0, 0, 0]}, "objects": [)" + objects + "]}");
}
std::string list(std::initializer_list<const char*> objects) {
    std::string text;
    for (const char* object : objects) text += (text.empty() ? "" : ", ") + std::string(object);
    return text;
}

// A ground that is a large sphere or a plane says nothing of where the scene is, nor does the number of objects.
TEST(Origin, IsNearTheSceneWhereverItIs) {
    for (const glm::dvec3 by : {glm::dvec3(1e5, -1e5, 1e5), glm::dvec3(1e6, 0, 0), glm::dvec3(-123456.7, 89012.3, 1)})
        for (const std::string& objects :
             {std::string(kBall), list({kBall, kFloor}), list({kBall, kGround}), list({kFloor}), list({kGround}),
              list({kBall, kBall, kBall, R"({"box": {"center": [4, 1, 0], "half_size": [1, 2, 1]}})"}),
              list({R"({"triangle": {"vertices": [[0, 0, 0], [3, 0, 0], [0, 3, 0]]}})"})}) {
            const glm::dvec3 origin = originOf(moved(with(objects), by));
            EXPECT_LE(largest(by - origin), 64) << objects;
            EXPECT_EQ(glm::fract(origin / 8.0), glm::dvec3(0)) << objects;
            EXPECT_EQ(originOf(with(objects)), glm::dvec3(0)) << objects;
        }
}

TEST(Origin, IsTheWorldsWithoutAnyObject) { EXPECT_EQ(originOf(Scene{}), glm::dvec3(0)); }

TEST(Origin, IsFineForTheSmall) {
    const double size = 1e-4;
    Scene scene = with(R"({"sphere": {"center": [0, 0, 0], "radius": 0.0001}})");
    scene.camera.eye *= size;
    const glm::dvec3 by(100, -70, 3);
    EXPECT_LE(largest(by - originOf(moved(scene, by))), 16 * size);
}

// What moves does not leave the origin behind: its whole way is part of the scene.
TEST(Origin, IsTheWorldsWhereThingsMoveAsFarAsTheyAreAway) {
    Scene scene = moved(with(list({kBall, kBall})), {1e5, 0, 0});
    EXPECT_NE(originOf(scene), glm::dvec3(0));
    scene.objects[1].motion = Orbit{{0, 6e4, 0}, {6e4, 0, 0}, 1, -1};
    EXPECT_EQ(originOf(scene), glm::dvec3(0));
}

TEST(Origin, KnowsThatAMoonRestsRelativeToItsPlanet) {
    Scene scene = with(list({kBall, kBall, kBall}));
    scene.objects[0].motion = Orbit{{2, 0, 0}, {0, 2, 0}, 1, 1};
    scene.objects[1].motion = Orbit{{0, 0, 3}, {0, 3, 0}, 1, 2};
    const glm::dvec3 by(1e5, 2e5, 3e5);
    EXPECT_LE(largest(by - originOf(moved(scene, by))), 128);
}

// One thing far away from where the picture is taken, as a sun: what is near the camera stays as it is.
TEST(Origin, DoesNotFollowOneFarThing) {
    for (const double far : {1e3, 65536.0, 9e5}) {
        Scene scene = with(list({kFloor, R"({"sphere": {"center": [0, 0, 0], "radius": 50}})"}));
        scene.objects[1].shape = translated(scene.objects[1].shape, {far, 0, 0});
        EXPECT_EQ(originOf(scene), glm::dvec3(0)) << far;
    }
}

// Neither the objects nor the eye get larger coordinates than in the world, in any scene.
TEST(Origin, MakesNoCoordinateLarger) {
    std::mt19937 random(1);
    const auto number = [&] { return random() / 4294967296.0 * 2 - 1; };
    const auto vector = [&] { return std::pow(10, 3 + 3 * number()) * glm::dvec3(number(), number(), number()); };
    int away = 0;
    for (int i = 0; i < 20000; ++i) {
        Scene scene = with(list({kBall, kBall, kFloor}));
        const glm::dvec3 about = vector();
        for (Object& object : scene.objects) object.shape = translated(object.shape, about + 0.01 * vector());
        scene.camera.eye = about + 0.01 * vector();
        const glm::dvec3 origin = originOf(scene);
        away += origin != glm::dvec3(0);
        const auto fits = [&](glm::dvec3 p) { return glm::all(glm::lessThanEqual(glm::abs(p - origin), glm::abs(p))); };
        ASSERT_TRUE(fits(scene.camera.eye) || origin == glm::dvec3(0));
        const glm::dvec3 a = pointOf(scene.objects[0].shape, "center"), b = pointOf(scene.objects[1].shape, "center");
        for (int c = 0; c < 3; ++c)
            ASSERT_LE(std::max(std::abs(a[c] - origin[c]), std::abs(b[c] - origin[c])),
                      std::max(std::abs(a[c]), std::abs(b[c])));
    }
    EXPECT_GT(away, 5000);
}

// ---- Packing again and again

/// Milliseconds, the median of many.
double medianTime(int times, const std::function<void()>& work) {
    std::vector<double> took;
    for (int i = 0; i < times; ++i) {
        const double start = processSeconds();
        work();
        took.push_back(1e3 * (processSeconds() - start));
    }
    std::nth_element(took.begin(), took.begin() + times / 2, took.end());
    return took[std::size_t(times / 2)];
}

/// A cube of spheres, each on an orbit of its own.
Scene allMoving(int count) {
    Scene scene = with(kBall);
    const Object first = scene.objects[0];
    scene.objects.clear();
    test::Dice dice(13);
    for (const Shape& ball : test::inACube(count, 1)) {
        scene.objects.push_back(first);
        scene.objects.back().shape = ball;
        scene.objects.back().motion = Orbit{dice.point(0.02), dice.point(0.02), dice.number(-1, 1), -1};
    }
    return scene;
}

// One core's time of a frame: where everything is, its boxes, the tree about them or the grid, and all texels.
TEST(ScenePacker, Packs10000MovingSpheresIn4Milliseconds) {
    const Scene scene = allMoving(10000);
    Settings tree;
    tree.accel = Accel::Hierarchy;
    const PreparedScenePtr prepared = prepare(scene);
    const Plan plan = planOf(*prepared, tree, {}), gridded = planOf(*prepared, {}, {});
    ASSERT_EQ(plan.scene.shapes[0].search, Search::Hierarchy);
    ASSERT_EQ(gridded.scene.shapes[0].search, Search::Grid);
    ScenePacker packer(prepared, glm::dvec3(0)), otherPacker(prepared, glm::dvec3(0));
    double time = 0;
    const double packing = medianTime(101, [&] { packer.pack(plan, time += 0.01, scene.camera.eye); });
    const double packingCells = medianTime(101, [&] { otherPacker.pack(gridded, time += 0.01, scene.camera.eye); });

    std::vector<Shape> shapes;
    std::vector<Bounds> bounds(scene.objects.size());
    std::vector<glm::vec4> texels;
    const double placing = medianTime(101, [&] { shapes = shapesAt(scene, time += 0.01); });
    const double boxing = medianTime(101, [&] {
        for (std::size_t i = 0; i < shapes.size(); ++i) bounds[i] = *boundsOf(shapes[i]);
    });
    Hierarchy hierarchy;
    const double building = medianTime(11, [&] { hierarchy = build(bounds); });
    const double refitting = medianTime(101, [&] { refit(hierarchy, bounds); });
    const double judging = medianTime(101, [&] { EXPECT_LT(hierarchy.spoilt(), 1.5); });
    const double writing = medianTime(101, [&] {
        texels.clear();
        appendTexels(hierarchy, scene.camera.eye, texels);
    });
    std::printf(
        "10 000 moving spheres, ms: %.2f; of it shapes %.2f, boxes %.2f, refit %.2f, cost %.2f, nodes %.2f; a new "
        "tree would take %.1f; with cells %.2f\n",
        packing, placing, boxing, refitting, judging, writing, building, packingCells);
#ifndef GNOMON_SANITIZED
    EXPECT_LE(packing, 4);
    EXPECT_LE(packingCells, 4);
#endif
}

} // namespace
} // namespace gnomon
