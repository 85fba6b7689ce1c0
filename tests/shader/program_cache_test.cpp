/// What a changed setting costs: nothing where it is a uniform, and no program twice.
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/plan/prepared_scene.h"
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
