/// Groups and instances: what a scene file says of them is the plain list of objects that it stands for, and
/// what cannot be is told once, with its place and a remedy.
#include "tests/support/scenes.h"
#include "tracer/scene/affine.h"
#include "tracer/scene/read_scene.h"
#include "tracer/scene/rotation.h"
#include "tracer/scene/scene_format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

using namespace test;

std::string problemsOf(const std::string& text) {
    Problems problems;
    const auto scene = readScene(text, "f", problems);
    EXPECT_EQ(scene.has_value(), problems.empty());
    return toString(problems);
}
std::string problemsOfObjects(const std::string& objects) { return problemsOf("{\"objects\": [" + objects + "]}"); }

std::vector<Object> objectsOf(const std::string& objects, const std::string& more = "") {
    Problems problems;
    const auto scene = readScene("{" + more + "\"objects\": [" + objects + "]}", "f", problems);
    EXPECT_EQ(toString(problems), "");
    return scene.value_or(Scene{}).objects;
}

/// The one shape that `body` becomes in a group placed so.
Shape placed(const std::string& body, const std::string& placement) {
    const auto objects = objectsOf("{\"group\": {\"of\": [{" + body + "}], " + placement + "}}");
    EXPECT_EQ(objects.size(), 1u);
    return objects.empty() ? Shape{} : objects[0].shape;
}

const std::string kTurned = R"("scale": 2, "rotate": [0, 0, 90], "translate": [10, 0, 0])";
const std::string kSphere = R"("sphere": {"center": [1, 0, 0], "radius": 1})";
constexpr double kTight = 1e-12;

TEST(Group, ScalesThenRotatesThenMoves) {
    const Shape sphere = placed(kSphere, kTurned);
    EXPECT_EQ(sphere.kind, ShapeKind::Sphere);
    expectNear(pointOf(sphere, "center"), {10, 2, 0}, kTight, "center");
    EXPECT_NEAR(lengthOf(sphere, "radius"), 2, kTight);
}

TEST(Group, RotatesAboutXThenYThenZ) {
    const Shape sphere = placed(R"("sphere": {"center": [0, 1, 0], "radius": 1})", R"("rotate": [90, 90, 0])");
    expectNear(pointOf(sphere, "center"), {1, 0, 0}, kTight, "y to z, then z to x");
}

TEST(Group, TransformsEveryShapeExactly) {
    const Shape plane = placed(R"("plane": {"point": [1, 0, 0], "normal": [1, 0, 0]})", kTurned);
    expectNear(pointOf(plane, "point"), {10, 2, 0}, kTight, "point");
    expectNear(pointOf(plane, "normal"), {0, 1, 0}, kTight, "normal");
    const Shape disc = placed(R"("disc": {"center": [1, 0, 0], "normal": [1, 0, 0], "radius": 3})", kTurned);
    expectNear(pointOf(disc, "normal"), {0, 1, 0}, kTight, "normal");
    EXPECT_NEAR(lengthOf(disc, "radius"), 6, kTight);
    const Shape triangle = placed(R"("triangle": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]})", kTurned);
    expectNear(vertexOf(triangle, 1), {10, 2, 0}, kTight, "b");
    expectNear(vertexOf(triangle, 2), {8, 0, 0}, kTight, "c");
    const Shape torus = placed(
        R"("torus": {"center": [0, 0, 0], "axis": [1, 0, 0], "major_radius": 1, "minor_radius": 0.25})", kTurned);
    expectNear(pointOf(torus, "axis"), {0, 1, 0}, kTight, "axis");
    EXPECT_NEAR(lengthOf(torus, "minor_radius"), 0.5, kTight);
    for (const char* key : {"cylinder", "capsule", "cone"}) {
        const Shape shape =
            placed("\"" + std::string(key) + R"(": {"from": [0, 0, 0], "to": [1, 0, 0], "radius": 3})", kTurned);
        expectNear(pointOf(shape, "to"), {10, 2, 0}, kTight, key);
        EXPECT_NEAR(lengthOf(shape, "radius"), 6, kTight) << key;
    }
    const Shape box = placed(R"("box": {"center": [1, 0, 0], "half_size": [1, 2, 3]})", kTurned);
    EXPECT_EQ(box.kind, ShapeKind::RotatedBox);
    expectNear(pointOf(box, "center"), {10, 2, 0}, kTight, "center");
    expectNear(pointOf(box, "half_size"), {2, 4, 6}, kTight, "half_size");
    expectNear(axesOf(pointOf(box, "rotate"))[0], {0, 1, 0}, kTight, "its x");
}

