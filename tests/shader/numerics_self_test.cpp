// The numerics self-test on every GL at hand: it passes with the shaders as they stand, fails for every shortcut that a
// compiler could take in shaders/ray/split.glsl, and leaves the pictures that follow it unchanged.

#include "lab/batch/numerics_self_test.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace gnomon {
namespace {

using namespace test;

class NumericsSelfTestIn : public testing::TestWithParam<ContextKind> {};

TEST_P(NumericsSelfTestIn, HoldsWithTheShadersAsTheyStand) {
    offscreen(GetParam());
    const NumericsSelfTest selfTest = runNumericsSelfTest();
    std::printf("%s: %s (%.0f ms)\n", std::string(nameOf(GetParam())).c_str(), toString(selfTest).c_str(),
                selfTest.milliseconds);
    EXPECT_TRUE(selfTest.holds()) << toString(selfTest);
    EXPECT_EQ(selfTest.rays, 2048);
}

INSTANTIATE_TEST_SUITE_P(Contexts, NumericsSelfTestIn, testing::Values(ContextKind::OsMesa, ContextKind::Egl),
                         [](const auto& test) { return std::string(nameOf(test.param)); });

/// A line of split.glsl and what a compiler that takes float arithmetic for real numbers' could make of it.
struct Shortcut {
    const char* name;
    const char* line;
    const char* becomes;
};
std::ostream& operator<<(std::ostream& out, const Shortcut& shortcut) { return out << shortcut.name; }

constexpr const char* kClosest = "    vec3 closest = ((toOrigin + tHigh * high) + tHigh * low) + tLow * high;";
const Shortcut kShortcuts[] = {
    {"multipliesAtOnce", kClosest, "    vec3 closest = toOrigin + t * direction - tLow * low;"},
    {"joinsTheHalvesOfDirection", kClosest, "    vec3 closest = (toOrigin + tHigh * direction) + tLow * high;"},
    {"addsTheSmallPartsFirst", kClosest, "    vec3 closest = toOrigin + (tHigh * high + (tHigh * low + tLow * high));"},
    {"takesTheLowHalfForNothing", "    vec3 low = optimisationBarrier(direction - high);", "    vec3 low = vec3(0.0);"},
    {"takesTheDifferenceForExact", "    return (a - (difference - minusB)) - (b + minusB);", "    return vec3(0.0);"},
};

class ShortcutInSplit : public testing::TestWithParam<Shortcut> {};

TEST_P(ShortcutInSplit, FailsTheSelfTest) {
    offscreen();
    std::string split(shaderText("ray/split.glsl"));
    const std::size_t at = split.find(GetParam().line);
    ASSERT_NE(at, std::string::npos) << "split.glsl has no line `" << GetParam().line << "`";
    split.replace(at, std::string(GetParam().line).size(), GetParam().becomes);
    const ShaderFile overrides[] = {{"ray/split.glsl", split}};
    const NumericsSelfTest selfTest = runNumericsSelfTest(overrides);
    std::printf("%s: %s\n", GetParam().name, toString(selfTest).c_str());
    EXPECT_TRUE(selfTest.measured) << toString(selfTest);
    EXPECT_FALSE(selfTest.holds()) << toString(selfTest);
    EXPECT_GT(selfTest.wrong, 10);
}

INSTANTIATE_TEST_SUITE_P(Shortcuts, ShortcutInSplit, testing::ValuesIn(kShortcuts),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SelfTestAnswer, SaysWhyItIsNotMeasured) {
    offscreen();
    const ShaderFile overrides[] = {{"ray/split.glsl", "// nothing\n"}};
    const NumericsSelfTest selfTest = runNumericsSelfTest(overrides);
    EXPECT_FALSE(selfTest.measured);
    EXPECT_FALSE(selfTest.holds());
    EXPECT_NE(selfTest.problem, "");
}

TEST(SelfTestAnswer, LeavesThePicturesThatFollowUnchanged) {
    offscreen();
    for (const DataPath data : {DataPath::Block, DataPath::Texture}) {
        Settings settings;
        settings.size = {96, 72};
        settings.data = data;
        Drawing drawing(sceneNamed("pro"), settings);
        const Image before = drawing.picture();
        ASSERT_TRUE(runNumericsSelfTest().holds());
        EXPECT_EQ(drawing.picture().rgba, before.rgba);
        Problems problems;
        EXPECT_TRUE(gl::check("the numerics self-test", problems)) << toString(problems);
    }
}

} // namespace
} // namespace gnomon
