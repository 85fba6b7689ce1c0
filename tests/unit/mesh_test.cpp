/// Meshes: what an OBJ file becomes, and what every bad one is told.
#include "tests/support/scenes.h"
#include "tracer/scene/read_scene.h"
#include "tracer/scene/scene_format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

using namespace test;

/// A file beside the scene.
SceneFiles holding(const std::string& text) {
    return [text](const std::string&, Problems&) { return std::optional(text); };
}

std::string problemsOfObjects(const std::string& objects, const std::string& file) {
    Problems problems;
    const auto scene = readScene("{\"objects\": [" + objects + "]}", "f", problems, holding(file));
    EXPECT_EQ(scene.has_value(), problems.empty());
    return toString(problems);
}

std::vector<Object> objectsOf(const std::string& objects, const std::string& file) {
    Problems problems;
    const auto scene = readScene("{\"objects\": [" + objects + "]}", "f", problems, holding(file));
    EXPECT_EQ(toString(problems), "");
    return scene.value_or(Scene{}).objects;
}

constexpr double kTight = 1e-12;

const std::string kMesh = R"({"mesh": {"file": "a.obj"}})";
const std::string kFlatMesh = R"({"mesh": {"file": "a.obj", "smooth": false}})";
const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Mesh, CutsPolygonsIntoTriangles) {
    const auto objects = objectsOf(kFlatMesh, kSquare + "f 1 2 3 4\n");
    ASSERT_EQ(objects.size(), 2u);
    for (const Object& object : objects) EXPECT_EQ(object.shape.kind, ShapeKind::Triangle);
}

double areaOf(const std::vector<Object>& objects) {
    double area = 0;
    for (const Object& object : objects)
        area += 0.5 * glm::cross(vertexOf(object.shape, 1) - vertexOf(object.shape, 0),
                                 vertexOf(object.shape, 2) - vertexOf(object.shape, 0))
                          .z;
    return area;
}

TEST(Mesh, CutsHollowPolygonsWithinTheirOutline) {
    // An L, and a comb whose teeth a fan would bridge: triangles all face +z and have the polygon's area.
    EXPECT_NEAR(areaOf(objectsOf(kFlatMesh, "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 4 5 6 1 2 3\n")),
                3, kTight);
    EXPECT_NEAR(areaOf(objectsOf(kFlatMesh, "v 0 0 0\nv 5 0 0\nv 5 3 0\nv 4 3 0\nv 4 1 0\nv 3 1 0\nv 3 3 0\nv 2 3 0\n"
                                            "v 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n")),
                11, kTight);
}

TEST(Mesh, TakesIndicesFromEitherEndAndImageCoordinates) {
    const auto objects = objectsOf(kFlatMesh, kSquare + "vt 0.25 0.75\nvt 1 0\nvt 1 1\nf -4/1 -3/-2 -2/3\n");
    ASSERT_EQ(objects.at(0).shape.kind, ShapeKind::SmoothTriangle);
    const Corners& corners = *objects[0].shape.corners;
    EXPECT_EQ(corners.uv[0], glm::dvec2(0.25, 0.25)) << "v is told from the top";
    EXPECT_EQ(corners.uv[1], glm::dvec2(1, 1));
    EXPECT_EQ(corners.normals[0], glm::dvec3(0, 0, 1)) << "flat";
}

TEST(Mesh, SmoothesByTheFilesNormalsOrTheMeanOfTheFaces) {
    const auto told = objectsOf(kMesh, kSquare + "vn 0 3 4\nf 1//1 2//1 3//1\n");
    expectNear(told.at(0).shape.corners->normals[0], {0, 0.6, 0.8}, kTight, "the file's");
    const auto mean = objectsOf(kMesh, kSquare + "v 0 0 1\nf 1 2 3\nf 1 5 2\n");
    const glm::dvec3 expected =
        glm::normalize(glm::radians(45.0) * glm::dvec3(0, 0, 1) + glm::radians(90.0) * glm::dvec3(0, 1, 0));
    expectNear(mean.at(0).shape.corners->normals[0], expected, kTight, "by angles");
}

TEST(Mesh, TurnsFacesWhoseNormalsPointTheOtherWay) {
    const auto objects = objectsOf(kMesh, kSquare + "vn 0 0 -1\nf 1//1 2//1 3//1\n");
    const Shape& shape = objects.at(0).shape;
    EXPECT_LT(glm::cross(vertexOf(shape, 1) - vertexOf(shape, 0), vertexOf(shape, 2) - vertexOf(shape, 0)).z, 0);
}

