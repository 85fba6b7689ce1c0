/// A plan is pure and made of what was prepared once; what contradicts itself is told.
#include "tests/support/clouds.h"
#include "tests/support/scenes.h"
#include "tracer/plan/drawn.h"
#include "tracer/plan/plan.h"
#include "tracer/shader/shader_builder.h"
#include "tracer/software/tuning.h"
#include "tracer/software/uncommon_features.h"

#include <gtest/gtest.h>

#include <functional>

namespace gnomon {
namespace {

using test::sceneFrom;
using test::sceneNamed;

const CodegenTarget kLlvmpipe = tunedFor(Rasteriser::Llvmpipe), kSwiftShader = tunedFor(Rasteriser::SwiftShader);

/// The row's setting with another value than it has.
Settings changed(const SettingRow& row) {
    std::vector<std::string> texts{"on", "off", "1", "2", "0.01", "0.5", "90", "64x48", "1,2,3"};
    if (const auto* choice = std::get_if<ChoiceType>(&row.type))
        texts.assign(choice->names.begin(), choice->names.end());
    Settings settings;
    for (const std::string& text : texts) {
        Problems problems;
        if (setFromText(settings, row.key, text, "test", problems) && textOf(row, settings) != textOf(row, {})) break;
    }
    EXPECT_NE(textOf(row, settings), textOf(row, {})) << row.key;
    return settings;
}

std::string sourceOf(const Plan& plan, const char* pass = "pass/trace.frag") {
    Problems problems;
    const std::string text = buildShader(pass, plan, problems).text + buildCanvas(plan, problems).text;
    EXPECT_EQ(toString(problems), "");
    return text;
}

TEST(Plan, IsTheSameForTheSameSceneSettingsAndTarget) {
    for (const char* name : {"lite", "pro", "shapes", "solids"})
        for (const CodegenTarget& target : {CodegenTarget{}, kLlvmpipe, kSwiftShader}) {
            const PreparedScenePtr one = prepare(sceneNamed(name)), two = prepare(sceneNamed(name));
            EXPECT_EQ(splitPlanOf(*one, {}, target), splitPlanOf(*one, {}, target)) << name;
            EXPECT_EQ(splitPlanOf(*one, {}, target), splitPlanOf(*two, {}, target)) << name;
        }
}

TEST(Plan, DependsOnNoSettingThatIsAUniformOrTheHosts) {
    const PreparedScenePtr scene = prepare(sceneNamed("pro"));
    int others = 0;
    for (const SettingRow& row : settingsTable()) {
        if (row.effect == Effect::Rebuild) continue;
        const Settings other = changed(row);
        ++others;
        EXPECT_TRUE(planAlike({}, other)) << row.key;
        EXPECT_EQ(splitPlanOf(*scene, {}, kLlvmpipe), splitPlanOf(*scene, other, kLlvmpipe)) << row.key;
    }
    EXPECT_GT(others, 15);
}

TEST(Plan, IsMadeAnewWhereASettingRebuilds) {
    for (const SettingRow& row : settingsTable())
        EXPECT_EQ(planAlike({}, changed(row)), row.effect != Effect::Rebuild) << row.key;
}

// What the program cache relies on: equal keys, equal sources.
TEST(Plan, HasTheSourceThatItsKeyHas) {
    for (const char* name : {"lite", "pro", "shapes", "solids"}) {
        const PreparedScenePtr scene = prepare(sceneNamed(name));
        for (const CodegenTarget& target : {CodegenTarget{}, kLlvmpipe, kSwiftShader}) {
            const Plan plan = splitPlanOf(*scene, {}, target), base = baseOf(plan);
            for (const Plan& variant : {plan, base, skyOf(plan)}) {
                Plan key = sourceKeyOf(variant);
                EXPECT_EQ(sourceKeyOf(key), key) << name;
                if (key.split.fallback || key.split.tile == 0) {
                    EXPECT_EQ(sourceOf(variant), sourceOf(key)) << name;
                }
            }
            if (plan.split.anyUncommon()) {
                EXPECT_FALSE(sourceKeyOf(plan) == sourceKeyOf(base)) << name;
            }
        }
    }
}

TEST(Plan, SharesItsKeyWithSolidsOfTheSameForm) {
    const auto key = [](const char* radius) {
        return sourceKeyOf(planOf(
            *prepare(sceneFrom(std::string(R"({"objects": [{"union": [{"sphere": {"center": [0, 0, 0], "radius": )") +
                               radius + "}}]}]}")),
            {}, {}));
    };
    EXPECT_EQ(key("1"), key("2"));
}

TEST(Plan, PreparesASceneOnceForAllThatIsAskedOfIt) {
    const int before = preparedScenes();
    const PreparedScenePtr scene = prepare(sceneNamed("pro"));
    for (const CodegenTarget& target : {CodegenTarget{}, kLlvmpipe, kSwiftShader}) {
        const Plan plan = splitPlanOf(*scene, {}, target);
        sourceOf(plan);
        sourceOf(baseOf(plan));
        screenBoundsOf(*scene, plan, scene->shapes);
    }
    EXPECT_EQ(preparedScenes(), before + 1);
}

TEST(PreparedScene, HoldsWhatIsAskedOfAScene) {
    const PreparedScenePtr pro = prepare(sceneNamed("pro"));
    EXPECT_EQ(pro->origin, originOf(pro->scene));
    EXPECT_EQ(pro->shapes.size(), pro->scene.objects.size());
    EXPECT_EQ(pro->searches.size(), pro->layout.size());
    EXPECT_EQ(pro->skyFaces.size(), pro->scene.background.cubemap.empty() ? 0u : 6u);
    EXPECT_TRUE(pro->moves);
    EXPECT_FALSE(prepare(sceneNamed("simple"))->moves);
}

// What of reflectance, checkers and lights a scene does not use, its shader and its data do not know.
TEST(Plan, HoldsOfMaterialsAndLightsWhatTheSceneUses) {
    const auto planFor = [](const std::string& more) {
        return planOf(*prepare(sceneFrom("{" + more + R"("objects": [{"sphere": {"center": [0, 0, 0], "radius": 1},
            "material": "m"}]})")),
                      {}, {});
    };
    const SceneFeatures glass = planFor(R"("materials": {"m": {"dielectric": {"ior": 1.5}}},)").scene;
    EXPECT_TRUE(glass.exactFresnel);
    EXPECT_FALSE(glass.metals() || glass.mirrors || glass.checkers || glass.lightProfiles || glass.directional);
    const std::string metal = R"("materials": {"m": {"conductor": {"n": 1, "k": 2}}},)";
    EXPECT_TRUE(planFor(metal).scene.metals());
    EXPECT_FALSE(planFor(R"("fresnel": "schlick",)" + metal).scene.metals());
    EXPECT_FALSE(planFor(R"("materials": {"m": {"diffuse": 1}},)").scene.exactFresnel) << "nothing reflects";
    EXPECT_TRUE(planFor(R"("materials": {"m": {"mirror": 1}},)").scene.mirrors);
    EXPECT_TRUE(planFor(R"("materials": {"m": {"checker": {"colors": [1, 0]}}},)").scene.checkers);
    const auto lit = [&](const std::string& light) {
        return planFor(R"("materials": {"m": {}}, "lights": [{)" + light + "}],").scene;
    };
    const std::string point = R"("point": {"position": [0, 9, 0]})";
    EXPECT_FALSE(lit(point).lightProfiles || lit(point).directional);
    EXPECT_TRUE(lit(point + R"(, "falloff": 2)").lightProfiles);
    EXPECT_TRUE(lit(R"("spot": {"position": [0, 9, 0], "direction": [0, -1, 0]})").lightProfiles);
    EXPECT_TRUE(lit(R"("directional": {"direction": [0, -1, 0]})").directional);
    for (const char* name : {"lite", "pro"})
        EXPECT_FALSE(planOf(*prepare(sceneNamed(name)), {}, {}).scene.exactFresnel);
}

