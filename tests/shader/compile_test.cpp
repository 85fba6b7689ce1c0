/// Every scene × output × setting compiles: in glslang, which knows the standard, and in the GLs at hand, in both
/// preludes.

#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/gl/objects.h"
#include "tracer/shader/library.h"
#include "tracer/shader/shader_builder.h"
#include "tracer/software/tuning.h"
#include "tracer/software/uncommon_features.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace gnomon {
namespace {

using namespace test;

struct Variant {
    std::string name;
    Plan plan;
    std::string_view pass = "pass/trace.frag";
};

/// The combinations of settings that change the source.
std::vector<Variant> variants(const std::string& sceneName) {
    const PreparedScenePtr scene = prepare(sceneNamed(sceneName));
    std::vector<Variant> all;
    for (bool es300 : {true, false})
        for (DataPath data : {DataPath::Block, DataPath::Texture}) {
            Settings settings;
            settings.data = data;
            const auto rasteriser = data == DataPath::Texture ? Rasteriser::Llvmpipe : Rasteriser::Gpu;
            const auto add = [&](const std::string& what) {
                all.push_back({sceneName + (es300 ? " es300 " : " gl330 ") +
                                   (data == DataPath::Block ? "block " : "texture ") + what,
                               planOf(*scene, settings, tunedFor(rasteriser, 64, {.es300 = es300}))});
            };
            for (Aov aov : {Aov::Color, Aov::Distance, Aov::Position, Aov::Normal, Aov::Object, Aov::Visibility,
                            Aov::Work, Aov::Steps}) {
                settings.aov = aov;
                add("output " + std::to_string(int(aov)));
                settings.shadows = ShadowModel::Off;
                add("output " + std::to_string(int(aov)) + " no shadows");
                settings.shadows = ShadowModel::Hard;
            }
            settings.aov = Aov::Color;
            if (data == DataPath::Block) {
                for (const ShadowRow& row : kShadowModels)
                    for (const ConeOrigin coneOrigin : {ConeOrigin::Surface, ConeOrigin::Light}) {
                        settings.shadows = row.model;
                        settings.coneOrigin = coneOrigin;
                        add(std::string(row.key) + (coneOrigin == ConeOrigin::Surface ? " surface" : " light"));
                    }
                for (const March march : {March::Steps, March::Sphere, March::Cone, March::Relaxed}) {
                    settings.march = march;
                    add("march " + std::to_string(int(march)));
                }
                settings = {};
                settings.data = data;
            }
            settings.glow = settings.normalMaps = false;
            add("no glow, no normal maps");
            add("distances");
            all.back().plan.scene.distances = true;
            all.back().pass = "pass/distance.frag";
        }
    for (const bool es300 : {true, false}) {
        const Plan plan = splitPlanOf(*scene, {}, tunedFor(Rasteriser::SwiftShader, 64, {.es300 = es300}));
        all.push_back({sceneName + " for SwiftShader", plan});
        all.push_back({sceneName + " for SwiftShader, base", baseOf(plan)});
        all.push_back({sceneName + " for SwiftShader, sky", skyOf(plan), "pass/sky.frag"});
    }
    return all;
}

ShaderSource sourceOf(const Variant& variant) {
    Problems problems;
    ShaderSource source = buildShader(variant.pass, variant.plan, problems);
    EXPECT_EQ(toString(problems), "");
    return source;
}

class Compile : public testing::TestWithParam<const char*> {
  protected:
    std::vector<Variant> all = variants(GetParam());
};

TEST_P(Compile, SatisfiesGlslang) {
    const auto folder = std::filesystem::temp_directory_path() / ("gnomon-glslang-" + std::string(GetParam()));
    std::filesystem::create_directories(folder);
    std::string files;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto file = folder / (std::to_string(i) + ".frag");
        std::ofstream(file) << sourceOf(all[i]).text;
        files += " " + file.string();
    }
    const std::string log = (folder / "log").string();
    EXPECT_EQ(std::system(("glslangValidator" + files + " > " + log + " 2>&1").c_str()), 0)
        << std::ifstream(log).rdbuf();
    std::filesystem::remove_all(folder);
}