TEST(Mesh, LeavesOutWhatIsNoTriangle) {
    EXPECT_EQ(objectsOf(kMesh, "# a\nmtllib a.mtl\no thing\ng one two\nusemtl red\ns 1\n" + kSquare +
                                   "l 1 2\np 1\nf 1 2 2\nf 1 \\\n 2 3 # end\r\n")
                  .size(),
              1u);
}

TEST(Mesh, TurnsItsNormalsWithItsGroup) {
    const auto objects = objectsOf(R"({"group": {"scale": [1, 2, 1], "of": [)" + kMesh + "]}}",
                                   kSquare + "vn 0 1 1\nf 1//1 2//1 3//1\n");
    expectNear(objects.at(0).shape.corners->normals[0], glm::normalize(glm::dvec3(0, 0.5, 1)), kTight, "normal");
}

TEST(Mesh, RefusesEveryBadFileWithItsLine) {
    const auto problem = [](const std::string& text) { return problemsOfObjects(kMesh, text); };
    const std::string at = "f:1: objects[0].mesh.file: a.obj";
    EXPECT_EQ(problem(""), at + " has no faces; use an OBJ file with lines that begin with f\n");
    EXPECT_EQ(problem(kSquare), at + " has no faces; use an OBJ file with lines that begin with f\n");
    EXPECT_EQ(problem(kSquare + "f 1 2 5\n"),
              at + ":5: a face names vertex 5, of which 4 stand before it; count from 1, or from -1 backwards\n");
    EXPECT_NE(problem(kSquare + "f 0 1 2\n").find("vertex 0"), std::string::npos);
    EXPECT_NE(problem(kSquare + "f -5 1 2\n").find("vertex -5"), std::string::npos);
    EXPECT_NE(problem(kSquare + "f 1/1 2/1 3/1\n").find("texture vertex 1"), std::string::npos);
    EXPECT_NE(problem(kSquare + "f 1//1 2//1 3//1\n").find("normal 1"), std::string::npos);
    EXPECT_NE(problem(kSquare + "f 1 2\n").find("a face of 2 corners"), std::string::npos);
    EXPECT_NE(problem(kSquare + "f 1 2 x\n").find("\"x\" is no index"), std::string::npos);
    EXPECT_NE(problem(kSquare + "f 1/1/1/1 2 3\n").find("is no corner of a face"), std::string::npos);
    EXPECT_NE(problem(kSquare + "f 99999999999 2 3\n").find("is no index"), std::string::npos);
    EXPECT_NE(problem("v 0 nan 0\n").find("\"nan\" is no number"), std::string::npos);
    EXPECT_NE(problem("v 0 inf 0\n").find("\"inf\" is no number"), std::string::npos);
    EXPECT_NE(problem("v 0 1e9 0\n").find("1e9 is outside the limits"), std::string::npos);
    EXPECT_NE(problem("v 0 1,5 0\n").find("\"1,5\" is no number"), std::string::npos);
    EXPECT_NE(problem("v 0 1\n").find("2 numbers instead of 3"), std::string::npos);
    EXPECT_NE(problem(kSquare + "f 1 2 2\n").find("none of its faces has an area"), std::string::npos);
    EXPECT_NE(problem("cstype bezier\n").find("free-form"), std::string::npos);
}

TEST(Mesh, OfTooManyTrianglesIsOneProblem) {
    std::string text = kSquare;
    for (int i = 0; i <= kMostObjects; ++i) text += "f 1 2 3\n";
    const std::string problems = problemsOfObjects(kMesh, text);
    EXPECT_NE(problems.find(std::to_string(kMostObjects + 1) + " triangles"), std::string::npos) << problems;
}

TEST(Mesh, IsReadFromTheScenesFolderOnly) {
    for (const char* path : {"../a.obj", "/a.obj", "b/../a.obj", "b//a.obj", "./a.obj", "a.obj/", "b\\\\a.obj"})
        EXPECT_NE(problemsOfObjects(R"({"mesh": {"file": ")" + std::string(path) + "\"}}", kSquare + "f 1 2 3\n")
                      .find("is not a file beside the scene"),
                  std::string::npos)
            << path;
    for (const char* path : {"b c/d-1.2/a.obj", "cube (1).obj", "h\u00fctte+dach.obj", ".a.obj"})
        EXPECT_EQ(problemsOfObjects(R"({"mesh": {"file": ")" + std::string(path) + "\"}}", kSquare + "f 1 2 3\n"), "")
            << path;
}

