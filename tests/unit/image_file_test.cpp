// Picture files: numbers come back exactly, pictures as the screen shows them, and a failed write leaves nothing.
#include "native/file/image_file.h"

#include "tests/support/own_folder.h"

#include <gtest/gtest.h>
#include <tinyexr.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>

using namespace gnomon;
namespace fs = std::filesystem;

namespace {

class ImageFile : public test::OwnFolder {};

/// Every pixel another number, among them some that a careless format loses.
FloatImage sample(int channels) {
    FloatImage image{5, 3, channels, std::vector<float>(std::size_t(5 * 3 * channels))};
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = 0.1F * float(i) - 1.7F;
    image.pixels[0] = std::numeric_limits<float>::infinity();
    image.pixels[1] = -1e-38F;
    image.pixels[2] = 16777217.0F;
    return image;
}

std::string readBytes(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

Image readPng(const std::string& file) {
    const std::string bytes = readBytes(file);
    Problems problems;
    const auto image = decodeImage(file, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, problems);
    EXPECT_TRUE(image) << toString(problems);
    return image.value_or(Image{});
}

/// The channels of an EXR by name, as tinyexr's own reader gives them.
std::map<std::string, std::vector<float>> readExr(const std::string& file) {
    EXRVersion version;
    EXRHeader header;
    EXRImage image;
    const char* error = nullptr;
    std::map<std::string, std::vector<float>> channels;
    InitEXRHeader(&header);
    InitEXRImage(&image);
    EXPECT_EQ(ParseEXRVersionFromFile(&version, file.c_str()), TINYEXR_SUCCESS);
    EXPECT_EQ(ParseEXRHeaderFromFile(&header, &version, file.c_str(), &error), TINYEXR_SUCCESS);
    EXPECT_EQ(LoadEXRImageFromFile(&image, &header, file.c_str(), &error), TINYEXR_SUCCESS);
    for (int c = 0; c < image.num_channels; ++c) {
        EXPECT_EQ(header.pixel_types[c], TINYEXR_PIXELTYPE_FLOAT);
        const float* plane = reinterpret_cast<const float*>(image.images[c]);
        channels[header.channels[c].name].assign(plane, plane + std::size_t(image.width) * image.height);
    }
    FreeEXRImage(&image);
    FreeEXRHeader(&header);
    return channels;
}

} // namespace

TEST_F(ImageFile, KeepsEveryBitOfThreeChannelsInPfmRowsBottomToTop) {
    const FloatImage image = sample(3);
    Problems problems;
    ASSERT_TRUE(writeImage(path("a.pfm"), ImageFormat::Pfm, image, problems)) << toString(problems);
    const std::string bytes = readBytes(path("a.pfm")), head = "PF\n5 3\n-1.0\n";
    ASSERT_EQ(bytes.substr(0, head.size()), head);
    ASSERT_EQ(bytes.size(), head.size() + image.pixels.size() * 4);
    for (int y = 0; y < 3; ++y)
        EXPECT_EQ(std::memcmp(bytes.data() + head.size() + std::size_t(2 - y) * 5 * 3 * 4, image.at(0, y), 5 * 3 * 4),
                  0);
}

TEST_F(ImageFile, WritesOneChannelAsLittlePf) {
    Problems problems;
    ASSERT_TRUE(writeImage(path("a.pfm"), ImageFormat::Pfm, sample(1), problems));
    EXPECT_EQ(readBytes(path("a.pfm")).substr(0, 12), "Pf\n5 3\n-1.0\n");
}

TEST_F(ImageFile, KeepsEveryBitOfThreeChannelsInExr) {
    const FloatImage image = sample(3);
    Problems problems;
    ASSERT_TRUE(writeImage(path("a.exr"), ImageFormat::Exr, image, problems)) << toString(problems);
    const auto channels = readExr(path("a.exr"));
    ASSERT_EQ(channels.size(), 3U);
    const char* names[] = {"R", "G", "B"};
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_EQ(channels.at(names[i % 3])[i / 3], image.pixels[i]) << i;
}

TEST_F(ImageFile, KeepsEveryBitOfOneChannelInExrAsY) {
    const FloatImage image = sample(1);
    Problems problems;
    ASSERT_TRUE(writeImage(path("a.exr"), ImageFormat::Exr, image, problems)) << toString(problems);
    const auto channels = readExr(path("a.exr"));
    ASSERT_EQ(channels.size(), 1U);
    EXPECT_EQ(channels.at("Y"), image.pixels);
}

TEST_F(ImageFile, KeepsEveryColourOfAPictureInPng) {
    Image image{4, 2, {}};
    for (int i = 0; i < 8; ++i)
        image.rgba.insert(image.rgba.end(), {std::uint8_t(31 * i), std::uint8_t(255 - i), 7, 255});
    Problems problems;
    ASSERT_TRUE(writeImage(path("a.png"), image, problems)) << toString(problems);
    EXPECT_EQ(readPng(path("a.png")).rgba, image.rgba);
}

TEST_F(ImageFile, RefusesInPngWhatLeavesZeroToOne) {
    for (Aov aov : {Aov::Distance, Aov::Position, Aov::Object}) {
        Problems problems;
        EXPECT_FALSE(checkImageFile(path("a.png"), {}, aov, problems));
        ASSERT_EQ(problems.size(), 1U);
        EXPECT_EQ(problems[0].remedy, "use .pfm or .exr");
    }
    EXPECT_EQ(files(), 0U);
}

TEST_F(ImageFile, RefusesFormatsItDoesNotKnowAndFoldersThatDoNotExist) {
    for (const char* name : {"a.jpg", "a", "a.PNG.bak", "missing/a.png"}) {
        Problems problems;
        EXPECT_FALSE(checkImageFile(path(name), {}, Aov::Color, problems)) << name;
        EXPECT_EQ(problems.size(), 1U) << name;
    }
}

TEST_F(ImageFile, ReplacesAnOldFileAndLeavesNoDraftBehind) {
    Problems problems;
    ASSERT_TRUE(writeImage(path("a.pfm"), ImageFormat::Pfm, sample(3), problems));
    ASSERT_TRUE(writeImage(path("a.pfm"), ImageFormat::Pfm, sample(1), problems));
    EXPECT_EQ(readBytes(path("a.pfm")).substr(0, 2), "Pf");
    EXPECT_EQ(files(), 1U);
}

TEST_F(ImageFile, LeavesNothingWhereItCannotWrite) {
    fs::create_directories(path("a.pfm/occupied")); // a folder in the file's place: the rename fails
    Problems problems;
    EXPECT_FALSE(writeImage(path("a.pfm"), ImageFormat::Pfm, sample(3), problems));
    EXPECT_FALSE(problems.empty());
    EXPECT_EQ(files(), 1U);
}

TEST(DecodeImage, SaysWhichFileIsNoPictureAndWhy) {
    Problems problems;
    const std::string text = "this is not a picture";
    const auto bytes = std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    EXPECT_FALSE(decodeImage("moon.png", bytes, problems));
    EXPECT_FALSE(decodeImage("empty.png", {}, problems));
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_EQ(problems[0].file, "moon.png");
    EXPECT_NE(problems[0].what.find("cannot be read as a picture"), std::string::npos);
    EXPECT_NE(problems[1].what.find("the file is empty"), std::string::npos);
}
