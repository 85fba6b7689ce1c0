/// What is uncommon in a scene, and what the base variant then goes without.
#include "tests/support/scenes.h"
#include "tracer/shader/scene_constants.h"
#include "tracer/software/tuning.h"
#include "tracer/software/uncommon_features.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

using namespace test;

const CodegenTarget kLlvmpipe = tunedFor(Rasteriser::Llvmpipe);

Plan splitOf(const Scene& scene, const Settings& settings = {}, const CodegenTarget& target = kLlvmpipe) {
    return splitPlanOf(*prepare(scene), settings, target);
}

std::size_t indexOf(const Plan& plan, ShapeKind kind) {
    for (std::size_t k = 0; k < plan.scene.shapes.size(); ++k)
        if (plan.scene.shapes[k].kind == kind) return k;
    ADD_FAILURE() << "no such kind";
    return 0;
}

ScreenSplit::Kind uncommonOf(const Plan& plan, ShapeKind kind) { return plan.split.kind(indexOf(plan, kind)); }
bool showsImages(const Plan& plan, ShapeKind kind) { return plan.scene.shapes[indexOf(plan, kind)].images; }

TEST(UncommonFeatures, OfProAreTheTorusTheGlassAndThePlanetsImages) {
    const Plan full = splitOf(sceneNamed("pro"));
    EXPECT_TRUE(full.split.on);
    EXPECT_TRUE(full.split.refraction);
    EXPECT_TRUE(full.split.normalMaps);
    EXPECT_TRUE(uncommonOf(full, ShapeKind::Torus).shape);
    EXPECT_FALSE(uncommonOf(full, ShapeKind::Box).shape) << "cheap to ask";
    EXPECT_TRUE(uncommonOf(full, ShapeKind::Sphere).images);
    EXPECT_FALSE(uncommonOf(full, ShapeKind::Disc).images) << "the ground is seen everywhere";
    const Plan base = baseOf(full);
    EXPECT_TRUE(base.split.fallback);
    EXPECT_FALSE(base.scene.refraction);
    EXPECT_TRUE(base.scene.reflection) << "of the mirror";
    EXPECT_EQ(base.scene.normalMaps, 0);
    EXPECT_GT(base.scene.paints, 0);
    EXPECT_FALSE(showsImages(base, ShapeKind::Sphere));
    EXPECT_TRUE(showsImages(base, ShapeKind::Disc));
}

TEST(Variants, HaveTheirValuesInOnePosition) {
    for (const char* name : {"lite", "pro", "shapes", "torus"}) {
        const Plan full = splitOf(sceneNamed(name));
        EXPECT_EQ(constantsOf(full.scene), constantsOf(baseOf(full).scene)) << name;
    }
}

TEST(Variants, AreForSoftwareRasterisersUnlessAskedFor) {
    const Scene scene = sceneNamed("pro");
    Settings on, off, silhouette, work;
    on.variants = Variants::On;
    off.variants = Variants::Off;
    silhouette.shadows = ShadowModel::Silhouette;
    work.aov = Aov::Work;
    EXPECT_FALSE(splitOf(scene, {}, {}).split.on);
    EXPECT_TRUE(splitOf(scene, on, {}).split.on);
    EXPECT_FALSE(splitOf(scene, off).split.on);
    EXPECT_FALSE(splitOf(scene, work).split.on) << "counts what the full variant asks";
    EXPECT_TRUE(splitOf(scene, silhouette).split.on) << "with a sky of its own";
    EXPECT_FALSE(splitOf(scene, silhouette).split.anyUncommon()) << "which asks all casters";
}

TEST(Variants, FallBackInTilesWhereDepthTestsSpareNothing) {
    const Scene scene = sceneNamed("pro");
    const Plan tiled = splitOf(scene, {}, tunedFor(Rasteriser::SwiftShader));
    EXPECT_TRUE(tiled.split.anyUncommon());
    EXPECT_EQ(tiled.split.tile, 2);
    EXPECT_EQ(baseOf(tiled).split.tile, 0);
    EXPECT_EQ(splitOf(scene).split.tile, 0);
    const CodegenTarget smallPoints = tunedFor(Rasteriser::SwiftShader, 1);
    EXPECT_TRUE(splitOf(scene, {}, smallPoints).split.on) << "a sky still";
    EXPECT_FALSE(splitOf(scene, {}, smallPoints).split.anyUncommon()) << "points are too small";
}

TEST(UncommonFeatures, AreNoneThatAreSeenALot) {
    const Scene near = sceneFrom(R"({
        "camera": {"eye": [0, 0, 4], "target": [0, 0, 0]},
        "materials": {"glass": {"dielectric": {"ior": 1.5}}},
        "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "glass"},
                    {"torus": {"center": [0, 0, 0], "axis": [0, 1, 0], "major_radius": 1.5, "minor_radius": 0.2}}]})");
    EXPECT_FALSE(splitOf(near).split.anyUncommon());
    EXPECT_EQ(baseOf(splitOf(near)), splitOf(near)) << "of which there is no base variant then";
    Scene far = near;
    far.camera.eye.z = 40;
    EXPECT_TRUE(splitOf(far).split.refraction);
    EXPECT_TRUE(uncommonOf(splitOf(far), ShapeKind::Torus).shape);
}

} // namespace
} // namespace gnomon
