/// Searches change how fast a picture comes, and nothing else: with hierarchies, bounding-sphere masks, lattices and
/// grids and without them every float of it is the same.
///
/// Not so by luck: a walk loses no hit that a shape's own rounding may find (shaders/accel/hierarchy.glsl), and of
/// objects at one distance both ways meet the one with the lowest number.

#include "lab/reference/exact/fan.h"
#include "tests/support/clouds.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/plan/drawn.h"
#include "tracer/plan/plan.h"
#include "tracer/plan/shape_texels.h"
#include "tracer/software/tuning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace gnomon {
namespace {

using namespace test;

/// Where a picture is taken from, and when.
struct Shot {
    glm::dvec3 eye, target;
    double time = 0;
    double fov = 40;
};

Settings sized(Accel accel, Aov aov, int depth, Settings settings = {}) {
    settings.size = {161, 121}; // odd: the middle column and row look straight ahead
    settings.accel = accel;
    settings.aov = aov;
    settings.depth = depth;
    return settings;
}

void aim(Drawing& drawing, const Shot& shot) {
    drawing.view.camera.eye = shot.eye;
    drawing.view.camera.target = shot.target;
    drawing.view.camera.fov = shot.fov;
    drawing.view.time = shot.time;
}

bool searches(const Scene& scene, Accel accel) {
    for (const KindCount& kind : planOf(*prepare(scene), sized(accel, Aov::Color, 1), {}).scene.shapes)
        if (kind.search != Search::Loop || kind.latticeMembers() > 0) return true;
    return false;
}

/// Pictures of `aov` with and without a search are the same. Says how many different values the pictures have.
int alike(const Scene& scene, const std::vector<Shot>& shots, Aov aov, int depth, const Settings& others = {}) {
    EXPECT_TRUE(searches(scene, Accel::Hierarchy));
    EXPECT_FALSE(searches(scene, Accel::None));
    offscreen();
    Drawing plain(scene, sized(Accel::None, aov, depth, others)),
        boxes(scene, sized(Accel::Hierarchy, aov, depth, others)),
        chosen(scene, sized(Accel::Auto, aov, depth, others));
    std::set<float> values;
    for (std::size_t i = 0; i < shots.size(); ++i) {
        aim(plain, shots[i]);
        const FloatImage wanted = plain.output();
        for (Drawing* fast : {&boxes, &chosen}) {
            aim(*fast, shots[i]);
            EXPECT_EQ(difference(wanted, fast->output()), "") << (fast == &boxes ? "hierarchy" : "auto") << ", output "
                                                              << int(aov) << ", depth " << depth << ", shot " << i;
        }
        values.insert(wanted.pixels.begin(), wanted.pixels.end());
    }
    return int(values.size());
}

/// In all outputs; at least so many objects are to be seen.
void expectAlike(const Scene& scene, const std::vector<Shot>& shots, int objects) {
    EXPECT_GE(alike(scene, shots, Aov::Object, 1), objects);
    EXPECT_GT(alike(scene, shots, Aov::Distance, 1), 100);
    EXPECT_GT(alike(scene, shots, Aov::Color, 4), 100);
}

// ---- The scenes that come with the program

struct Known {
    const char* name;
    std::vector<Shot> shots;
    bool twice = false; ///< has one object of each kind, as good as no hierarchy: all things stand there once more
};
std::ostream& operator<<(std::ostream& out, const Known& known) { return out << known.name; }

/// Every object once more, to the side.
Scene twice(Scene scene) {
    const std::vector<Object> objects = scene.objects;
    for (Object object : objects) {
        if (!object.motion) object.shape = translated(object.shape, {0.9, 0.01, -1.7});
        scene.objects.push_back(object);
    }
    return scene;
}

class PicturesOf : public testing::TestWithParam<Known> {};

TEST_P(PicturesOf, AreTheSameWithASearch) {
    Scene scene = sceneNamed(GetParam().name);
    if (GetParam().twice) scene = twice(scene);
    expectAlike(scene, GetParam().shots, 4);
    alike(scene, GetParam().shots, Aov::Color, 8);
    alike(scene, GetParam().shots, Aov::Visibility, 1);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, PicturesOf,
    testing::Values(
        Known{"lite", {{{0, 0, 35}, {0, 0, 0}}, {{12, 4, 20}, {0, -1, 0}, 3.7}, {{0, 0, 3000}, {0, 0, 0}, 0, 1}}},
        Known{"pro", {{{0, 0, 35}, {0, 0, 0}}, {{14, 2, 8}, {9, -1, 0}, 1.5}, {{3, -1.9, 2}, {9, -1, 0}, 88, 90}}},
        Known{"shapes", {{{0.4, 2.5, 7.2}, {0, 0.6, 0}}, {{-3, 0.2, -2}, {0, 0.6, 0}, 2, 80}}, true},
        Known{"torus", {{{0, 1.6, 5}, {0, -0.15, 0}}, {{0.3, 0.2, 400}, {0, 0, 0}, 0, 1}}, true}),
    [](const auto& test) { return test.param.name; });

// ---- Blocks

/// A lattice of equal objects about the origin, a step of 1 apart, each written by `objectAt`, and a few loose ones.
Scene latticeScene(glm::ivec3 cells, const std::function<std::string(glm::dvec3)>& objectAt) {
    std::string objects = R"({"sphere": {"center": [0.3, 3, 0.2], "radius": 0.4}, "material": "glass"},
                             {"sphere": {"center": [-3, 0.5, 3], "radius": 0.6}, "material": "mirror"},
                             {"plane": {"point": [0, -4, 0], "normal": [0, 1, 0]}, "material": "dull"})";
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x)
                objects += ", " + objectAt(glm::dvec3(x, y, z) - 0.5 * glm::dvec3(cells - 1));
    return sceneFrom(R"({"lights": [{"point": {"position": [3, 6, 5]}}, {"point": {"position": [0.5, 0.5, 0.5]}}],
        "materials": {"dull": {"diffuse": [0.7, 0.45, 0.2], "specular": 0.5},
                      "mirror": {"diffuse": 0.1, "conductor": {"n": [0.2, 0.4, 1.3], "k": [3.9, 2.4, 1.8]}},
                      "glass": {"specular": 0.4, "dielectric": {"ior": 1.5}}}, "objects": [)" +
                     objects + "]}");
}