// ---- What contradicts itself

/// Pro's plan, in which nothing does, with one change.
std::string withChange(const std::function<void(Plan&)>& change, const CodegenTarget& target = kLlvmpipe) {
    static const PreparedScenePtr pro = prepare(sceneNamed("pro"));
    Plan plan = splitPlanOf(*pro, {}, target);
    EXPECT_EQ(contradictionIn(plan), "");
    EXPECT_EQ(contradictionIn(baseOf(plan)), "");
    EXPECT_EQ(contradictionIn(skyOf(plan)), "");
    change(plan);
    return contradictionIn(plan);
}

TEST(Contradiction, IsToldOfTheScenesFacts) {
    EXPECT_EQ(withChange([](Plan& p) {
                  p.scene.directional = true;
                  p.scene.fromLight = true;
              }),
              "shadow cones from a light without a place");
    EXPECT_EQ(withChange([](Plan& p) {
                  p.scene.directional = true;
                  p.scene.shadows = ShadowModel::Silhouette;
              }),
              "a shadow model that takes no directional light");
    EXPECT_EQ(withChange([](Plan& p) { p.scene.reflection = false; }), "reflection without a material that reflects");
    EXPECT_EQ(withChange([](Plan& p) { p.scene.lights = 0; }), "shadows without a light");
    EXPECT_EQ(withChange([](Plan& p) {
                  p.scene.shadows = ShadowModel::Off;
                  p.scene.fromLight = true;
              }),
              "shadow cones from the light without shadows");
    EXPECT_EQ(withChange([](Plan& p) { p.scene.shadows = ShadowModel::Quilez; }),
              "a shadow model without the distances it asks for");
    EXPECT_EQ(withChange([](Plan& p) { p.scene.shapes[0].casters = p.scene.shapes[0].count + 1; }),
              "more casters than objects of a kind");
    EXPECT_EQ(withChange([](Plan& p) { p.scene.shapes[0].lattice = glm::ivec3(100); }),
              "a lattice of more objects than there are");
    EXPECT_EQ(withChange([](Plan& p) { p.scene.shapes[0].search = Search::Grid; }),
              "a uniform grid that is not the search");
    EXPECT_EQ(withChange([](Plan& p) { p.scene.shapes[0].kind = ShapeKind::Solid; }), "a solid without its tree");
}

