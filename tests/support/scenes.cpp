#include "tests/support/scenes.h"

#include "native/asset_folder.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

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

} // namespace gnomon::test
