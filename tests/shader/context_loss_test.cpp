/// A lost context takes all GL objects along. What draws says so nowhere: objects know the context they belong to
/// (tracer/gl/generation.h).
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/gl/generation.h"
#include "tracer/gl/objects.h"

#include <gtest/gtest.h>

#include <optional>

namespace gnomon::test {
namespace {

/// Draws with images and in variants, so that every kind of object there is gets lost.
Settings everything() {
    Settings settings;
    settings.size = {16, 12};
    settings.depth = 2;
    return settings;
}

void expectAsBefore(Drawing& drawing, const Image& before, int objects, int losses) {
    Problems problems;
    drawing.renderer().contextRestored();
    ASSERT_TRUE(drawing.renderer().finish(problems)) << toString(problems) << losses << " losses";
    EXPECT_EQ(drawing.picture().rgba, before.rgba) << losses << " losses";
    EXPECT_EQ(gl::liveObjects(), objects) << losses << " losses";
}

TEST(ContextLoss, OfAWholeSceneBringsTheSamePictureWithAsManyObjects) {
    offscreen();
    Drawing drawing(sceneNamed("pro"), everything());
    const Image before = drawing.picture();
    const int objects = gl::liveObjects();
    for (int losses = 1; losses <= 5; ++losses) {
        renewContext();
        EXPECT_EQ(gl::liveObjects(), 0);
        EXPECT_FALSE(drawing.renderer().canDraw());
        expectAsBefore(drawing, before, objects, losses);
    }
}

// A scene of one sphere, so that a thousand of them take seconds.
TEST(ContextLoss, AThousandTimesInOneProcessLeavesNothingBehind) {
    offscreen();
    Settings settings = everything();
    settings.shadows = ShadowModel::Off;
    settings.variants = Variants::Off;
    Drawing drawing(sceneFrom(R"({"objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}}]})"), settings);
    const Image before = drawing.picture();
    const int objects = gl::liveObjects();
    for (int losses = 1; losses <= 1000; ++losses) {
        renewContext();
        ASSERT_NO_FATAL_FAILURE(expectAsBefore(drawing, before, objects, losses));
    }
}

// An object that outlives its context deletes nothing of the next one, though names are given again.
TEST(ContextLoss, LeavesObjectsOfTheNextContextAlone) {
    offscreen();
    renewContext(); // whose first name is that of the next one, too
    std::optional<gl::Buffer> old = gl::makeUniformBuffer();
    const GLuint name = old->get();
    EXPECT_TRUE(*old);
    renewContext();
    EXPECT_FALSE(*old);
    EXPECT_EQ(old->get(), 0U);
    const gl::Buffer next = gl::makeUniformBuffer();
    ASSERT_EQ(next.get(), name) << "else this test shows nothing";
    glBindBuffer(GL_UNIFORM_BUFFER, next.get());
    old.reset();
    EXPECT_EQ(glIsBuffer(next.get()), GL_TRUE);
    EXPECT_EQ(gl::liveObjects(), 1);
}

} // namespace
} // namespace gnomon::test
