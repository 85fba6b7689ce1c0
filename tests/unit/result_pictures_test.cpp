/// Pictures within results: small enough for a file, shown as a window shows them, and back again as they went in.
#include "lab/results/result_pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gnomon {
namespace {

TEST(ResultPictures, FitAFileHoweverManyThereAre) {
    EXPECT_EQ(pictureSize({160, 120}, 1), glm::ivec2(160, 120)) << "never larger than the frame";
    EXPECT_EQ(pictureSize({1920, 1080}, 1), glm::ivec2(320, 180));
    for (const int count : {12, 100, 5000}) {
        const glm::ivec2 size = pictureSize({800, 600}, std::size_t(count));
        EXPECT_LE(1.5 * size.x * size.y * count, 750e3) << count;
        EXPECT_GE(size.y, 1);
    }
}

TEST(ResultPictures, ShowColoursAsTheShaderEncodesThem) {
    const FloatImage colors{2, 1, 3, {0.5F, -1, 2, 0.002F, 0, 1}};
    const Image plain = shown(colors, {2, 1}, false), linear = shown(colors, {2, 1}, true);
    EXPECT_EQ(plain.rgba, (std::vector<std::uint8_t>{128, 0, 255, 255, 1, 0, 255, 255}));
    EXPECT_EQ(linear.rgba, (std::vector<std::uint8_t>{188, 0, 255, 255, 7, 0, 255, 255}));
    EXPECT_EQ(shown(colors, {1, 1}, false).rgba[0], 128) << "every second pixel";
}

/// The bytes that base64 stands for.
std::string decoded(const std::string& url) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0, known = 0;
    for (const char c : url.substr(url.find(',') + 1)) {
        if (c == '=') break;
        bits = bits << 6 | unsigned(digits.find(c));
        known += 6;
        if (known < 8) continue;
        known -= 8;
        bytes += char(bits >> known & 255);
    }
    return bytes;
}

TEST(ResultPictures, ComeBackAsTheyWentIn) {
    for (const int width : {1, 2, 3, 7}) { // lengths of all rests of three
        Image image{width, 2, {}};
        for (int i = 0; i < 2 * width * 4; ++i) image.rgba.push_back(i % 4 == 3 ? 255 : std::uint8_t(37 * i));
        Results results;
        EXPECT_EQ(addImage(image, results), 0U);
        const std::string bytes = decoded(results.images[0]);
        Problems problems;
        const auto back =
            decodeImage("", {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, problems);
        ASSERT_TRUE(back) << toString(problems);
        EXPECT_EQ(back->rgba, image.rgba);
    }
}

TEST(ResultPictures, AreHeldAgainstPicturesOfTheirSizeOnly) {
    const Image small{1, 1, {1, 2, 3, 255}}, wide{2, 1, {1, 2, 3, 255, 1, 2, 3, 255}};
    Results results;
    addPicture({"P", "t", {}, 0, {}, "R"}, small, wide, results);
    addPicture({"Q", "t", {}, 0, {}, "R"}, {}, wide, results);
    ASSERT_EQ(results.pictures.size(), 1U) << "nothing drawn, nothing shown";
    EXPECT_FALSE(results.pictures[0].reference);
}

} // namespace
} // namespace gnomon
