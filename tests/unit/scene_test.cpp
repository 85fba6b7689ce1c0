// Reading scene files: every bad file gets each of its problems, with its line; what is right moves as it says.
#include "tests/support/scenes.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <random>

namespace gnomon {
namespace {

using namespace test;

const std::string kScenes = std::string(GNOMON_SOURCE_DIR) + "/assets/scenes/";
const std::string kBadScenes = std::string(GNOMON_SOURCE_DIR) + "/tests/unit/bad_scenes/";

std::string problemsOf(const std::string& text) {
    Problems problems;
    const auto scene = readScene(text, "f", problems);
    EXPECT_EQ(scene.has_value(), problems.empty());
    return toString(problems);
}

/// A scene of the given objects that must be right.
Scene sceneOf(const std::string& objects) {
    Problems problems;
    auto scene = readScene("{\"objects\": [" + objects + "]}", "f", problems);
    EXPECT_TRUE(scene) << toString(problems);
    return scene.value_or(Scene{});
}

// ---- reading

TEST(ReadScene, GivesUnnamedMaterialsAPlainGrey) {
    const Scene scene = sceneOf(R"({"sphere": {"center": [1, 2, 3], "radius": 4}})");
    const Material& grey = scene.materials[std::size_t(scene.objects[0].material)];
    EXPECT_EQ(grey.diffuse, glm::dvec3(0.5));
    EXPECT_EQ(grey.ambient, glm::dvec3(0.1));
}

TEST(ReadScene, NormalisesDirectionsHoweverShort) {
    const Scene scene = sceneOf(R"({"plane": {"point": [0, 1, 0], "normal": [0, 3e-200, 4e-200]}})");
    expectNear(pointOf(scene.objects[0].shape, "normal"), {0, 0.6, 0.8}, 1e-12, "normal");
}

TEST(ReadScene, TakesOneNumberForAllChannelsAndBothTextureAxes) {
    Problems problems;
    const auto scene = readScene(
        R"({"materials": {"m": {"diffuse": 0.25, "texture": {"image": "grid", "scale": 3}, "normal_map": "bumps"}},
        "objects": [{"disc": {"center": [0, 0, 0], "normal": [0, 1, 0], "radius": 1}, "material": "m"}]})",
        "f", problems);
    ASSERT_TRUE(scene) << toString(problems);
    const Material& material = scene->materials[1];
    EXPECT_EQ(material.diffuse, glm::dvec3(0.25));
    EXPECT_EQ(material.texture.value().scale, glm::dvec2(3));
    EXPECT_EQ(material.normalMap.value().image, "bumps");
}

TEST(ReadScene, RemembersTheLineOfEachObject) {
    const Scene scene = sceneOf("\n{\"sphere\": {\"center\": [0, 0, 0], \"radius\": 1}},\n\n"
                                "{\"sphere\": {\"center\": [0, 0, 0], \"radius\": 1}}");
    EXPECT_EQ(scene.objects[0].line, 2);
    EXPECT_EQ(scene.objects[1].line, 4);
}

TEST(ReadScene, AcceptsCommentsAByteOrderMarkAndWindowsLineEnds) {
    EXPECT_EQ(problemsOf("\xEF\xBB\xBF// one\r\n{ /* two\r\n */ \"objects\":\r\n"
                         "[{\"sphere\": {\"center\": [0, 0, 0], \"radius\": 1}}]}\r\n"),
              "");
}

TEST(ReadScene, CountsLinesWithWindowsLineEnds) {
    EXPECT_EQ(problemsOf("{\r\n\"objects\": [{\r\n\"sphere\": {\"center\": [0, 0, 0], \"radius\":\r\n-1\r\n}}]}"),
              "f:4: objects[0].sphere.radius: -1 is outside the limits; use a number from 1e-06 to 1000000\n");
}

TEST(ReadScene, AcceptsTheLimitsThemselves) {
    EXPECT_EQ(problemsOf(R"({"camera": {"eye": [1e6, -1e6, 0], "fov": 170},
        "objects": [{"sphere": {"center": [0, 0, 1000000], "radius": 1e6}}, {"sphere": {"center": [0, 0, 0],
            "radius": 1e-6}}]})"),
              "");
}

TEST(ReadScene, RefusesAnEmptyText) {
    EXPECT_EQ(problemsOf(""), "f:1: the file is empty; write a scene: {\"objects\": [ ... ]}\n");
}

