#include "tests/support/scenes.h"

#include "native/file/asset_folder.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace gnomon::test {

Scene sceneNamed(const std::string& name) {
    Problems problems;
    const auto scene = AssetFolder(std::string(GNOMON_SOURCE_DIR) + "/assets").readScene(name, problems);
    EXPECT_EQ(toString(problems), "");
    return scene.value_or(Scene{});
}

Scene sceneFrom(const std::string& json) {
    Problems problems;
    const auto scene = readScene(json, "test", problems);
    EXPECT_EQ(toString(problems), "");
    return scene.value_or(Scene{});
}

Scene moved(Scene scene, glm::dvec3 by) {
    for (Object& object : scene.objects)
        // What moves around another object rests relative to it.
        if (!object.motion || object.motion->around < 0) object.shape = translated(object.shape, by);
    for (Light& light : scene.lights) light.position += by;
    scene.camera.eye += by;
    scene.camera.target += by;
    return scene;
}

std::string textOf(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    EXPECT_TRUE(stream) << file;
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

void expectNear(glm::dvec3 value, glm::dvec3 wanted, double tolerance, const std::string& what) {
    EXPECT_LE(glm::distance(value, wanted), tolerance)
        << what << ": " << value.x << ' ' << value.y << ' ' << value.z << " instead of " << wanted.x << ' ' << wanted.y
        << ' ' << wanted.z;
}

} // namespace gnomon::test