std::string textOf(glm::dvec3 v) {
    return "[" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + "]";
}

/// From outside, along the lattice, from within, from far away, and grazing its faces.
std::vector<Shot> shotsOfLattice() {
    return {{{6, 4, 7}, {0, 0, 0}},
            {{0, 0, 9}, {0, 0, 0}},
            {{0.5, 0.5, 0.5}, {3, 2, 1}, 0, 90},
            {{400, 300, 500}, {0, 0, 0}, 0, 1},
            {{9, 0.499, 0.2}, {0, 0.499, 0}},
            {{-5, 2.001, 2.2}, {5, 2, -1.9}, 0, 20}};
}

int latticeOf(const Scene& scene) {
    int members = 0;
    for (const KindCount& kind : planOf(*prepare(scene), {}, {}).scene.shapes) members += kind.latticeMembers();
    return members;
}

TEST(Lattice, OfSpheresLooksTheSameWalkedCellByCell) {
    const Scene scene = latticeScene({6, 4, 5}, [](glm::dvec3 at) {
        return R"({"sphere": {"center": )" + textOf(at) + R"(, "radius": 0.47}, "material": "mirror"})";
    });
    EXPECT_EQ(latticeOf(scene), 120);
    expectAlike(scene, shotsOfLattice(), 60);
    expectAlike(moved(scene, {1000.5, -2000.25, 4000}), {{{1006.5, -1996.25, 4007}, {1000.5, -2000.25, 4000}}}, 30);
}

TEST(Lattice, OfBoxesInOneLayerLooksTheSameWalkedCellByCell) {
    const Scene scene = latticeScene({9, 1, 9}, [](glm::dvec3 at) {
        return R"({"box": {"center": )" + textOf(at) + R"(, "half_size": [0.48, 0.1, 0.3]}, "material": "glass"})";
    });
    EXPECT_EQ(latticeOf(scene), 81);
    expectAlike(scene, shotsOfLattice(), 40);
}

// ---- Clouds