TEST(Group, LeavesABoxABoxWhereItIsNotRotated) {
    const Shape box = placed(R"("box": {"center": [1, 0, 0], "half_size": [1, 2, 3]})", R"("scale": [2, 3, 4])");
    EXPECT_EQ(box.kind, ShapeKind::Box);
    expectNear(pointOf(box, "half_size"), {2, 6, 12}, kTight, "half_size");
}

TEST(Group, MakesEllipsoidsOfSpheresByUnevenScale) {
    const Shape shape = placed(kSphere, R"("scale": [2, 3, 4], "rotate": [0, 90, 0])");
    EXPECT_EQ(shape.kind, ShapeKind::Ellipsoid);
    expectNear(pointOf(shape, "center"), {0, 0, -2}, kTight, "center");
    expectNear(pointOf(shape, "radii"), {2, 3, 4}, kTight, "radii");
    expectNear(axesOf(pointOf(shape, "rotate"))[0], {0, 0, -1}, kTight, "its x");
}

/// The surface of the ellipsoid that a sheared sphere is: every point of the sphere, mapped, lies on it.
TEST(Group, FindsTheAxesOfAShearedSphere) {
    const auto objects = objectsOf(R"({"group": {"scale": [1, 5, 0.3], "of": [{"group": {"rotate": [20, 30, 40],
        "of": [{"ellipsoid": {"center": [0, 0, 0], "radii": [1, 2, 0.5], "rotate": [10, 0, 70]}}]}}]}})");
    const Shape& shape = objects.at(0).shape;
    ASSERT_EQ(shape.kind, ShapeKind::Ellipsoid);
    const glm::dmat3 inner = glm::mat3_cast(rotationOfDegrees({10, 0, 70})),
                     outer = glm::mat3_cast(rotationOfDegrees({20, 30, 40})), axes = axesOf(pointOf(shape, "rotate"));
    for (int i = 0; i < 100; ++i) {
        const double z = -0.99 + i * 0.02, r = std::sqrt(1 - z * z);
        const glm::dvec3 unit(r * std::cos(0.7 * i), r * std::sin(0.7 * i), z);
        const glm::dvec3 p = glm::dvec3(1, 5, 0.3) * (outer * (inner * (glm::dvec3(1, 2, 0.5) * unit)));
        EXPECT_NEAR(glm::length((glm::transpose(axes) * p) / pointOf(shape, "radii")), 1, 1e-9);
    }
}

TEST(Group, ScalesCylindersAndConesAlongTheirAxisByItself) {
    const Shape cone = placed(R"("cone": {"from": [0, 0, 0], "to": [0, 1, 0], "radius": 1})", R"("scale": [2, 5, 2])");
    expectNear(pointOf(cone, "to"), {0, 5, 0}, kTight, "to");
    EXPECT_NEAR(lengthOf(cone, "radius"), 2, kTight);
}

TEST(Group, RefusesWhatIsNoShapeAnyMoreWithAPlaceAndARemedy) {
    const std::string uneven = R"({"group": {"scale": [1, 2, 3],)"
                               "\n"
                               R"("of": [{)";
    EXPECT_EQ(problemsOfObjects(uneven + R"("disc": {"center": [0, 0, 0], "normal": [0, 1, 0], "radius": 1}}]}})"),
              "f:1: objects[0].group: the object of line 2: a disc scaled unevenly is none any more; use a flat "
              "ellipsoid, or scale the disc evenly along its plane\n");
    EXPECT_NE(problemsOfObjects(uneven + R"("torus": {"center": [0, 0, 0], "axis": [0, 1, 0], "major_radius": 1,
        "minor_radius": 0.5}}]}})")
                  .find("a torus scaled unevenly"),
              std::string::npos);
    EXPECT_NE(problemsOfObjects(uneven + R"("capsule": {"from": [0, 0, 0], "to": [0, 1, 0], "radius": 1}}]}})")
                  .find("a capsule scaled unevenly"),
              std::string::npos);
    EXPECT_NE(problemsOfObjects(uneven + R"("box": {"center": [0, 0, 0], "half_size": [1, 2, 3],
        "rotate": [0, 20, 0]}}]}})")
                  .find("scale it before it is rotated"),
              std::string::npos);
}

TEST(Group, RefusesWhatLeavesTheLimits) {
    EXPECT_EQ(problemsOfObjects(R"({"group": {"scale": 1000, "of": [{"sphere": {"center": [0, 0, 0],
        "radius": 5000}}]}})"),
              "f:1: objects[0].group: the object of line 1: radius of a sphere becomes 5000000; keep it from 1e-06 to "
              "1000000\n");
}

