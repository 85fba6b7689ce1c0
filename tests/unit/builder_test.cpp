#include "tests/support/clouds.h"
#include "tests/support/scenes.h"
#include "tracer/shader/library.h"
#include "tracer/shader/shader_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace gnomon {
namespace {

using test::sceneFrom;
using test::sceneNamed;

Plan plan(const Scene& scene, const Settings& settings = {}) { return planOf(*prepare(scene), settings, {}); }

std::string source(const Scene& scene, const Settings& settings = {}) {
    Problems problems;
    const std::string text = buildShader("pass/trace.frag", plan(scene, settings), problems).text;
    EXPECT_EQ(toString(problems), "");
    return text;
}

bool mentions(std::string text, std::string word) {
    const auto lower = [](unsigned char c) { return char(std::tolower(c)); };
    std::ranges::transform(text, text.begin(), lower);
    std::ranges::transform(word, word.begin(), lower);
    return text.find(word) != std::string::npos;
}

TEST(ShaderBuilder, LeavesNoLineAboutToriInLite) { EXPECT_FALSE(mentions(source(sceneNamed("lite")), "torus")); }

TEST(ShaderBuilder, BringsToriIntoProAndTorus) {
    EXPECT_TRUE(mentions(source(sceneNamed("pro")), "intersectTorus"));
    EXPECT_TRUE(mentions(source(sceneNamed("torus")), "intersectTorus"));
}

TEST(ShaderBuilder, LeavesOutEveryShapeAndEffectThatASceneDoesNotUse) {
    const std::string text = source(sceneFrom(R"({"objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}}]})"));
    for (const char* word : {"plane", "disc", "triangle", "torus", "fresnel", "stack", "glow", "image",
                             "samplerCube sky", "normalMap >= 0", "occluded", "refract", "nextLeaf"})
        EXPECT_FALSE(mentions(text, word)) << word;
}

TEST(ShaderBuilder, BringsShadowCodeOnlyWithShadows) {
    Settings off;
    off.shadows = ShadowModel::Off;
    EXPECT_TRUE(mentions(source(sceneNamed("lite")), "occluded"));
    EXPECT_FALSE(mentions(source(sceneNamed("lite"), off), "occluded"));
}

/// As many spheres side by side, each `wider` farther from the last than that from its own, and a plane.
Scene row(int spheres, double wider = 0.01) {
    Scene scene = sceneFrom(R"({"objects": [{"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}},
                                            {"sphere": {"center": [0, 0, 0], "radius": 0.1}}]})");
    for (int i = 1; i < spheres; ++i) {
        scene.objects.push_back(scene.objects.back());
        scene.objects.back().shape.values[0] += 1 + i * wider;
    }
    return scene;
}

TEST(ShaderBuilder, WalksHierarchiesOnlyWhereTheyPayOrAreAskedFor) {
    Settings none, always;
    none.accel = Accel::None;
    always.accel = Accel::Hierarchy;
    EXPECT_FALSE(mentions(source(row(2)), "nextLeaf"));
    EXPECT_TRUE(mentions(source(row(2), always), "nextLeaf"));
    EXPECT_FALSE(mentions(source(row(1), always), "nextLeaf")) << "one has none";
    EXPECT_TRUE(mentions(source(row(200)), "nextLeaf"));
    EXPECT_FALSE(mentions(source(row(200), none), "nextLeaf"));
    EXPECT_FALSE(mentions(source(row(200), always), "planeGrid")) << "what has no end is asked by all rays";
}

TEST(ShaderBuilder, MasksAFewObjectsByTheirSpheres) {
    EXPECT_TRUE(mentions(source(row(6)), "ballSphere(objectSphere(kSphereLoose + 5))"));
    EXPECT_FALSE(mentions(source(row(6)), "kSphereLoose + 6)"));
    EXPECT_FALSE(mentions(source(row(1)), "kSphereLoose")) << "one is asked at once";
    EXPECT_FALSE(mentions(source(row(200)), "ballSphere(objectSphere(kSphereLoose"));
}

TEST(ShaderBuilder, WalksLatticesCellByCell) {
    Settings none, always;
    none.accel = Accel::None;
    always.accel = Accel::Hierarchy;
    EXPECT_TRUE(mentions(source(row(200, 0)), "kSphereLatticeX = 200"));
    EXPECT_FALSE(mentions(source(row(200, 0)), "nextLeaf"));
    EXPECT_FALSE(mentions(source(row(200)), "LatticeX")) << "uneven";
    EXPECT_FALSE(mentions(source(row(200, 0), none), "LatticeX"));
    EXPECT_FALSE(mentions(source(row(200, 0), always), "LatticeX"));
    EXPECT_TRUE(mentions(source(sceneNamed("pro")), "kSphereLatticeZ = 10"));
}

TEST(ShaderBuilder, GivesTheSameSourceWhenOnlyNumbersChange) {
    Scene moved = sceneNamed("lite");
    moved.objects[1].shape = translated(moved.objects[1].shape, glm::dvec3(1));
    moved.materials[1].diffuse *= 0.5;
    Settings settings;
    settings.depth = 2;
    settings.time = 12;
    settings.colorMode = 3;
    EXPECT_EQ(source(sceneNamed("lite")), source(moved, settings));
}

TEST(ShaderBuilder, KeepsARayStackOnlyWhereASurfaceBothReflectsAndRefracts) {
    EXPECT_EQ(source(sceneNamed("torus")).find("kRayStack"), std::string::npos);
    EXPECT_NE(source(sceneNamed("lite")).find("kRayStack"), std::string::npos);
}