constexpr const char* kStudio = R"({"background": {"color": [0.25, 0.35, 0.5]},
    "lights": [{"point": {"position": [3, 4, 5]}}, {"point": {"position": [-4, 1.5, 2]}, "color": [0.3, 0.3, 0.4]}],
    "materials": {
        "dull": {"ambient": 0.1, "diffuse": [0.7, 0.45, 0.2], "specular": 0.5, "shininess": 40},
        "mirror": {"ambient": 0, "diffuse": 0.1, "specular": 0.4, "shininess": 60,
                   "conductor": {"n": [0.2, 0.4, 1.3], "k": [3.9, 2.4, 1.8]}},
        "glass": {"ambient": 0, "diffuse": 0, "specular": 0.4, "shininess": 60, "dielectric": {"ior": 1.5}}},
    "objects": [{"sphere": {"center": [0, 0, 0], "radius": 0.01}, "material": "dull"},
                {"sphere": {"center": [0, 0, 0], "radius": 0.01}, "material": "mirror"},
                {"sphere": {"center": [0, 0, 0], "radius": 0.01}, "material": "glass"}]})";

/// These shapes in the studio, dull, mirroring and of glass in turn; every seventh throws no shadow.
Scene studio(const std::vector<Shape>& shapes) {
    Scene scene = sceneFrom(kStudio);
    const std::vector<Object> first = scene.objects;
    scene.objects.clear();
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        scene.objects.push_back(first[i % first.size()]);
        scene.objects.back().shape = shapes[i];
        scene.objects.back().castsShadow = i % 7 != 3;
    }
    return scene;
}

/// From outside, from among them, and through long lenses from far away.
const std::vector<Shot> kAround{
    {{0.3, 0.8, 3.2}, {0, 0, 0}},          {{0.1, 0.2, 0.3}, {-1, 0.1, 0.2}, 0, 90}, {{0, 0, 4}, {0, 0, 0}},
    {{300, 700, 1500}, {0, 0, 0}, 0, 0.1}, {{2e5, 3e5, 8e5}, {0, 0, 0}, 0, 2e-4},    {{0, 0, 8e5}, {0, 0, 0}, 0, 2e-4}};

TEST(Hierarchies, LeaveCloudsOfSpheresAsTheyAre) {
    // No more: llvmpipe ends the loops of a pixel after 65 535 iterations in all, asking each object counts as one.
    for (const int count : {300, 1000}) expectAlike(studio(inACube(count, 1)), kAround, 100);
    expectAlike(studio(clustered(1000)), kAround, 50);
    expectAlike(studio(onTheGround(500)), kAround, 50);
}

glm::dvec3 unit(Dice& dice) { return glm::normalize(dice.point(1) + glm::dvec3(1e-6)); }

/// One of any bounded kind, of about that size.
Shape anyShape(Dice& dice, ShapeKind kind, double size) {
    const glm::dvec3 at = dice.point(1), along = at + size * unit(dice);
    const double radius = size * dice.number(0.2, 0.7);
    switch (kind) {
    case ShapeKind::Disc: return makeShape(kind, {at, unit(dice)}, {radius});
    case ShapeKind::Triangle: return makeShape(kind, {at, along, at + size * unit(dice)});
    case ShapeKind::Torus: return makeShape(kind, {at, unit(dice)}, {radius, 0.3 * radius});
    case ShapeKind::Box: return makeShape(kind, {at, size * glm::abs(dice.point(0.5)) + 0.01 * size});
    case ShapeKind::Cylinder:
    case ShapeKind::Capsule:
    case ShapeKind::Cone: return makeShape(kind, {at, along}, {radius});
    default: return sphere(at, radius);
    }
}

class CloudOf : public testing::TestWithParam<ShapeKind> {};

TEST_P(CloudOf, IsTheSameWithHierarchies) {
    Dice dice(20);
    std::vector<Shape> shapes;
    for (int i = 0; i < 120; ++i) shapes.push_back(anyShape(dice, GetParam(), 0.3));
    expectAlike(studio(shapes), kAround, 50);
}

INSTANTIATE_TEST_SUITE_P(Kinds, CloudOf,
                         testing::Values(ShapeKind::Disc, ShapeKind::Triangle, ShapeKind::Torus, ShapeKind::Box,
                                         ShapeKind::Cylinder, ShapeKind::Capsule, ShapeKind::Cone),
                         [](const auto& test) { return glslTypeOf(test.param); });

