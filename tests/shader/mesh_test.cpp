/// Meshes on the GPU: normals between the corners, and images by the corners' coordinates.
#include "tests/support/oracle_pictures.h"
#include "tests/support/scenes.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

using namespace test;

Scene sceneWith(const std::string& obj, const std::string& material, const std::string& object) {
    Problems problems;
    const auto scene = readScene(R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "fov": 30},
        "lights": [{"point": {"position": [2, 3, 8]}}], "materials": {"m": )" +
                                     material + R"(},
        "objects": [{)" + object + R"(, "material": "m"}]})",
                                 "f", problems, [&](const std::string&, Problems&) { return std::optional(obj); });
    EXPECT_EQ(toString(problems), "");
    return scene.value_or(Scene{});
}

const std::string kMesh = R"("mesh": {"file": "a.obj"})";

TEST(SmoothTriangle, IsLitByTheNormalBetweenItsCorners) {
    const glm::dvec3 vertices[] = {{-1, -1, 0}, {1, -0.8, 0.2}, {0.1, 1, -0.3}};
    const glm::dvec3 normals[] = {{-0.6, 0, 0.8}, {0.48, -0.36, 0.8}, {0, 0.6, 0.8}};
    const Scene scene =
        sceneWith("v -1 -1 0\nv 1 -0.8 0.2\nv 0.1 1 -0.3\nvn -0.6 0 0.8\nvn 0.48 -0.36 0.8\nvn 0 0.6 0.8\n"
                  "f 1//1 2//2 3//3\n",
                  R"({"diffuse": 1})", kMesh);
    const FloatImage color = outputOf(scene, sized(80, 60), Aov::Color),
                     position = outputOf(scene, sized(80, 60), Aov::Position),
                     object = outputOf(scene, sized(80, 60), Aov::Object);
    const glm::dvec3 ab = vertices[1] - vertices[0], ac = vertices[2] - vertices[0], across = glm::cross(ab, ac);
    int seen = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            if (*object.at(x, y) < 0) continue;
            ++seen;
            const glm::dvec3 p(position.at(x, y)[0], position.at(x, y)[1], position.at(x, y)[2]), off = p - vertices[0];
            const double b = glm::dot(glm::cross(off, ac), across) / glm::dot(across, across),
                         c = glm::dot(glm::cross(ab, off), across) / glm::dot(across, across);
            const glm::dvec3 normal = glm::normalize((1 - b - c) * normals[0] + b * normals[1] + c * normals[2]);
            const double expected = glm::dot(normal, glm::normalize(glm::dvec3(2, 3, 8) - p));
            ASSERT_NEAR(*color.at(x, y), expected, 8 * 0x1p-23) << x << ' ' << y;
        }
    EXPECT_GT(seen, 500);
}

TEST(SmoothTriangle, ShowsAnImageByTheCoordinatesOfItsCorners) {
    const std::string obj =
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    const std::string material =
        R"({"ambient": 1, "texture": "earth-color", "normal_map": "earth-normal", "diffuse": 1})";
    const FloatImage mesh = outputOf(sceneWith(obj, material, kMesh), sized(80, 60), Aov::Color),
                     box = outputOf(sceneWith(obj, material, R"("box": {"center": [0, 0, -0.5],
                         "half_size": [1, 1, 0.5]})"),
                                    sized(80, 60), Aov::Color);
    float worst = 0;
    for (std::size_t i = 0; i < mesh.pixels.size(); ++i)
        worst = std::max(worst, std::abs(mesh.pixels[i] - box.pixels[i]));
    EXPECT_LE(worst, 2e-3f) << "as the face of a box that shows the whole image";
}

// A plain triangle and one of a mesh in one scene share the middle that rays are re-centred on.
TEST(SmoothTriangle, StandsBesideAPlainOne) {
    const Scene scene = sceneFrom(R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "fov": 30}, "objects": [
        {"triangle": {"vertices": [[-1, -1, 0], [1, -1, 0], [0, 1, 0]]}}]})");
    Scene both = scene;
    Object& smooth = both.objects.emplace_back(scene.objects[0]);
    smooth.shape = makeShape(ShapeKind::SmoothTriangle, {{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}});
    smooth.shape.corners = std::make_shared<const Corners>(Corners{{{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}}, {}});
    const FloatImage front = outputOf(both, sized(40, 30), Aov::Object),
                     alone = outputOf(scene, sized(40, 30), Aov::Object);
    for (std::size_t i = 0; i < alone.pixels.size(); ++i)
        if (alone.pixels[i] == 0) {
            ASSERT_EQ(front.pixels[i], 0);
        }
    std::swap(both.objects[0], both.objects[1]);
    EXPECT_NE(outputOf(both, sized(40, 30), Aov::Object).pixels, front.pixels);
}

} // namespace
} // namespace gnomon
