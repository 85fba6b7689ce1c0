// What shapes are drawn as, and when anew: which spheres are huge, what moves, and that a large sphere's float32 values
// mean the scene's sphere.
#include "tests/support/scenes.h"
#include "tracer/plan/drawn.h"
#include "tracer/plan/scene_offsets.h"
#include "tracer/plan/scene_packer.h"
#include "tracer/plan/shape_texels.h"
#include "tracer/shader/shader_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace gnomon {
namespace {

using test::sceneFrom;
using test::sceneNamed;

const char* const kBall = R"({"sphere": {"center": [0, 0.5, 0], "radius": 0.5}})";
const char* const kFloor = R"({"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}})";

/// A sphere whose top is the origin, seen from `eyeHeight` above it, with one more object.
Scene onSphere(double radius, double eyeHeight, const std::string& other) {
    char text[300];
    std::snprintf(text, sizeof text,
                  R"({"camera": {"eye": [0, %.17g, 0], "target": [1000, 0, 0]},
            "objects": [{"sphere": {"center": [0, %.17g, 0], "radius": %.17g}},)",
                  eyeHeight, -radius, radius);
    return sceneFrom(text + other + "]}");
}

Scene scaled(Scene scene, double by) {
    scene.camera.eye *= by;
    for (Object& object : scene.objects)
        for (double& value : object.shape.values) value *= by; // spheres
    return scene;
}

ShapeKind first(const Scene& scene) { return drawnKinds(scene)[0]; }

std::string sourceOf(const Scene& scene) {
    Problems problems;
    const std::string text = buildShader("pass/trace.frag", planOf(*prepare(scene), {}, {}), problems).text;
    EXPECT_EQ(toString(problems), "");
    return text;
}

TEST(Drawn, IsALargeSphereWhereThingsOnASphereAreOverAHundredTimesSmaller) {
    EXPECT_EQ(first(onSphere(49, 10, kBall)), ShapeKind::Sphere);
    EXPECT_EQ(first(onSphere(51, 10, kBall)), ShapeKind::LargeSphere);
    EXPECT_EQ(drawnKinds(onSphere(51, 10, kBall))[1], ShapeKind::Sphere) << "the ball on it";
}

TEST(Drawn, IsALargeSphereWhereTheSceneIsSeenFromLessThanAHundredthAboveOrBelowASphere) {
    EXPECT_EQ(first(onSphere(1000, 11, kFloor)), ShapeKind::Sphere) << "a plane has no size";
    EXPECT_EQ(first(onSphere(1000, 9, kFloor)), ShapeKind::LargeSphere);
    EXPECT_EQ(first(onSphere(1000, -9, kFloor)), ShapeKind::LargeSphere);
}

TEST(Drawn, DoesNotDependOnTheScenesUnit) {
    for (double by : {1e-4, 1e4}) {
        EXPECT_EQ(first(scaled(onSphere(51, 10, kBall), by)), ShapeKind::LargeSphere);
        EXPECT_EQ(first(scaled(onSphere(49, 10, kBall), by)), ShapeKind::Sphere);
    }
}

TEST(Drawn, IsNoLargeSphereInTheScenesThatComeWithTheProgram) {
    for (const char* name : {"lite", "pro", "torus", "shapes"}) {
        const Scene scene = sceneNamed(name);
        for (std::size_t i = 0; i < scene.objects.size(); ++i)
            EXPECT_EQ(drawnKinds(scene)[i], scene.objects[i].shape.kind) << name;
        EXPECT_EQ(sourceOf(scene).find("LargeSphere"), std::string::npos) << name;
    }
}

TEST(Drawn, BringsTheCodeOfLargeSpheresOnlyWhereThereIsOne) {
    EXPECT_NE(sourceOf(onSphere(51, 10, kFloor)).find("intersectSphere"), std::string::npos);
    EXPECT_EQ(sourceOf(onSphere(51, 10, kFloor)).find("LargeSphere"), std::string::npos);
    EXPECT_NE(sourceOf(onSphere(5100, 10, kFloor)).find("intersectLargeSphere"), std::string::npos);
    EXPECT_EQ(sourceOf(onSphere(5100, 10, kFloor)).find(" intersectSphere"), std::string::npos) << "no sphere is left";
}

TEST(Drawn, DoesNotChangeWithTime) {
    Scene scene = onSphere(51, 10, kBall);
    scene.objects[1].motion = Orbit{{0, 1e5, 0}, {0, 0, 0}, 1, -1};
    scene.objects[0].motion = Orbit{{0, 0, 0}, {0, 1e5, 0}, 1, -1};
    const PreparedScenePtr prepared = prepare(scene);
    const Plan plan = planOf(*prepared, {}, {});
    const auto now = packScene(prepared, plan, 0), later = packScene(prepared, plan, 1.5707963);
    EXPECT_EQ(now.size(), later.size());
    EXPECT_EQ(int(now.size()), sceneTexels(plan.scene));
    EXPECT_NEAR(now[1].y, 0, 0.01) << "sphere first, then the large sphere's anchor: its top, under the eye";
    EXPECT_NEAR(later[1].y, 1e5 - 51 - 51, 0.01) << "its lowest point, now over the eye";
}