// Several kinds that each have a hierarchy, and one of each kind that has none beside them.
TEST(Hierarchies, LeaveAMixedCloudAsItIs) {
    Dice dice(21);
    std::vector<Shape> shapes;
    for (int i = 0; i < 140; ++i) {
        const ShapeKind kinds[]{ShapeKind::Sphere, ShapeKind::Disc,    ShapeKind::Triangle, ShapeKind::Torus,
                                ShapeKind::Box,    ShapeKind::Capsule, ShapeKind::Cone};
        shapes.push_back(anyShape(dice, kinds[i % 7], 0.3));
    }
    shapes.push_back(anyShape(dice, ShapeKind::Cylinder, 0.3));
    shapes.push_back(makeShape(ShapeKind::Plane, {{0, -1.2, 0}, {0, 1, 0}}));
    expectAlike(studio(shapes), kAround, 80);
}

// ---- Grids, for what lies evenly scattered

bool hasCells(const Scene& scene) {
    const Settings settings = sized(Accel::Auto, Aov::Color, 1);
    return planOf(*prepare(scene), settings, tunedFor(Rasteriser::Llvmpipe)).scene.shapes[0].search == Search::Grid;
}

TEST(Cells, LeaveACloudThatMovesAsItIs) {
    Scene scene = studio(inACube(400, 1));
    Dice dice(24);
    for (std::size_t i = 0; i < scene.objects.size(); i += 2)
        scene.objects[i].motion = Orbit{glm::dvec3(0), dice.point(0.7), dice.number(1, 3), -1};
    EXPECT_TRUE(hasCells(scene));
    std::vector<Shot> shots = kAround;
    for (Shot shot : kAround) {
        shot.time = 2.5;
        shots.push_back(shot);
    }
    expectAlike(scene, shots, 100);
    expectAlike(moved(scene, {1000.5, -2000.25, 4000}), {{{1000.8, -1999.45, 4003.2}, {1000.5, -2000.25, 4000}}}, 100);
}

TEST(Cells, LeaveLargeAndSmallObjectsAsTheyAre) {
    std::vector<Shape> shapes = inACube(600, 0.6);
    for (std::size_t i = 0; i < 6; ++i)
        setLength(shapes[100 * i], "radius", 6 * lengthOf(shapes[100 * i], "radius")); // in many cells
    EXPECT_TRUE(hasCells(studio(shapes)));
    expectAlike(studio(shapes), kAround, 100);
}

// ---- Shadow cones, which ask for the distance of whatever is nearest

/// Of lights as large as that; so few steps that llvmpipe, which ends all loops of a pixel after 65 536 turns, asks all
/// objects in each of them.
void expectShadowsAlike(const Scene& scene, ShadowModel model, int values) {
    Settings settings;
    settings.shadows = model;
    settings.lightRadius = 0.4;
    settings.shadowSteps = 100;
    const std::vector<Shot> shots{{{2, 3, 4}, {0, 0, 0}}, {{0.1, 0.2, 0.3}, {-1, 0.1, 0.2}, 0, 90}};
    EXPECT_GT(alike(scene, shots, Aov::Visibility, 1, settings), values);
}

TEST(Distances, OfALatticeAreTheSameFromTheNearestCell) {
    const Scene scene = latticeScene({6, 4, 5}, [](glm::dvec3 at) {
        return R"({"sphere": {"center": )" + textOf(at) + R"(, "radius": 0.43}, "material": "dull"})";
    });
    EXPECT_EQ(latticeOf(scene), 120);
    for (const ShadowModel model : {ShadowModel::ConeLinear, ShadowModel::Quilez})
        expectShadowsAlike(scene, model, 900);
}

Scene overGround(std::vector<Shape> shapes) {
    shapes.push_back(makeShape(ShapeKind::Plane, {{0, -1.2, 0}, {0, 1, 0}}));
    return studio(shapes);
}

TEST(Distances, OfACloudAreTheSameFromAHierarchy) {
    const Scene scene = overGround(inACube(300, 0.2));
    for (const ShadowModel model :
         {ShadowModel::ConeLinear, ShadowModel::ConeBase, ShadowModel::Quilez, ShadowModel::Aaltonen})
        expectShadowsAlike(scene, model, 900);
    expectShadowsAlike(overGround(clustered(300)), ShadowModel::ConeLinear, 900);
}

TEST_P(CloudOf, ThrowsTheSameShadowsWithHierarchies) {
    Dice dice(23);
    std::vector<Shape> shapes;
    for (int i = 0; i < 80; ++i) shapes.push_back(anyShape(dice, GetParam(), 0.2));
    expectShadowsAlike(overGround(shapes), ShadowModel::ConeLinear, 900);
}

