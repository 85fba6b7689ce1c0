// Names of images in scenes, and the files they mean.
#include "native/file/asset_folder.h"
#include "native/file/image_file.h"
#include "tests/support/own_folder.h"
#include "tracer/png.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <span>

namespace gnomon {
namespace {

namespace fs = std::filesystem;

class ImageNames : public test::OwnFolder {
  protected:
    /// A picture of `size` texels a side.
    void write(const std::string& name, int size) const {
        fs::create_directories(fs::path(path(name)).parent_path());
        const Image image{size, size, std::vector<std::uint8_t>(std::size_t(size) * std::size_t(size) * 4, 200)};
        std::ofstream(path(name), std::ios::binary) << toPng(image);
    }

    std::string sceneText(const std::string& image) const {
        return R"({"materials": {"m": {"texture": ")" + image +
               R"("}}, "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "m"}]})";
    }

    /// Side of the picture that the name means, 0 of none.
    int sideOf(const std::string& image, Problems& problems) const {
        std::ofstream(path("scene.json")) << sceneText(image);
        const AssetFolder assets(path("assets"));
        const auto scene = assets.readScene(path("scene.json"), problems);
        const auto images = scene ? assets.readImages(*scene, problems) : std::nullopt;
        return images && images->size() == 1 ? images->front().second.width : 0;
    }
    int sideOf(const std::string& image) const {
        Problems problems;
        const int side = sideOf(image, problems);
        EXPECT_EQ(toString(problems), "") << image;
        return side;
    }
};

TEST_F(ImageNames, MayHaveDotsBlanksFoldersAndEndings) {
    write("textures/moon.height.png", 2);
    write("my photo.PNG", 3);
    write("Größe.jpg", 4); // what a file is, its bytes say
    write("a.b/c.jpeg", 5);
    write("assets/textures/far.png", 6);
    write("both.png", 7);
    write("both.jpg", 8);
    EXPECT_EQ(sideOf("textures/moon.height.png"), 2);
    EXPECT_EQ(sideOf("textures/moon.height"), 2);
    EXPECT_EQ(sideOf("my photo"), 3);
    EXPECT_EQ(sideOf("my photo.PNG"), 3);
    EXPECT_EQ(sideOf("Größe"), 4);
    EXPECT_EQ(sideOf("a.b/c"), 5);
    EXPECT_EQ(sideOf("far"), 6);
    EXPECT_EQ(sideOf("both"), 7) << "PNG first";
    EXPECT_EQ(sideOf("both.jpg"), 8);
}

TEST_F(ImageNames, AreLookedForUnderTheirOwnEndingOnly) {
    write("moon.png", 2);
    Problems problems;
    EXPECT_EQ(sideOf("moon.jpg", problems), 0);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(problems[0].what.find("image 'moon.jpg' is missing"), std::string::npos);
}

TEST_F(ImageNames, OfOtherFormatsAreToldAsThat) {
    write("sky.exr", 2);
    Problems problems;
    EXPECT_EQ(sideOf("sky.exr", problems), 0);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(problems[0].what.find("image 'sky.exr' is of a format that is not read"), std::string::npos);
    EXPECT_EQ(problems[0].remedy.find("sky.exr.png"), std::string::npos);
}

TEST_F(ImageNames, OfACubeMapHaveNoEnding) {
    Scene scene;
    scene.background.cubemap = "sky.png";
    Problems problems;
    EXPECT_FALSE(AssetFolder(folder_ / "assets").readImages(scene, problems));
    ASSERT_EQ(problems.size(), 6U);
    EXPECT_NE(problems[0].remedy.find("leave the ending out"), std::string::npos);
}