/// The lines of problems.
std::size_t linesOf(const std::string& text) { return std::size_t(std::count(text.begin(), text.end(), '\n')); }

TEST(Mesh, IsReadOnceHoweverOftenItIsNamed) {
    int reads = 0;
    const SceneFiles files = [&](const std::string&, Problems&) {
        ++reads;
        return std::optional(kSquare + "f 1 2 3\n");
    };
    Problems problems;
    const auto scene =
        readScene("{\"objects\": [" + kMesh + "," + kMesh + "," + kFlatMesh + "]}", "f", problems, files);
    ASSERT_TRUE(scene) << toString(problems);
    EXPECT_EQ(scene->objects.size(), 3U);
    EXPECT_EQ(scene->objects[0].shape.kind, scene->objects[1].shape.kind);
    EXPECT_EQ(scene->objects[2].shape.kind, ShapeKind::Triangle);
    EXPECT_EQ(reads, 2) << "smooth and flat";
    EXPECT_EQ(linesOf(problemsOfObjects(kMesh + "," + kMesh, "f 1 2 3\n")), 1U);
}

TEST(Mesh, IsNotReadWhereTheSceneIsFull) {
    std::string faces = kSquare;
    for (int i = 0; i < kMostObjects; ++i) faces += "f 1 2 3\n";
    int reads = 0;
    const SceneFiles files = [&](const std::string&, Problems&) {
        ++reads;
        return std::optional(faces);
    };
    Problems problems;
    const std::string text =
        "{\"objects\": [" + kMesh + R"(, {"mesh": {"file": "b.obj"}}, {"mesh": {"file": "c.obj"}}]})";
    EXPECT_FALSE(readScene(text, "f", problems, files));
    EXPECT_EQ(problems.size(), 1U) << toString(problems);
    EXPECT_EQ(reads, 2);
}

TEST(Mesh, IsReadAsAnySystemWritesIt) {
    const std::string file = kSquare + "f 1 2 \\\n3\n";
    const auto withEnds = [&](const char* end) {
        std::string text;
        for (const char c : file) text += c == '\n' ? end : std::string(1, c);
        return text;
    };
    for (const char* end : {"\n", "\r\n", "\r"}) EXPECT_EQ(objectsOf(kMesh, withEnds(end)).size(), 1U) << int(*end);
    EXPECT_EQ(objectsOf(kMesh, "\xef\xbb\xbf" + file).size(), 1U) << "a byte order mark";
    std::string wide;
    for (const char c : file) wide += std::string(1, c) + std::string(1, '\0');
    EXPECT_NE(problemsOfObjects(kMesh, "\xff\xfe" + wide).find("save it as plain text"), std::string::npos);
}

TEST(Mesh, ThatCannotBeReadIsNamed) {
    Problems problems;
    const SceneFiles none = [](const std::string&, Problems& found) {
        found.push_back({"", 0, {}, "is a folder", "name a file"});
        return std::optional<std::string>();
    };
    EXPECT_FALSE(readScene("{\"objects\": [" + kMesh + "]}", "f", problems, none));
    EXPECT_EQ(toString(problems), "f:1: objects[0].mesh.file: \"a.obj\": is a folder; name a file\n");
}

TEST(Mesh, ThatIsMissingIsAProblem) {
    Problems problems;
    const SceneFiles none = [](const std::string&, Problems&) { return std::optional<std::string>(); };
    EXPECT_FALSE(readScene("{\"objects\": [" + kMesh + "]}", "f", problems, none));
    EXPECT_EQ(toString(problems), "f:1: objects[0].mesh.file: \"a.obj\" is missing; put it beside the scene\n");
}

TEST(FilesOf, AreThoseOfMeshesEachOnce) {
    EXPECT_EQ(filesOf(R"({"definitions": {"d": {"mesh": {"file": "b.obj"}}}, "objects": [{"group": {"of": [)" + kMesh +
                      "," + kMesh + "]}}]}"),
              (std::vector<std::string>{"b.obj", "a.obj"}));
}

} // namespace
} // namespace gnomon