// Unions take the casters in whatever order they are found, which is within what they are off by themselves.
TEST(Silhouettes, OfACloudAreAlmostTheSameFromAHierarchy) {
    Settings settings;
    settings.shadows = ShadowModel::Silhouette;
    settings.lightRadius = 0.4;
    const Scene scene = overGround(inACube(300, 0.2));
    offscreen();
    Drawing plain(scene, sized(Accel::None, Aov::Visibility, 1, settings)),
        boxes(scene, sized(Accel::Hierarchy, Aov::Visibility, 1, settings));
    int several = 0;
    for (const Shot& shot : {Shot{{2, 3, 4}, {0, 0, 0}}, Shot{{0.1, 0.2, 0.3}, {-1, 0.1, 0.2}, 0, 90}}) {
        aim(plain, shot);
        aim(boxes, shot);
        const FloatImage wanted = plain.output(), got = boxes.output();
        double most = 0, squares = 0;
        for (std::size_t i = 0; i < wanted.pixels.size(); ++i) {
            const double off = std::abs(wanted.pixels[i] - got.pixels[i]);
            most = std::max(most, off);
            squares += off * off;
            several += off > 0;
        }
        EXPECT_LT(most, 0.02);
        EXPECT_LT(std::sqrt(squares / double(wanted.pixels.size())), 0.001);
    }
    EXPECT_GT(several, 100) << "somewhere several casters overlap";
}

// ---- Edges that triangles share, where rays meet both at one distance

TEST(Hierarchies, LeaveAFanOfTrianglesAsItIs) {
    const oracle::Fan fan({0, 0, 0});
    const auto middle = vertexOf(fan.triangles()[0], 0);
    const Scene scene = studio(fan.triangles());
    expectAlike(scene, {{{0.3, 0.8, 3.2}, {0, 0, 0}}, {{0, 0, 40}, middle, 0, 1}, {{0.01, 3, 0.02}, {0, 0, 0}}}, 6);
}

/// A level grid of triangles, two a square; `heights` above y = 0 at most.
std::vector<Shape> grid(int side, glm::dvec3 corner, double size, double heights) {
    Dice dice(22);
    std::vector<glm::dvec3> points;
    for (int z = 0; z <= side; ++z)
        for (int x = 0; x <= side; ++x)
            points.push_back(corner + size * glm::dvec3(x, 0, z) / double(side) +
                             glm::dvec3(0, dice.number(0, heights), 0));
    const auto at = [&](int x, int z) { return points[std::size_t(z * (side + 1) + x)]; };
    std::vector<Shape> shapes;
    for (int z = 0; z < side; ++z)
        for (int x = 0; x < side; ++x) {
            shapes.push_back(makeShape(ShapeKind::Triangle, {at(x, z), at(x, z + 1), at(x + 1, z)}));
            shapes.push_back(makeShape(ShapeKind::Triangle, {at(x + 1, z), at(x, z + 1), at(x + 1, z + 1)}));
        }
    return shapes;
}

/// The middle column looks along edges; the last two see the whole way to the horizon.
const std::vector<Shot> kOverGrid{{{0, 3, 0.001}, {0, 0, 0}},
                                  {{0, 3, 2.5}, {0, 0, 0}},
                                  {{-0.25, 2, -2.5}, {-0.25, 0, 0}},
                                  {{3, 2, 0.5}, {0, 0, 0.5}},
                                  {{0.125, 2e5, 3e5}, {0.125, 0, 0}, 0, 2e-4},
                                  {{0, 0.1, 2.5}, {0, 0, 0}},
                                  {{-1, 0.01, -1}, {1, 0, 1}}};

TEST(Hierarchies, LeaveGridsOfTrianglesAsTheyAre) {
    expectAlike(studio(grid(16, {-1, 0, -1}, 2, 0)), kOverGrid, 200);
    expectAlike(studio(grid(16, {-1, 0, -1}, 2, 0.2)), kOverGrid, 200);
}