TEST(Group, GivesItsKeysToWhatHasNoneOfItsOwn) {
    const auto objects = objectsOf(R"({"group": {"of": [{)" + kSphere + R"(}, {)" + kSphere +
                                       R"(, "material": "a"}]}, "material": "b", "casts_shadow": false,
                                       "motion": {"orbit": {"cos": [1, 2, 3]}}})",
                                   R"("materials": {"a": {}, "b": {}}, )");
    ASSERT_EQ(objects.size(), 2u);
    EXPECT_EQ(objects[0].material, 2);
    EXPECT_EQ(objects[1].material, 1);
    for (const Object& object : objects) {
        EXPECT_FALSE(object.castsShadow);
        EXPECT_EQ(object.motion.value().cos, glm::dvec3(1, 2, 3));
    }
}

TEST(Group, TurnsTheMotionInside) {
    const auto objects =
        objectsOf(R"({"group": {"of": [{)" + kSphere +
                  R"(, "motion": {"orbit": {"cos": [1, 0, 0], "sin": [0, 0, 1], "rate": 3}}}], )" + kTurned + "}}");
    const Orbit orbit = objects.at(0).motion.value();
    expectNear(orbit.cos, {0, 2, 0}, kTight, "cos");
    expectNear(orbit.sin, {0, 0, 2}, kTight, "sin");
    EXPECT_EQ(orbit.rate, 3);
}

TEST(Group, LetsObjectsMoveAroundOthersInsideAndOutside) {
    const auto objects = objectsOf(R"({"group": {"of": [{)" + kSphere + R"(, "name": "sun"}, {)" + kSphere +
                                   R"(, "motion": {"orbit": {"around": "sun"}}}]}}, {)" + kSphere +
                                   R"(, "motion": {"orbit": {"around": "sun"}}})");
    EXPECT_EQ(objects.at(1).motion.value().around, 0);
    EXPECT_EQ(objects.at(2).motion.value().around, 0);
}

// Scaled by 2, a quarter about z, moved by 10: as a whole, whoever moves around whom.
TEST(Group, KeepsObjectsTogetherThatMoveAroundEachOther) {
    const std::string moon = R"("sphere": {"center": [0, 3, 0], "radius": 1})";
    Problems problems;
    const auto scene =
        readScene(R"({"objects": [{"group": {"of": [{"group": {"of": [{)" + kSphere + R"(, "name": "sun"}, {)" + moon +
                      R"(, "motion": {"orbit": {"cos": [1, 0, 0], "around": "sun"}}}], )" + kTurned +
                      R"(}}], "translate": [0, 0, 7]}}]})",
                  "f", problems);
    ASSERT_TRUE(scene) << toString(problems);
    const auto shapes = shapesAt(*scene, 0);
    expectNear(pointOf(shapes[0], "center"), {10, 2, 7}, kTight, "sun");
    expectNear(pointOf(shapes[1], "center"), {10 - 6, 2 + 2, 7}, kTight, "moon");
}

TEST(Group, RefusesANameAndASecondMotion) {
    EXPECT_EQ(problemsOfObjects(R"({"group": {"of": [{)" + kSphere + R"(}]}, "name": "g"})"),
              "f:1: objects[0].name: only a single object has a name; remove it, or name an object inside\n");
    EXPECT_NE(problemsOfObjects(R"({"group": {"of": [{)" + kSphere + R"(, "motion": {"orbit": {}}}]},
        "motion": {"orbit": {}}})")
                  .find("moves already within what moves here"),
              std::string::npos);
}

const std::string kPair = R"("definitions": {"pair": {"group": {"of": [{)" + kSphere + R"(, "name": "sun"}, {)" +
                          kSphere + R"(, "motion": {"orbit": {"cos": [1, 0, 0], "around": "sun"}}}]}}}, )";

TEST(Instance, PlacesADefinitionAsOftenAsItIsAskedFor) {
    const auto objects = objectsOf(R"({"instance": {"of": "pair"}, "material": "m"},
        {"instance": {"of": "pair", "scale": 2, "translate": [0, 5, 0]}})",
                                   R"("materials": {"m": {}}, )" + kPair);
    ASSERT_EQ(objects.size(), 4u);
    EXPECT_EQ(objects[1].motion.value().around, 0);
    EXPECT_EQ(objects[3].motion.value().around, 2) << "the one of its own instance";
    EXPECT_EQ(objects[0].material, 1);
    EXPECT_EQ(objects[2].material, 0);
    expectNear(pointOf(objects[2].shape, "center"), {2, 5, 0}, kTight, "center");
    EXPECT_EQ(objects[3].motion.value().cos, glm::dvec3(2, 0, 0));
}

