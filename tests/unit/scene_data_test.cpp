#include "tests/support/scenes.h"
#include "tracer/render/scene_data.h"

#include <gtest/gtest.h>

#include <map>

namespace gnomon {
namespace {

using test::sceneNamed;

std::map<std::string, int> constants(const Features& features) {
    std::map<std::string, int> map;
    for (const auto& [name, value] : constantsOf(features)) map[name] = value;
    return map;
}

class SceneData : public testing::TestWithParam<const char*> {
  protected:
    Scene scene = sceneNamed(GetParam());
    Features features = featuresOf(scene, {}, 1 << 20, true);
    std::map<std::string, int> at = constants(features);
    std::vector<glm::vec4> texels = packScene(scene, features, 0);
};

TEST_P(SceneData, IsAsLongAsItsConstantsSay) {
    EXPECT_EQ(int(texels.size()), at["kSceneTexels"]);
    EXPECT_EQ(int(texels.size()), sceneTexels(scene));
}

TEST_P(SceneData, NamesEveryObjectOnceByItsPlaceInTheFile) {
    std::vector<int> seen(scene.objects.size(), 0);
    for (int i = 0; i < at["kObjectCount"]; ++i) ++seen.at(std::size_t(texels[at["kObjectBase"] + i].y));
    for (int count : seen) EXPECT_EQ(count, 1);
}

TEST_P(SceneData, PutsCastersFirstInTheirKind) {
    for (const KindCount& kind : features.shapes) {
        const std::string name = "k" + std::string(shapeRow(kind.kind).type);
        for (int i = 0; i < kind.count; ++i) {
            const int index = int(texels[at["kObjectBase"] + at[name + "First"] + i].y);
            EXPECT_EQ(scene.objects[index].castsShadow, i < kind.casters) << name << i;
            EXPECT_EQ(scene.objects[index].shape.kind, kind.kind);
        }
    }
}

TEST_P(SceneData, PacksEveryShapeWhereItsConstantsSay) {
    const auto shapes = shapesAt(scene, 0);
    for (const KindCount& kind : features.shapes) {
        const std::string name = "k" + std::string(shapeRow(kind.kind).type);
        for (int i = 0; i < kind.count; ++i) {
            const int index = int(texels[at["kObjectBase"] + at[name + "First"] + i].y);
            for (int k = 0; k < at[name + "Texels"]; ++k) {
                const glm::vec4 packed = texels[at[name + "Base"] + i * at[name + "Texels"] + k];
                const glm::vec4 told(shapes[index].texels[k]);
                EXPECT_EQ(glm::vec3(packed), glm::vec3(told));
                if (kind.kind != ShapeKind::Triangle) {
                    EXPECT_EQ(packed.w, told.w); // else the middle of all
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneData, testing::Values("lite", "pro", "torus", "shapes"));

TEST(SceneData, TellsEveryTriangleTheMiddleOfAll) {
    const Scene scene = test::sceneFrom(R"({"objects": [{"triangle": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 2, 0]]}},
        {"sphere": {"center": [90, 90, 90], "radius": 1}}, {"triangle": {"vertices": [[5, 0, -8], [6, 0, 0], [5, 2, 0]]}}]})");
    const Features features = featuresOf(scene, {}, 1024, true);
    const auto texels = packScene(scene, features, 0);
    const int base = constants(features)["kTriangleBase"];
    for (const int triangle : {0, 1})
        for (int i = 0; i < 3; ++i) EXPECT_EQ(texels[base + 3 * triangle + i].w, glm::vec3(3, 1, -4)[i]);
}

TEST(SceneDataOfLite, GivesGoldTheReflectanceOfTheSource) {
    const Scene scene = sceneNamed("lite");
    const Features features = featuresOf(scene, {}, 1024, true);
    const auto texels = packScene(scene, features, 0);
    int gold = -1;
    for (const Object& object : scene.objects)
        if (object.name == "gold") gold = object.material;
    ASSERT_GE(gold, 0);
    const glm::vec4 f0 = texels[constants(features)["kMaterialBase"] + gold * kMaterialTexels + 4];
    EXPECT_NEAR(f0.r, 0.938, 5e-4);
    EXPECT_NEAR(f0.g, 0.846, 5e-4);
    EXPECT_NEAR(f0.b, 0.391, 5e-4);
}

TEST(SceneDataOfLite, ReducesTextureMotionToOnePeriodAlsoAfterADay) {
    const Scene scene = sceneNamed("lite");
    const Features features = featuresOf(scene, {}, 1024, true);
    const double day = 86400.25;
    const auto texels = packScene(scene, features, day);
    const int first = constants(features)["kMaterialBase"];
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const auto& use = scene.materials[m].texture;
        if (!use) continue;
        const glm::vec4 placement = texels[first + int(m) * kMaterialTexels + 5];
        const double exact = use->scroll.x * day - std::floor(use->scroll.x * day);
        EXPECT_NEAR(placement.z, exact, 1e-6) << scene.materials[m].name;
    }
}

} // namespace
} // namespace gnomon