void compilesIn(ContextKind kind, const std::vector<Variant>& all) {
    offscreen(kind);
    const bool es300 = gl::info().essl300, es = gl::info().es;
    EXPECT_TRUE(es300);
    for (const Variant& variant : all) {
        if (es && !variant.plan.target.es300) continue; // a GLES driver takes GLES text only
        Problems problems;
        const ShaderSource source = sourceOf(variant);
        const gl::Program program(buildCanvas(variant.plan, problems).text, source.text);
        EXPECT_TRUE(program.linked()) << variant.name << '\n'
                                      << toString(mapLog(program.fragmentLog(), source)) << program.linkLog();
    }
}

TEST_P(Compile, LinksInOsMesaInBothPreludes) { compilesIn(ContextKind::OsMesa, all); }

INSTANTIATE_TEST_SUITE_P(Scenes, Compile,
                         testing::Values("lite", "pro", "torus", "shapes", "complex", "solids", "mandelbulb"),
                         [](const auto& test) { return std::string(test.param); });

void namesThePlaceOfAFault(ContextKind kind) {
    offscreen(kind);
    ShaderSource source = sourceOf(variants("lite")[0]);
    const std::string right = "return Sphere(a.xyz, a.w);";
    const auto at = source.text.find(right);
    ASSERT_NE(at, std::string::npos);
    source.text.replace(at, right.size(), "return Sphere(a.xyz, nonsense);");
    Problems problems;
    const gl::Program program(buildCanvas(variants("lite")[0].plan, problems).text, source.text);
    ASSERT_FALSE(program.linked());
    const Problems mapped = mapLog(program.fragmentLog(), source);
    ASSERT_FALSE(mapped.empty());
    EXPECT_EQ(mapped[0].file, "shaders/primitive/sphere.glsl") << program.fragmentLog();
    std::istringstream file{std::string(shaderText("primitive/sphere.glsl"))};
    std::string line;
    for (int i = 0; i < mapped[0].line; ++i) std::getline(file, line);
    EXPECT_NE(line.find(right), std::string::npos) << mapped[0].line;
}

TEST(CompileError, NamesFileAndLineOfTheLibraryInOsMesa) { namesThePlaceOfAFault(ContextKind::OsMesa); }
TEST(CompileError, NamesFileAndLineOfTheLibraryInEgl) { namesThePlaceOfAFault(ContextKind::Egl); }

TEST(CompileOnEgl, LinksEveryVariantOfLiteTorusAndSolids) {
    for (const char* scene : {"lite", "torus", "solids"}) compilesIn(ContextKind::Egl, variants(scene));
    offscreen(ContextKind::OsMesa);
}

TEST(Recompile, HappensForNoNumber) {
    offscreen();
    Drawing drawing(sceneNamed("torus"), [] {
        Settings settings;
        settings.size = {32, 24};
        return settings;
    }());
    const std::string before = drawing.renderer().source();
    Settings settings;
    settings.size = {40, 30};
    settings.depth = 8;
    settings.colorMode = 0;
    settings.time = 9;
    settings.threshold = 0.1;
    drawing.renderer().configure(settings);
    Problems problems;
    EXPECT_TRUE(drawing.renderer().poll(problems).ready()) << "at once: nothing was compiled";
    EXPECT_EQ(drawing.renderer().source(), before);
}

TEST(Recompile, KeepsTheOldProgramDrawingUntilTheNewOneIsReady) {
    offscreen();
    Settings settings;
    settings.size = {32, 24};
    Drawing drawing(sceneNamed("torus"), settings);
    const std::string old = drawing.renderer().source();
    settings.shadows = ShadowModel::Off;
    drawing.renderer().configure(settings);
    EXPECT_TRUE(drawing.renderer().canDraw());
    EXPECT_EQ(drawing.renderer().source(), old);
    Problems problems;
    EXPECT_TRUE(drawing.renderer().finish(problems));
    EXPECT_NE(drawing.renderer().source(), old);
}

} // namespace
} // namespace gnomon
