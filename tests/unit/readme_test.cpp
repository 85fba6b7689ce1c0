#include "tracer/settings/settings.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace gnomon {
namespace {

TEST(Readme, ShowsTheSettingsTableAsItIs) {
    std::ifstream file(std::string(GNOMON_SOURCE_DIR) + "/README.md");
    const std::string readme{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(readme.find(settingsMarkdown()), std::string::npos) << "put what `gnomon settings` prints into README.md";
}

} // namespace
} // namespace gnomon