TEST(Drawn, LeavesTheGlowOfALargeSphereAtItsCentre) {
    Scene scene = onSphere(5100, 10, kFloor);
    scene.objects[0].glow = Glow{};
    const PreparedScenePtr prepared = prepare(scene);
    const Plan plan = planOf(*prepared, {}, {});
    const auto texels = packScene(prepared, plan, 0);
    EXPECT_EQ(plan.scene.glows, 1);
    EXPECT_EQ(texels[texels.size() - 2], glm::vec4(0, -5100, 0, Glow{}.strength));
}

/// The surface of a packed large sphere, as the shader's float32 values have it, above (p): curvature p·p / 2 +
/// normal·p + height.
double above(const ShapeTexels& packed, glm::dvec3 p) {
    const glm::vec4 a(packed[0]), b(packed[1]); // rounded as in packScene()
    const glm::dvec3 local = p - glm::dvec3(a.x, a.y, a.z);
    return double(a.w) * glm::dot(local, local) / 2 + glm::dot(glm::dvec3(b.x, b.y, b.z), local) + double(b.w);
}

// Which sphere is drawn: the scene's own, off by the rounding of normal and curvature, which grows with the distance D
// from the anchor: sqrt(3) 2^-25 D + 2^-25 D^2 / 2r, within 2^-23 D anywhere on the sphere.
TEST(LargeSphere, MeansTheScenesSphereWithinTheRoundingOfItsNormal) {
    for (const double radius : {1.0, 1e3, 1e4, 1e6}) {
        const glm::dvec3 up = glm::normalize(glm::dvec3(0.3123, 0.8765, -0.4321));
        const glm::dvec3 along = glm::normalize(glm::cross(up, glm::dvec3(0, 0, 1)));
        const glm::dvec3 center = glm::dvec3(0.1234567, -0.2345678, 0.3456789) - radius * up;
        const Shape sphere = makeShape(ShapeKind::Sphere, {center}, {radius});
        const Shape large = drawnAs(ShapeKind::LargeSphere, sphere, center + (radius + 1) * up);
        EXPECT_EQ(large.kind, ShapeKind::LargeSphere);
        const glm::dvec3 anchor = pointOf(large, "anchor");
        EXPECT_NEAR(glm::distance(anchor, center + radius * up), 0, 1e-7);
        for (double angle : {0.0, 1e-6, 1e-4, 1e-2, 0.5, 1.5, 3.0}) {
            const glm::dvec3 p = center + radius * (std::cos(angle) * up + std::sin(angle) * along);
            const double resolution = 4e-16 * radius; // of this test's own doubles
            EXPECT_LE(std::abs(above(packedShape(large), p)), std::ldexp(glm::distance(p, anchor), -23) + resolution)
                << radius << ' ' << angle;
        }
    }
}

TEST(LargeSphere, HasAnAnchorAlsoForAnEyeAtItsCentre) {
    const Shape sphere = makeShape(ShapeKind::Sphere, {{1, 2, 3}}, {10});
    const Shape large = drawnAs(ShapeKind::LargeSphere, sphere, {1, 2, 3});
    EXPECT_EQ(pointOf(large, "anchor"), glm::dvec3(1, 12, 3));
    EXPECT_EQ(pointOf(large, "normal"), glm::dvec3(0, 1, 0));
    EXPECT_EQ(lengthOf(large, "curvature"), 0.1);
    EXPECT_EQ(lengthOf(large, "height"), 0);
}

TEST(Drawn, LeavesEveryOtherShapeAsItIs) {
    const Shape disc = makeShape(ShapeKind::Disc, {{1, 2, 3}, {0, 1, 0}}, {10});
    EXPECT_EQ(drawnAs(ShapeKind::Disc, disc, {1, 2, 3}).values, disc.values);
}

TEST(Time, ChangesOnlyScenesInWhichSomethingMoves) {
    for (const char* name : {"lite", "pro"}) EXPECT_TRUE(changesWithTime(sceneNamed(name))) << name;
    for (const char* name : {"solids", "simple", "mandelbulb"}) EXPECT_FALSE(changesWithTime(sceneNamed(name))) << name;
    const std::string sphere = R"("sphere": {"center": [0, 0, 0], "radius": 1})";
    EXPECT_TRUE(
        changesWithTime(sceneFrom(R"({"objects": [{)" + sphere + R"(, "motion": {"orbit": {"cos": [1, 0, 0]}}}]})")));
    const auto textured = [&](const char* scroll) {
        return sceneFrom(std::string(R"({"materials": {"m": {"texture": {"image": "grid", "scroll": )") + scroll +
                         R"(}}}, "objects": [{"material": "m", )" + sphere + "}]}");
    };
    EXPECT_TRUE(changesWithTime(textured("[0.1, 0]")));
    EXPECT_FALSE(changesWithTime(textured("[0, 0]")));
}

} // namespace
} // namespace gnomon
