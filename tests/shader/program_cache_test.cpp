/// What a changed setting costs: nothing where it is a uniform, and no program twice.
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/plan/prepared_scene.h"
#include "tracer/shader/program_cache.h"
#include "tracer/shader/shader_builder.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

using namespace test;

Settings small() {
    Settings settings;
    settings.size = {16, 12};
    return settings;
}

void configure(Drawing& drawing, const Settings& settings) {
    Problems problems;
    drawing.renderer().configure(settings);
    EXPECT_TRUE(drawing.renderer().finish(problems));
    EXPECT_EQ(toString(problems), "");
}

TEST(ProgramCache, GeneratesNoSourceWhereOnlyUniformsChange) {
    offscreen();
    Settings settings = small();
    Drawing drawing(sceneNamed("pro"), settings);
    drawing.picture();
    const int sources = builtShaders(), scenes = preparedScenes();
    for (int i = 0; i < 100; ++i) {
        settings.depth = 1 + i % 8;
        settings.threshold = 0.001 * i;
        settings.epsilon = 0.01 + 0.001 * i;
        settings.colorMode = i % 27;
        settings.time = i;
        settings.eye = glm::dvec3(0, i, 40);
        configure(drawing, settings);
    }
    drawing.picture();
    EXPECT_EQ(builtShaders(), sources);
    EXPECT_EQ(preparedScenes(), scenes);
}

TEST(ProgramCache, GeneratesTheSourceOfAPlanOnce) {
    offscreen();
    Settings settings = small(), off = small();
    off.shadows = ShadowModel::Off;
    Drawing drawing(sceneNamed("lite"), settings);
    configure(drawing, off);
    const int sources = builtShaders();
    for (int i = 0; i < 20; ++i) configure(drawing, i % 2 ? off : settings);
    EXPECT_EQ(builtShaders(), sources);
}

// Whoever draws one new sort of scene after another holds so many programs and no more.
TEST(ProgramCache, ForgetsWhatWasAskedForLongestAgo) {
    offscreen();
    ProgramCache cache(false);
    const int objects = gl::liveObjects();
    const auto ask = [&](int spheres) {
        std::string list;
        for (int i = 0; i < spheres; ++i)
            list += std::string(i ? "," : "") + R"({"sphere": {"center": [0, 0, 0], "radius": 1}})";
        Problems problems;
        Settings settings = small();
        settings.accel = Accel::None;
        const PreparedScenePtr scene = prepare(sceneFrom(R"({"objects": [)" + list + "]}"));
        const auto program = cache.get(planOf(*scene, settings, {}), problems);
        EXPECT_EQ(toString(problems), "");
        return program;
    };
    const int most = int(ProgramCache::kMostKept);
    const std::shared_ptr<CachedProgram> drawn = ask(1);
    for (int spheres = 2; spheres <= most + 20; ++spheres) ask(spheres);
    EXPECT_EQ(gl::liveObjects(), objects + 3 * (most + 1)) << "a program has two shaders";
    const int sources = builtShaders();
    ask(most + 20);
    EXPECT_EQ(ask(1)->program.get(), drawn->program.get()) << "what somebody draws with is not made anew";
    EXPECT_EQ(builtShaders(), sources);
    ask(2);
    EXPECT_EQ(builtShaders(), sources + 1);
}

TEST(ProgramCache, PreparesASceneOnce) {
    offscreen();
    const int scenes = preparedScenes();
    Drawing drawing(sceneNamed("pro"), small());
    drawing.output();
    drawing.picture();
    EXPECT_EQ(preparedScenes(), scenes + 1);
}

} // namespace
} // namespace gnomon