TEST(ReadScene, RefusesAZeroByteInsteadOfStoppingThere) {
    EXPECT_EQ(problemsOf(std::string("{\n\0}", 4)),
              "f:2: the file holds a zero byte: it is not a text file; save it as UTF-8\n");
}

TEST(ReadScene, RefusesBrokenUtf8) {
    EXPECT_EQ(problemsOf("{\n\"title\": \"\xff\"}"), "f:2: a string is not valid UTF-8; save the file as UTF-8\n");
}

TEST(ReadScene, RefusesAFileThatIsTooLarge) {
    EXPECT_EQ(problemsOf(std::string((16 << 20) + 1, ' ')),
              "f: the file has 16777217 bytes; at most 16777216 are read; use a smaller scene\n");
}

TEST(ReadScene, SurvivesAFileOfBrackets) {
    EXPECT_EQ(problemsOf(std::string(16 << 20, '[')),
              "f:1: lists and objects are nested deeper than 64 levels; remove brackets that are too many\n");
}

TEST(ReadScene, RefusesTooManyValues) {
    std::string text = "[";
    for (int i = 0; i < 2000001; ++i) text += "0,";
    EXPECT_EQ(problemsOf(text + "0]"), "f:1: the file holds more than 2000000 values; use a smaller scene\n");
}

TEST(ReadScene, RefusesTooManyObjects) {
    std::string text = "{\"objects\": [";
    for (int i = 0; i < 80001; ++i) text += std::string(i ? "," : "") + R"({"sphere":{"center":[0,0,0],"radius":1}})";
    EXPECT_EQ(problemsOf(text + "]}"), "f:1: objects: 80001 entries; use 1 to 80000 entries\n");
}

// As a program writes them: 5.6 MiB.
TEST(ReadScene, TakesAsManyObjectsAsItAdmits) {
    std::string text = "{\"objects\": [";
    for (int i = 0; i < 80000; ++i)
        text += std::string(i ? "," : "") +
                R"({"sphere": {"center": [-0.4330127, 0.5773503, 0.8164966], "radius": 0.0123457}})";
    EXPECT_EQ(problemsOf(text + "]}"), "");
}

TEST(ReadScene, StaysQuickWhereEverythingIsWrong) {
    std::string text = "{\"objects\": [";
    for (int i = 0; i < 20000; ++i)
        text += std::string(i ? "," : "") + R"({"name":"n)" + std::to_string(i) +
                R"(","sphere":{"center":[0,0,0],"radius":1},)" + R"("motion":{"orbit":{"around":"m)" +
                std::to_string(i) + R"("}}})";
    Problems problems;
    EXPECT_FALSE(readScene(text + "]}", "f", problems));
    ASSERT_EQ(problems.size(), kMostProblems);
    EXPECT_EQ(problems.back().what, "and 19981 more problems");
}

// ---- bad files

struct Expected {
    int line;
    std::string text;
};

/// Each `//! LINE: TEXT` in the file promises one problem at that line whose message holds the text.
std::vector<Expected> promisesIn(const std::string& text) {
    std::vector<Expected> all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("//! ", 0) != 0) continue;
        const std::size_t colon = line.find(": ");
        all.push_back({std::stoi(line.substr(4)), line.substr(colon + 2)});
    }
    return all;
}

std::vector<std::string> badScenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kBadScenes))
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class BadScene : public testing::TestWithParam<std::string> {};

TEST_P(BadScene, GetsExactlyItsProblemsWithTheirLines) {
    const std::string file = kBadScenes + GetParam() + ".json", text = textOf(file);
    Problems problems;
    EXPECT_FALSE(readScene(text, file, problems)) << "nothing is drawn from a bad file";
    const std::vector<Expected> promises = promisesIn(text);
    EXPECT_FALSE(promises.empty());
    for (const Expected& promise : promises) {
        const auto found = std::find_if(problems.begin(), problems.end(), [&](const Problem& problem) {
            return problem.line == promise.line && toString(problem).find(promise.text) != std::string::npos;
        });
        if (found == problems.end())
            ADD_FAILURE() << "missing: line " << promise.line << ": " << promise.text;
        else
            problems.erase(found);
    }
    EXPECT_EQ(toString(problems), "") << "not expected";
}

INSTANTIATE_TEST_SUITE_P(Files, BadScene, testing::ValuesIn(badScenes()), [](const auto& test) { return test.param; });

