/// Pictures of the scenes against committed references. The last line of defence: it says that something changed.
///
/// Tolerance: 99.8 % of the pixels within 3/255 in every channel, mean difference at most 0.25/255. The references were
/// drawn by Mesa's llvmpipe; another processor's vector width may round the last bit of a ray otherwise and flip a
/// mirror's edge. `scripts/test image --accept` writes the references anew; look at them before committing.

#include "native/file/image_file.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <ostream>

namespace gnomon {
namespace {

using namespace test;

struct Case {
    const char* name;
    const char* scene;
    int depth;
    ShadowModel shadows;
    double time;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

const Case kCases[] = {
    {"lite", "lite", 8, ShadowModel::Hard, 0},           {"lite-no-shadows", "lite", 4, ShadowModel::Off, 0},
    {"lite-later", "lite", 4, ShadowModel::Hard, 4.25},  {"pro", "pro", 8, ShadowModel::Hard, 0},
    {"torus", "torus", 4, ShadowModel::Hard, 0},         {"shapes", "shapes", 8, ShadowModel::Hard, 0},
    {"solids", "solids", 8, ShadowModel::ConeLinear, 0}, {"complex", "complex", 1, ShadowModel::Silhouette, 0},
    {"teapot", "teapot", 4, ShadowModel::Hard, 0},       {"goblet", "goblet", 4, ShadowModel::Hard, 0},
    {"patches", "patches", 4, ShadowModel::Hard, 0},
};

Image readPng(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    Problems problems;
    const auto image = decodeImage(file, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, problems);
    EXPECT_EQ(toString(problems), "");
    return image.value_or(Image{});
}

void compare(const Image& got, const Image& wanted) {
    ASSERT_EQ(got.width, wanted.width);
    ASSERT_EQ(got.height, wanted.height);
    double sum = 0;
    int off = 0;
    const int pixels = got.width * got.height;
    for (int i = 0; i < pixels; ++i) {
        int worst = 0;
        for (int c = 0; c < 3; ++c) {
            const int difference = std::abs(int(got.rgba[i * 4 + c]) - int(wanted.rgba[i * 4 + c]));
            worst = std::max(worst, difference);
            sum += difference;
        }
        off += worst > 3;
    }
    EXPECT_LE(off, pixels / 500);
    EXPECT_LE(sum / (3.0 * pixels), 0.25);
}

class Reference : public testing::TestWithParam<Case> {};

TEST_P(Reference, IsDrawn) {
    const Case& c = GetParam();
    Settings settings;
    settings.size = {320, 240};
    settings.depth = c.depth;
    settings.shadows = c.shadows;
    settings.time = c.time;
    offscreen();
    const Image got = Drawing(sceneNamed(c.scene), settings).picture();
    const std::string file = std::string(GNOMON_SOURCE_DIR) + "/tests/image/references/" + c.name + ".png";
    if (std::getenv("GNOMON_ACCEPT_REFERENCES")) {
        Problems problems;
        ASSERT_TRUE(writeImage(file, got, problems)) << toString(problems);
        return;
    }
    compare(got, readPng(file));
}

INSTANTIATE_TEST_SUITE_P(Pictures, Reference, testing::ValuesIn(kCases), [](const auto& test) {
    std::string name = test.param.name;
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
});

} // namespace
} // namespace gnomon