TEST(Contradiction, IsToldOfTheTarget) {
    EXPECT_EQ(withChange([](Plan& p) { p.target.fallback = false; }, kSwiftShader),
              "a target with tiles but without fallback");
}

TEST(Contradiction, IsToldOfTheSplit) {
    EXPECT_EQ(withChange([](Plan& p) { p.split.kinds.pop_back(); }), "a split of other kinds");
    EXPECT_EQ(withChange([](Plan& p) { p.split.on = false; }), "uncommon features without a split");
    EXPECT_EQ(withChange([](Plan& p) { p.scene.output = Aov::Normal; }), "a split of an output that is no colour");
    EXPECT_EQ(withChange([](Plan& p) { p.split = {.on = true, .fallback = true}; }),
              "fallback without an uncommon feature");
    EXPECT_EQ(withChange([](Plan& p) { p.split.fallback = true; }), "a base variant that refracts");
    EXPECT_EQ(withChange([](Plan& p) {
                  p = baseOf(p);
                  p.scene.normalMaps = 1;
              }),
              "a base variant with normal maps");
    EXPECT_EQ(withChange([](Plan& p) { p.split = {.on = true, .tile = 2}; }), "tiles without an uncommon feature");
    EXPECT_EQ(withChange([](Plan& p) {
                  p = baseOf(p);
                  p.split.tile = 2;
              }),
              "tiles of the base variant");
    EXPECT_EQ(withChange([](Plan& p) {
                  p.split.on = p.split.refraction = p.split.coverageMask = true;
                  p.split.tile = 2;
              }),
              "a variant that both marks and reads the coverage mask");
}

TEST(Contradiction, IsAProblemOfTheShaderThatWouldBeBuilt) {
    Plan plan = planOf(*prepare(sceneNamed("lite")), {}, {});
    plan.scene.lights = 0;
    Problems problems;
    buildShader("pass/trace.frag", plan, problems);
    EXPECT_NE(toString(problems).find("the plan contradicts itself: shadows without a light"), std::string::npos);
}

// ---- Choices

TEST(Plan, ChoosesABlockWhereTheSceneFitsAndItIsAsFast) {
    const PreparedScenePtr lite = prepare(sceneNamed("lite"));
    EXPECT_TRUE(planOf(*lite, {}, {}).scene.dataBlock);
    EXPECT_FALSE(planOf(*lite, {}, {.blockTexels = 16}).scene.dataBlock);
    Settings texture;
    texture.data = DataPath::Texture;
    EXPECT_FALSE(planOf(*lite, texture, {}).scene.dataBlock);
    EXPECT_FALSE(planOf(*lite, {}, kLlvmpipe).scene.dataBlock);
    Settings block;
    block.data = DataPath::Block;
    EXPECT_TRUE(planOf(*lite, block, kLlvmpipe).scene.dataBlock);
}

Search searchOf(int spheres, DataPath data, const CodegenTarget& target) {
    Scene scene = sceneFrom(R"({"objects": [{"sphere": {"center": [0, 0, 0], "radius": 0.1}}]})");
    const Object object = scene.objects.front();
    scene.objects.clear();
    for (const Shape& shape : test::inACube(spheres, 1)) {
        scene.objects.push_back(object);
        scene.objects.back().shape = shape;
    }
    Settings settings;
    settings.data = data;
    return planOf(*prepare(scene), settings, target).scene.shapes.front().search;
}

TEST(Plan, ChoosesAUniformGridWhereSceneDataLiesInATexture) {
    EXPECT_EQ(searchOf(200, DataPath::Auto, {}), Search::Hierarchy) << "a block holds them";
    EXPECT_EQ(searchOf(200, DataPath::Texture, {}), Search::Grid);
    EXPECT_EQ(searchOf(2000, DataPath::Auto, {}), Search::Grid) << "no block does";
    EXPECT_EQ(searchOf(2000, DataPath::Block, {}), Search::Hierarchy);
    EXPECT_EQ(searchOf(200, DataPath::Auto, kLlvmpipe), Search::Grid);
}

} // namespace
} // namespace gnomon