TEST(BadScenes, AreAtLeastFortyFive) { EXPECT_GE(badScenes().size(), 45u); }

TEST(BadScenes, WithFiveDifferentProblemsGetAllFive) {
    const std::string file = kBadScenes + "five_problems.json";
    Problems problems;
    readScene(textOf(file), file, problems);
    EXPECT_EQ(problems.size(), 5u) << toString(problems);
}

/// Either a scene or problems, never neither, and every problem inside the file.
void expectAnAnswer(const std::string& text) {
    Problems problems;
    const auto scene = readScene(text, "mutant.json", problems);
    ASSERT_EQ(scene.has_value(), problems.empty()) << text;
    const int lines = 1 + int(std::count(text.begin(), text.end(), '\n'));
    for (const Problem& problem : problems)
        ASSERT_TRUE(problem.line <= lines && !problem.what.empty()) << toString(problem);
    if (scene) shapesAt(*scene, 1.5);
}

TEST(MutatedScenes, AreAnsweredWhateverTheirBytes) {
    const std::string original = textOf(kScenes + "lite.json");
    const std::string spice = "{}[]\",:0123456789.-+eE/*\\ntfau\n \xff\x80";
    std::mt19937 random(20240229); // its sequence is the same everywhere; the distributions' are not
    for (int round = 0; round < 4000; ++round) {
        std::string text = original;
        for (unsigned changes = 1 + random() % 4; changes > 0; --changes) {
            const std::size_t at = random() % text.size();
            switch (random() % 5) {
            case 0: text[at] = char(random()); break;
            case 1: text[at] = spice[random() % spice.size()]; break;
            case 2: text.erase(at, 1 + random() % 20); break;
            case 3: text.insert(at, 1, spice[random() % spice.size()]); break;
            default: text.insert(at, text.substr(random() % text.size(), 1 + random() % 40)); break;
            }
        }
        expectAnAnswer(text);
    }
}

TEST(MutatedScenes, AreAnsweredWhereverTheyEnd) {
    const std::string original = textOf(kScenes + "torus.json");
    for (std::size_t end = 0; end <= original.size(); ++end) expectAnAnswer(original.substr(0, end));
}

// ---- motion

TEST(ShapesAt, FollowsCentresThatTheFileNamesLater) {
    const std::string sphere = R"("sphere": {"center": [1, 0, 0], "radius": 1})";
    const Scene scene =
        sceneOf("{\"name\": \"c\", " + sphere + R"(, "motion": {"orbit": {"cos": [0, 3, 0], "around": "b"}}},)" +
                "{\"name\": \"b\", " + sphere + R"(, "motion": {"orbit": {"sin": [0, 2, 0], "around": "a"}}},)" +
                "{\"name\": \"a\", " + sphere + R"(, "motion": {"orbit": {"cos": [0, 0, 5], "rate": 2}}})");
    const double t = 0.7;
    expectNear(pointOf(shapesAt(scene, t)[0], "center"), {3, 3 * std::cos(t) + 2 * std::sin(t), 5 * std::cos(2 * t)},
               1e-12, "c");
}

TEST(ShapesAt, MovesAroundTheReferencePointOfAnyShape) {
    const Scene scene = sceneOf(R"({"name": "t", "triangle": {"vertices": [[1, 2, 3], [2, 2, 3], [1, 3, 3]]}},
                                   {"sphere": {"center": [0, 0, 1], "radius": 1},
                                       "motion": {"orbit": {"around": "t"}}})");
    EXPECT_EQ(pointOf(shapesAt(scene, 9)[1], "center"), glm::dvec3(1, 2, 4));
}

TEST(ShapesAt, WalksLongChainsWithoutRecursion) {
    Scene scene;
    const int count = 200000;
    for (int i = 0; i < count; ++i) {
        Object object;
        object.shape.values = {1, 0, 0, 1};
        if (i + 1 < count) object.motion = Orbit{{}, {}, 1, i + 1};
        scene.objects.push_back(object);
    }
    EXPECT_EQ(pointOf(shapesAt(scene, 0)[0], "center").x, count);
}

TEST(ShapesAt, EndsOnACircle) {
    Scene scene;
    scene.objects.resize(2);
    scene.objects[0].motion = Orbit{{}, {}, 1, 1};
    scene.objects[1].motion = Orbit{{}, {}, 1, 0};
    EXPECT_EQ(shapesAt(scene, 0).size(), 2u);
}

} // namespace
} // namespace gnomon
