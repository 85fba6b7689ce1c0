// One cause gives one message, and a file that is wrong everywhere is answered at once.
#include "tracer/scene/read_scene.h"
#include "tracer/settings/settings.h"

#include <gtest/gtest.h>

#include <chrono>

namespace gnomon {
namespace {

Problems problemsOf(const std::string& text) {
    Problems problems;
    EXPECT_FALSE(readScene(text, "f", problems));
    return problems;
}

std::string sphere(const std::string& more) {
    return R"({"sphere": {"center": [0, 0, 0], "radius": 1}, )" + more + "}";
}

/// `count` times what `one` makes of a number, with commas.
template<class Text>
std::string repeated(int count, Text one) {
    std::string text;
    for (int i = 0; i < count; ++i) text += (i ? "," : "") + one(std::to_string(i));
    return text;
}

/// Far more than it takes where the work is bounded, on a busy machine; far less than where not. Sanitizers, and the
/// counters of libFuzzer, slow it down by ten.
#ifdef GNOMON_SANITIZED
constexpr double kMostSeconds = 40;
#else
constexpr double kMostSeconds = 5;
#endif

void expectQuick(const std::string& text) {
    const auto start = std::chrono::steady_clock::now();
    const Problems problems = problemsOf(text);
    EXPECT_EQ(problems.size(), kMostProblems);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), kMostSeconds);
}

TEST(OneCause, OfTooManyMaterialsIsTheLimitAlone) {
    const auto named = [](const std::string& i) { return "\"m" + i + R"(": {"diffuse": 0.5})"; };
    const auto of = [](const std::string& i) { return sphere("\"material\": \"m" + i + "\""); };
    const Problems problems =
        problemsOf("{\"materials\": {" + repeated(1000, named) + "}, \"objects\": [" + repeated(1000, of) + "]}");
    EXPECT_EQ(toString(problems), "f:1: materials: 1000 entries; use 0 to 256 entries\n");
}

TEST(OneCause, OfMaterialsThatAreNoneOrMisspeltIsThatAlone) {
    const std::string objects =
        "\"objects\": [" + repeated(9, [](const auto& i) { return sphere("\"material\": \"m" + i + "\""); }) + "]}";
    EXPECT_EQ(problemsOf("{\"materials\": [], " + objects).size(), 1U);
    EXPECT_EQ(problemsOf("{\"material\": {\"m0\": {}}, " + objects).size(), 1U);
    EXPECT_EQ(problemsOf("{" + objects).size(), 9U) << "nine names that nothing defines";
}

TEST(OneCause, OfDefinitionsIsThatAlone) {
    const auto of = [](const std::string& i) { return R"({"instance": {"of": "d)" + i + "\"}}"; };
    const auto named = [](const std::string& i) { return "\"d" + i + "\": " + sphere("\"casts_shadow\": true"); };
    const std::string objects = "\"objects\": [" + repeated(300, of) + "]}";
    EXPECT_EQ(toString(problemsOf("{\"definitions\": {" + repeated(300, named) + "}, " + objects)),
              "f:1: definitions: 300 entries; use 0 to 256 entries\n");
    EXPECT_EQ(problemsOf("{\"definitions\": 5, " + objects).size(), 1U);
    EXPECT_EQ(problemsOf("{\"definition\": {" + repeated(9, named) + "}, " + objects).size(), 1U);
}

TEST(OneCause, OfANameThatNothingDefinesIsToldOnce) {
    const auto red = [](const std::string&) { return sphere("\"material\": \"rde\""); };
    const Problems problems = problemsOf("{\"materials\": {\"red\": {}}, \"objects\": [" + repeated(3, red) + "]}");
    EXPECT_EQ(toString(problems),
              "f:1: objects[0].material: unknown material \"rde\", here and in 2 other objects; did "
              "you mean \"red\"?\n");
    const auto around = [](const std::string&) { return sphere(R"("motion": {"orbit": {"around": "nothing"}})"); };
    EXPECT_EQ(problemsOf("{\"objects\": [" + repeated(2, around) + "]}").size(), 1U);
}

TEST(Floods, OfDuplicateKeysAreAnsweredAtOnce) {
    expectQuick("{" + repeated(800000, [](const std::string&) { return std::string("\"\":0"); }) + "}");
}

TEST(Floods, OfLongNamesThatAreNearlyRightAreAnsweredAtOnce) {
    const std::string stem(52, 'n');
    const auto named = [&](const std::string& i) { return sphere("\"name\": \"" + stem + i + "\""); };
    const auto moving = [&](const std::string& i) {
        return sphere("\"motion\": {\"orbit\": {\"around\": \"" + stem + "x" + i + "\"}}");
    };
    expectQuick("{\"objects\": [" + repeated(19800, named) + "," + repeated(200, moving) + "]}");
}

TEST(Floods, OfWrongValuesAreAnsweredAtOnce) {
    expectQuick("{\"objects\": [" + repeated(20000, [](const std::string&) { return std::string("0"); }) + "]}");
    expectQuick("{\"objects\": [" + repeated(20000, [](const std::string& i) { return sphere("\"k" + i + "\": 0"); }) +
                "]}");
}

TEST(DecimalCommas, AreNamed) {
    EXPECT_EQ(toString(problemsOf("{\"objects\": [{\"sphere\": {\"center\": [0, 0, 0], \"radius\": 0,8}}]}")),
              "f:1: \"0,8\" is not a number that JSON knows; write a decimal point, as 0.8\n");
    EXPECT_EQ(toString(problemsOf("{\"objects\": [{\"sphere\": {\"center\": [0,5, 1, 0], \"radius\": 1}}]}")),
              "f:1: objects[0].sphere.center: expected a list of 3 numbers, found 4 entries; write [x, y, z], decimals "
              "with a point\n");
    Settings settings;
    Problems problems;
    EXPECT_FALSE(setFromText(settings, "fov", "36,9", "command line", problems));
    EXPECT_EQ(toString(problems), "command line: fov: '36,9' is not a number; write a decimal point, as 0.8\n");
}

} // namespace
} // namespace gnomon