TEST_F(ImageNames, OfABackgroundThatIsStretchedAreNoted) {
    const auto noted = [&](const char* kind, const std::string& name) {
        std::ofstream(path("scene.json")) << "{\"background\": {\"" << kind << "\": \"" << name
                                          << R"("}, "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}}]})";
        Problems problems, notes;
        const AssetFolder assets(path("assets"));
        const auto scene = assets.readScene(path("scene.json"), problems);
        EXPECT_TRUE(scene && assets.readImages(*scene, problems, &notes)) << toString(problems);
        return toString(notes);
    };
    for (const char* side : {"-px", "-nx", "-py", "-ny", "-pz", "-nz"}) {
        write(std::string("even") + side + ".png", 4);
        write(std::string("odd") + side + ".png", side[1] == 'p' ? 4 : 8);
    }
    EXPECT_EQ(noted("cubemap", "even"), "");
    EXPECT_NE(noted("cubemap", "odd").find("is stretched: it has"), std::string::npos);
    EXPECT_NE(noted("image", "even-px").find("'even-px' is stretched: it has 4 x 4; a background's is twice as wide"),
              std::string::npos);
}

// The schema's pattern and the reader agree.
TEST_F(ImageNames, StayInTheScenesFolder) {
    const std::regex pattern(R"(^(?!\.{0,2}(/|$))(?!.*/\.{0,2}(/|$))(?!.*\.[hH][dD][rR]$)[^\\\x00-\x1f\x7f]+$)");
    EXPECT_NE(sceneSchema().find(
                  R"("^(?!\\.{0,2}(/|$))(?!.*/\\.{0,2}(/|$))(?!.*\\.[hH][dD][rR]$)[^\\\\\\x00-\\x1f\\x7f]+$")"),
              std::string::npos);
    for (const auto& [name, right] : {std::pair<std::string, bool>{"a", true},
                                      {"a/b.c/d e", true},
                                      {"...", true},
                                      {".hidden", true},
                                      {"a..b", true},
                                      {"..a/b", true},
                                      {"/etc/passwd", false},
                                      {"..", false},
                                      {"../a", false},
                                      {"a/../b", false},
                                      {"a/..", false},
                                      {"./a", false},
                                      {"a//b", false},
                                      {"a/", false},
                                      {"", false},
                                      {"a\\\\b", false},
                                      {"a\\u0007b", false},
                                      {"a.hdr", false},
                                      {"a.HDR", false}}) {
        Problems problems;
        EXPECT_EQ(bool(readScene(sceneText(name), "a.json", problems)), right) << name;
        if (name.find('\\') == std::string::npos) {
            EXPECT_EQ(std::regex_match(name, pattern), right) << name;
        }
    }
}

// --- what a PNG says of its colours
// --------------------------------------------------------------------------------------

using Bytes = std::vector<std::uint8_t>;

Bytes pngWith(const std::string& name, const std::string& data) {
    const std::string size(1, char(data.size())), zeros(3, '\0');
    const std::string file = std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\b\6\0\0\0\0\0\0\0", 33) +
                             zeros + size + name + data + std::string("\0\0\0\0\0\0\0\0IDAT\0\0\0\0", 16);
    return {file.begin(), file.end()};
}

/// One part in 100 000, as gAMA counts.
std::string gamma(std::uint32_t value) {
    return {char(value >> 24), char(value >> 16 & 255), char(value >> 8 & 255), char(value & 255)};
}

TEST(PngColors, AreToldWhereTheyAreNotSrgb) {
    EXPECT_EQ(pngColors(pngWith("gAMA", gamma(100000))), "gamma 1");
    EXPECT_EQ(pngColors(pngWith("gAMA", gamma(45455))), "") << "1 / 2.2";
    EXPECT_EQ(pngColors(pngWith("sRGB", "0")), "");
    EXPECT_EQ(pngColors(pngWith("iCCP", "sRGB profile")), "");
    EXPECT_EQ(pngColors(pngWith("iCCP", "Adobe RGB")), "a colour profile");
    EXPECT_EQ(pngColors(pngWith("tRNS", "ab")), "");
    Bytes cut = pngWith("gAMA", gamma(100000));
    for (; !cut.empty(); cut.pop_back()) pngColors(cut);
    EXPECT_EQ(colorNote(pngWith("gAMA", gamma(100000))), "declares gamma 1; its values are taken as sRGB");
}

} // namespace
} // namespace gnomon