TEST(ShaderBuilder, NeedsNoOtherProgramForAnotherDepth) {
    Settings shallow, deep;
    shallow.depth = 1;
    deep.depth = 8;
    EXPECT_EQ(source(sceneNamed("pro"), shallow), source(sceneNamed("pro"), deep));
}

TEST(ShaderBuilder, LeavesNoDirectiveAndNoCommentBehind) {
    const std::string text = source(sceneNamed("pro"));
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "#version 300 es");
    while (std::getline(lines, line)) {
        EXPECT_EQ(line.find('#'), std::string::npos) << line;
        EXPECT_EQ(line.find('$'), std::string::npos) << line;
        EXPECT_EQ(line.find("//"), std::string::npos) << line;
    }
}

TEST(ShaderBuilder, KnowsWhereEveryLineComesFrom) {
    Problems problems;
    const ShaderSource built = buildShader("pass/trace.frag", plan(sceneNamed("pro")), problems);
    std::istringstream lines(built.text);
    std::string line;
    std::size_t number = 0;
    for (; std::getline(lines, line); ++number) {
        const SourceLine& from = built.lines.at(number);
        if (from.file == "(generated)" || line.find("Sphere") == std::string::npos) continue;
        std::istringstream file{std::string(shaderText(from.file))};
        std::string original;
        for (int i = 0; i < from.line; ++i) ASSERT_TRUE(std::getline(file, original));
        // Names may be replaced in the original, even its first word, but else that word stands.
        const auto first = line.find_first_not_of(' '), same = first + (original.at(first) != '$');
        EXPECT_EQ(original.substr(0, same), line.substr(0, same)) << line;
    }
    EXPECT_EQ(number, built.lines.size());
}

TEST(ShaderBuilder, MapsTheLogsOfAllDriversToFilesAndLines) {
    Problems problems;
    const ShaderSource built = buildShader("pass/trace.frag", plan(sceneNamed("lite")), problems);
    const auto sphere = std::ranges::find(built.lines, std::string_view("primitive/sphere.glsl"), &SourceLine::file);
    const std::string number = std::to_string(sphere - built.lines.begin() + 1);
    for (const std::string& log :
         {"0:" + number + "(3): error: `x' undeclared", "ERROR: 0:" + number + ": 'x' : undeclared",
          "0(" + number + ") : error C1008: undefined variable"}) {
        const Problems mapped = mapLog(log, built);
        ASSERT_EQ(mapped.size(), 1u) << log;
        EXPECT_EQ(mapped[0].file, "shaders/primitive/sphere.glsl") << log;
        EXPECT_EQ(mapped[0].line, sphere->line) << log;
    }
}

TEST(ShaderBuilder, SaysWhichFileIsMissing) {
    Problems problems;
    buildShader("pass/nothing.frag", plan(sceneNamed("lite")), problems);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(toString(problems).find("pass/nothing.frag"), std::string::npos);
}

TEST(ShaderBuilder, TakesAnOverrideInPlaceOfTheLibrarysFile) {
    Problems problems;
    const ShaderFile overrides[] = {{"primitive/torus.glsl", "int inItsPlace;\n"}};
    const ShaderSource built = buildShader("pass/trace.frag", plan(sceneNamed("torus")), problems, overrides);
    EXPECT_EQ(toString(problems), "");
    EXPECT_NE(built.text.find("int inItsPlace;"), std::string::npos);
    EXPECT_EQ(built.text.find("struct Torus"), std::string::npos);
    EXPECT_NE(built.text.find("struct Sphere"), std::string::npos) << "other files stay the library's";
}

TEST(ShaderBuilder, RefusesAnOverrideOfAFileThatTheLibraryDoesNotHave) {
    Problems problems;
    const ShaderFile overrides[] = {{"primitive/tours.glsl", "int unused;\n"}};
    buildShader("pass/trace.frag", plan(sceneNamed("torus")), problems, overrides);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(toString(problems).find("primitive/tours.glsl"), std::string::npos);
}

TEST(ShaderLibrary, HoldsNoPrecisionBelowHighp) {
    for (const ShaderFile& file : shaderLibrary()) {
        EXPECT_EQ(file.text.find("mediump"), std::string_view::npos) << file.name;
        EXPECT_EQ(file.text.find("lowp"), std::string_view::npos) << file.name;
    }
}

TEST(ShaderLibrary, BeginsEveryFileWithWhatItIs) {
    for (const ShaderFile& file : shaderLibrary()) {
        std::ifstream text(GNOMON_SOURCE_DIR "/shaders/" + std::string(file.name));
        std::string line;
        EXPECT_TRUE(std::getline(text, line) && line.starts_with("// ")) << file.name;
    }
}

TEST(ShaderLibrary, CarriesNoCommentsButTheirLines) {
    for (const ShaderFile& file : shaderLibrary()) {
        EXPECT_EQ(file.text.find("//"), std::string_view::npos) << file.name;
        std::ifstream text(GNOMON_SOURCE_DIR "/shaders/" + std::string(file.name));
        const auto lines = std::count(std::istreambuf_iterator<char>(text), {}, '\n');
        EXPECT_EQ(std::count(file.text.begin(), file.text.end(), '\n'), lines) << file.name;
    }
}

} // namespace
} // namespace gnomon