TEST(Instance, DrawsNothingOfADefinitionByItself) { EXPECT_EQ(objectsOf("{" + kSphere + "}", kPair).size(), 1u); }

TEST(Instance, RefusesUnknownNamesCirclesAndWrongDefinitions) {
    EXPECT_EQ(problemsOf("{" + kPair + R"("objects": [{"instance": {"of": "pairs"}}]})"),
              "f:1: objects[0].instance.of: unknown definition \"pairs\"; did you mean \"pair\"?\n");
    EXPECT_EQ(problemsOf(R"({"definitions": {"a": {"instance": {"of": "b"}}, "b": {"instance": {"of": "a"}}},
        "objects": [{"instance": {"of": "a"}}]})"),
              "f:1: definitions.b.instance.of: \"a\" stands within itself in the end; let a definition hold others "
              "only\n");
    EXPECT_NE(problemsOf(R"({"definitions": {"a": {"sphere": {"center": [0, 0, 0], "radius": 0}}},
        "objects": [{)" + kSphere +
                         "}]}")
                  .find("definitions.a.sphere.radius: 0 is outside the limits"),
              std::string::npos)
        << "though it is not used";
}

// Each definition is twice the one before: a million objects in 1 KB.
TEST(Instance, OfTooManyObjectsIsOneProblem) {
    std::string text = R"({"definitions": {"d0": {)" + kSphere + "}";
    for (int i = 1; i <= 20; ++i) {
        const std::string before = R"({"instance": {"of": "d)" + std::to_string(i - 1) + "\"}}";
        text += ", \"d" + std::to_string(i) + R"(": {"group": {"of": [)" + before + ", " + before + "]}}";
    }
    const std::string problems = problemsOf(text + R"(}, "objects": [{"instance": {"of": "d20"}}]})");
    EXPECT_NE(problems.find("more than " + std::to_string(kMostObjects) + " objects"), std::string::npos) << problems;
    EXPECT_EQ(std::count(problems.begin(), problems.end(), '\n'), 1) << problems;
}

TEST(SolidInAGroup, IsOneMoreTransform) {
    const Shape solid = placed(R"("union": [{)" + kSphere + R"(}, {"box": {"center": [0, 0, 0],
        "half_size": [1, 1, 1]}}])",
                               kTurned);
    ASSERT_EQ(solid.kind, ShapeKind::Solid);
    EXPECT_EQ(solid.solid->root.op, SolidOp::Transform);
    EXPECT_NEAR(solid.solid->root.scale, 2, kTight);
}

TEST(SolidScaledUnevenly, IsOneOfOtherShapes) {
    const std::string uneven = R"("scale": [1, 2, 1], "rotate": [0, 0, 30], "translate": [1, 2, 3])";
    const std::string parts = R"("difference": [{)" + kSphere + R"(}, {"box": {"center": [0, 0, 0],
        "half_size": [1, 1, 1]}}])";
    const Shape inGroup = placed(parts, uneven),
                inSolid = objectsOf(R"({"transform": {"of": {)" + parts + "}, " + uneven + "}}").at(0).shape;
    for (const Shape& shape : {inGroup, inSolid}) {
        ASSERT_EQ(shape.kind, ShapeKind::Solid);
        EXPECT_EQ(formOf(shape.solid->root), "difference(ellipsoid,rotated_box)");
    }
    EXPECT_EQ(problemsOfObjects(R"({"transform": {"of": {"offset": {"of": {)" + kSphere + R"(}, "by": 1}},
        "scale": [1, 2, 1]}})"),
              "f:2: objects[0].transform.scale: an offset or a smooth union scaled unevenly: what it grows by or melts "
              "is a distance; scale its parts instead\n");
}

TEST(Rotation, OfThreeNumbersIsTheOneThatWasMeant) {
    for (int i = 0; i < 1000; ++i) {
        const glm::dquat q = rotationOfDegrees({i * 0.36, 17.0 * i, -360 + i * 0.72});
        const glm::dmat3 a = glm::mat3_cast(q), b = axesOf(rodriguesOf(q));
        for (int c = 0; c < 3; ++c) expectNear(b[c], a[c], 1e-14, "axis");
        EXPECT_LE(glm::length(rodriguesOf(q)), 1 + 1e-12);
    }
}

} // namespace
} // namespace gnomon