// Flat and large and to one side of the origin, seen from just above it: what rounding makes of a hit is most there.
TEST(Hierarchies, LeaveALargeGridSeenAlongItselfAsItIs) {
    std::vector<Shot> shots{{{900, 30, 1200}, {700, 0, 0}, 0, 90}};
    for (const double height : {1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0}) {
        shots.push_back({{-1, height, -1}, {1000, 0, 900}, 0, 90});
        shots.push_back({{-1, height, -1}, {1000, 0, 900}, 0, 0.5 * height}); // the way to the horizon fills it
        shots.push_back({{1000, height, 1000.3}, {40, 0, 35}, 0, 0.5 * height});
    }
    expectAlike(studio(grid(24, {0, 0, 0}, 2000, 0)), shots, 100);
}

// ---- The same place twice

// Of objects at one distance the first is met, with hierarchies and without.
TEST(Hierarchies, MeetTheFirstOfTwoAtOnePlace) {
    const Shape ball = sphere({-1, 0, 0}, 0.5), other = sphere({-1, 0.1, 0}, 0.3);
    const Shape triangle = makeShape(ShapeKind::Triangle, {{0.2, -0.5, 0}, {1, -0.5, 0}, {0.6, 0.6, 0}});
    const Shape disc = makeShape(ShapeKind::Disc, {{0, 0, -1}, {0, 0, 1}}, {1.5});
    const Shape plane = makeShape(ShapeKind::Plane, {{0, 0, -1}, {0, 0, 1}});
    const std::vector<Shape> shapes{ball, other,    ball, triangle, disc,  plane, triangle,
                                    ball, triangle, disc, disc,     other, ball,  other};
    Scene scene = studio(shapes);
    for (Object& object : scene.objects) object.castsShadow = true; // or those that do have the lower numbers
    const std::vector<Shot> shots{{{0.1, 0.2, 6}, {-0.1, 0, 0}}, {{4, 3, 2}, {0, 0, 0}}, {{-6, 0, 0.5}, {0, 0, 0}}};
    expectAlike(scene, shots, 4);

    Drawing drawing(scene, sized(Accel::Hierarchy, Aov::Object, 1));
    std::set<int> seen;
    for (const Shot& shot : shots) {
        aim(drawing, shot);
        const FloatImage image = drawing.output();
        for (const float number : image.pixels) seen.insert(int(number));
    }
    for (const int first : {0, 3, 4, 5}) seen.erase(first); // ball, triangle, disc, plane
    EXPECT_EQ(seen, (std::set<int>{-1})) << "no other of each";
}

TEST(Hierarchies, LeaveACloudThatIsThereThriceAsItIs) {
    std::vector<Shape> shapes;
    for (int i = 0; i < 3; ++i)
        for (const Shape& ball : inACube(100, 1)) shapes.push_back(ball);
    expectAlike(studio(shapes), kAround, 30);
}

// ---- Elsewhere and at other times

TEST(Hierarchies, LeaveScenesFarFromTheOriginAsTheyAre) {
    const Scene here = studio(inACube(300, 1));
    const glm::dvec3 by(123456.7, -98765.4, 55555.5);
    std::vector<Shot> shots = kAround;
    for (Shot& shot : shots) shot.eye += by, shot.target += by;
    const Scene there = moved(here, by);
    ASSERT_NE(originOf(there), glm::dvec3(0));
    expectAlike(there, shots, 100);

    // One sphere at home keeps the shader's origin there: the cloud's float32 is coarse.
    Scene torn = moved(here, 0.01 * by);
    torn.objects[0].shape = sphere({0, 0, 0}, 1);
    torn.camera.eye = {0, 0, 5};
    ASSERT_EQ(originOf(torn), glm::dvec3(0));
    shots = kAround;
    for (Shot& shot : shots) shot.eye += 0.01 * by, shot.target += 0.01 * by;
    shots.push_back({{0, 1, 5}, 0.01 * by, 0, 0.1});
    expectAlike(torn, shots, 100);
}

// One renderer, many times: the tree is refitted, and built anew where that has spoilt it.
TEST(Hierarchies, LeaveWhatMovesAsItIsAtAnyTime) {
    Scene scene = studio(inACube(300, 1));
    Dice dice(23);
    for (Object& object : scene.objects)
        object.motion = Orbit{dice.point(0.5), dice.point(0.5), dice.number(-3, 3), -1};
    std::vector<Shot> shots;
    for (const double time : {0.0, 0.01, 0.05, 0.5, 2.0, 2.1, 50.0, 0.0, -7.0})
        shots.push_back({kAround[shots.size() % 2].eye, kAround[shots.size() % 2].target, time});
    expectAlike(scene, shots, 100);
}

} // namespace
} // namespace gnomon
