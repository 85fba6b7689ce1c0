/// What is rare in a scene, and what the usual program then goes without.
#include "tests/support/scenes.h"
#include "tracer/plan/scene_packer.h"
#include "tracer/software/uncommon_features.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

using namespace test;

constexpr GlslTarget kProcessor{.processor = true};

const KindCount& kindIn(const Features& features, ShapeKind kind) {
    for (const KindCount& count : features.shapes)
        if (count.kind == kind) return count;
    ADD_FAILURE() << "no such kind";
    return features.shapes.front();
}

TEST(Parts, OfProAreTheTorusTheGlassAndThePlanetsImages) {
    const Features whole = featuresOf(sceneNamed("pro"), {}, kProcessor);
    EXPECT_TRUE(whole.parted);
    EXPECT_TRUE(whole.refractionUncommon);
    EXPECT_TRUE(whole.normalMapsUncommon);
    EXPECT_TRUE(kindIn(whole, ShapeKind::Torus).uncommon);
    EXPECT_FALSE(kindIn(whole, ShapeKind::Box).uncommon) << "cheap to ask";
    EXPECT_TRUE(kindIn(whole, ShapeKind::Sphere).imagesUncommon);
    EXPECT_FALSE(kindIn(whole, ShapeKind::Disc).imagesUncommon) << "the ground is seen everywhere";
    const Features usual = baseOf(whole);
    EXPECT_TRUE(usual.fallsBack);
    EXPECT_FALSE(usual.refraction);
    EXPECT_TRUE(usual.reflection) << "of the mirror";
    EXPECT_EQ(usual.normalMaps, 0);
    EXPECT_GT(usual.paints, 0);
    EXPECT_FALSE(kindIn(usual, ShapeKind::Sphere).images);
    EXPECT_TRUE(kindIn(usual, ShapeKind::Disc).images);
}

TEST(Parts, HaveTheirNumbersInOnePlace) {
    for (const char* name : {"lite", "pro", "shapes", "torus"}) {
        const Features whole = featuresOf(sceneNamed(name), {}, kProcessor);
        EXPECT_EQ(constantsOf(whole), constantsOf(baseOf(whole))) << name;
    }
}

TEST(Parts, AreForProcessorsUnlessAskedFor) {
    const Scene scene = sceneNamed("pro");
    Settings on, off, silhouette, work;
    on.parts = Parts::On;
    off.parts = Parts::Off;
    silhouette.shadows = ShadowModel::Silhouette;
    work.aov = Aov::Work;
    EXPECT_FALSE(featuresOf(scene, {}, {}).parted);
    EXPECT_TRUE(featuresOf(scene, on, {}).parted);
    EXPECT_FALSE(featuresOf(scene, off, kProcessor).parted);
    EXPECT_FALSE(featuresOf(scene, work, kProcessor).parted) << "counts what the whole program asks";
    EXPECT_TRUE(featuresOf(scene, silhouette, kProcessor).parted) << "with a sky of its own";
    EXPECT_FALSE(anyUncommon(featuresOf(scene, silhouette, kProcessor))) << "which asks all casters";
}

TEST(Parts, AreMendedInTilesWhereDepthsSpareNothing) {
    const Scene scene = sceneNamed("pro");
    GlslTarget target{.processor = true, .swiftShader = true};
    const Features tiled = featuresOf(scene, {}, target);
    EXPECT_TRUE(anyUncommon(tiled));
    EXPECT_EQ(tiled.tile, 2);
    EXPECT_EQ(baseOf(tiled).tile, 0);
    EXPECT_EQ(featuresOf(scene, {}, kProcessor).tile, 0);
    target.mostPoint = 1;
    EXPECT_TRUE(featuresOf(scene, {}, target).parted) << "a sky still";
    EXPECT_FALSE(anyUncommon(featuresOf(scene, {}, target))) << "points are too small";
}

TEST(Parts, LeaveNothingOutThatIsSeenALot) {
    const Scene near = sceneFrom(R"({
        "camera": {"eye": [0, 0, 4], "target": [0, 0, 0]},
        "materials": {"glass": {"dielectric": {"ior": 1.5}}},
        "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "glass"},
                    {"torus": {"center": [0, 0, 0], "axis": [0, 1, 0], "major_radius": 1.5, "minor_radius": 0.2}}]})");
    EXPECT_FALSE(anyUncommon(featuresOf(near, {}, kProcessor)));
    Scene far = near;
    far.camera.eye.z = 40;
    EXPECT_TRUE(featuresOf(far, {}, kProcessor).refractionUncommon);
    EXPECT_TRUE(kindIn(featuresOf(far, {}, kProcessor), ShapeKind::Torus).uncommon);
}

} // namespace
} // namespace gnomon
