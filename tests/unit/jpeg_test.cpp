// JPEG files: decoded as they are, and what they ask for is known before that.
#include "tracer/jpeg.h"

#include "tracer/image.h"
#include "tracer/image_header.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace gnomon {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append(void* bytes, void* data, int size) {
    const auto* from = static_cast<const std::uint8_t*>(data);
    static_cast<Bytes*>(bytes)->insert(static_cast<Bytes*>(bytes)->end(), from, from + size);
}

/// A ramp of red across and of green down.
Bytes ramp(int width, int height) {
    Bytes rgb, file;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            rgb.insert(rgb.end(), {std::uint8_t(255 * x / width), std::uint8_t(255 * y / height), 90});
    stbi_write_jpg_to_func(append, &file, width, height, 3, rgb.data(), 95);
    return file;
}

/// Nothing but metadata and a frame header.
Bytes begun(int width, int height, std::uint8_t marker = 0xc0, std::uint8_t components = 3) {
    Bytes file(21 + 3 * std::size_t(components), 0x11);
    const std::string head("\xff\xd8\xff\xe1\x00\x06"
                           "Exif\xff\xff?\x00\x11\x08",
                           16);
    std::copy(head.begin(), head.end(), file.begin());
    file[12] = marker;
    file[16] = std::uint8_t(height >> 8);
    file[17] = std::uint8_t(height & 255);
    file[18] = std::uint8_t(width >> 8);
    file[19] = std::uint8_t(width & 255);
    file[20] = components;
    return file;
}

TEST(Jpeg, SaysWhatDecodingTakes) {
    const auto baseline = jpegHeader(begun(640, 480)), progressive = jpegHeader(begun(640, 480, 0xc2, 4));
    ASSERT_TRUE(baseline && progressive);
    EXPECT_EQ(baseline->width, 640);
    EXPECT_EQ(baseline->height, 480);
    EXPECT_EQ(baseline->decodeBytes(), 640U * 480 * 7);
    EXPECT_EQ(progressive->decodeBytes(), 640U * 480 * 16);
    EXPECT_FALSE(jpegHeader(begun(0, 4)));
    EXPECT_FALSE(jpegHeader(begun(4, 0)));
    EXPECT_FALSE(jpegHeader(begun(4, 4, 0xc0, 9)));
    EXPECT_FALSE(jpegHeader({}));
}

TEST(Jpeg, IsDecodedToItsColours) {
    Problems problems;
    const auto image = decodeImage("a.jpg", ramp(64, 32), problems);
    ASSERT_TRUE(image) << toString(problems);
    ASSERT_EQ(image->width, 64);
    ASSERT_EQ(image->height, 32);
    for (const auto& [x, y] : {std::pair{2, 2}, {60, 4}, {30, 28}}) {
        const std::uint8_t* texel = &image->rgba[(std::size_t(y) * 64 + std::size_t(x)) * 4];
        EXPECT_NEAR(texel[0], 255 * x / 64, 6);
        EXPECT_NEAR(texel[1], 255 * y / 32, 6);
        EXPECT_NEAR(texel[2], 90, 6);
        EXPECT_EQ(texel[3], 255);
    }
}

TEST(Jpeg, IsRefusedBeforeItTakesMoreThanItMay) {
    for (const Bytes& file : {begun(65535, 65535), begun(8192, 8192, 0xc2), begun(16384, 8192, 0xc0, 1)}) {
        Problems problems;
        EXPECT_FALSE(decodeImage("a.jpg", file, problems));
        ASSERT_EQ(problems.size(), 1U);
        EXPECT_NE(problems[0].what.find("MB to decode; 512 MB are the most"), std::string::npos) << problems[0].what;
    }
}

// Cut where it may be, it is refused, or what is missing is grey: never more than one message, never a crash.
TEST(Jpeg, MayBeCutAnywhere) {
    const Bytes file = ramp(24, 16);
    for (std::size_t size = 0; size < file.size(); ++size) {
        Problems problems;
        const auto image = decodeImage("a.jpg", Bytes(file.begin(), file.begin() + std::ptrdiff_t(size)), problems);
        EXPECT_EQ(problems.size(), image ? 0U : 1U) << size;
    }
}

TEST(Jpeg, MayBeBrokenAnywhere) {
    const Bytes file = ramp(24, 16);
    for (std::size_t at = 2; at < file.size(); ++at) {
        Bytes broken = file;
        broken[at] = std::uint8_t(broken[at] ^ 0x5a);
        Problems problems;
        const auto image = decodeImage("a.jpg", broken, problems);
        EXPECT_EQ(problems.size(), image ? 0U : 1U) << at;
    }
}

// --- Radiance HDR
// ------------------------------------------------------------------------------------------------------

Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

TEST(Hdr, KeepsLightBeyondWhite) {
    const float light[] = {0, 0.5F, 1, 12, 300, 4000, 0.001F, 0.002F, 0.003F, 60000, 1, 1};
    Bytes file;
    stbi_write_hdr_to_func(append, &file, 2, 2, 3, light);
    Problems problems;
    const auto image = decodeImage("a.hdr", file, problems);
    ASSERT_TRUE(image) << toString(problems);
    EXPECT_EQ(image->coding, Image::Coding::SharedExponent);
    ASSERT_EQ(image->rgba.size(), 16U);
    for (int texel = 0; texel < 4; ++texel) {
        std::uint32_t word = 0;
        for (int i = 3; i >= 0; --i) word = word << 8 | image->rgba[std::size_t(4 * texel + i)];
        const double exponent = std::ldexp(1.0, int(word >> 27) - 15 - 9); // as the OpenGL specification has it
        const float* wanted = light + 3 * texel;
        const float most = std::max({wanted[0], wanted[1], wanted[2]});
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR((word >> (9 * c) & 511) * exponent, wanted[c], most / 128) << texel << ", " << c;
    }
    const Image half = halved(*image, true);
    EXPECT_EQ(half.coding, Image::Coding::SharedExponent);
    EXPECT_EQ(half.rgba.size(), 4U);
}

const std::string kHdrHead = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

/// Of 8 x 2 pixels whose red is 10, 11, …, row by row.
Bytes hdrOf(const std::string& pixels) { return bytesOf(kHdrHead + "-Y 2 +X 8\n" + pixels); }

std::string wholePixels() {
    std::string pixels;
    for (char i = 0; i < 16; ++i) pixels += {char(10 + i), 20, 30, '\x80'};
    return pixels;
}

/// Rows whose channels are apart: red one by one, the others as a run.
std::string apartChannels() {
    std::string rows;
    for (char row = 0; row < 2; ++row) {
        rows += std::string("\2\2\0\x08\x08", 5);
        for (char i = 0; i < 8; ++i) rows += char(10 + 8 * row + i);
        rows += {'\x88', 20, '\x88', 30, '\x88', '\x80'};
    }
    return rows;
}

TEST(Hdr, ReadsPixelsInEveryCoding) {
    Problems problems;
    const auto whole = decodeImage("a.hdr", hdrOf(wholePixels()), problems);
    const auto apart = decodeImage("a.hdr", hdrOf(apartChannels()), problems);
    ASSERT_TRUE(whole && apart) << toString(problems);
    EXPECT_EQ(whole->rgba, apart->rgba);
    std::string rest;
    for (int i = 0; i < 7; ++i) rest += {10, 20, 30, '\x80'};
    const std::string pixel = rest.substr(0, 4);
    const auto one = decodeImage("a.hdr", hdrOf(pixel + rest + pixel + rest), problems);
    const auto runs = decodeImage("a.hdr", hdrOf(pixel + "\1\1\1\7" + pixel + "\1\1\1\7"), problems);
    ASSERT_TRUE(one && runs) << toString(problems);
    EXPECT_EQ(one->rgba, runs->rgba);
}

/// Once a file that ended within a row was decoded for ever.
TEST(Hdr, IsRefusedWhereverItEnds) {
    for (const std::string& pixels : {wholePixels(), apartChannels()})
        for (std::size_t size = 0; size < pixels.size(); ++size) {
            Problems problems;
            EXPECT_FALSE(decodeImage("a.hdr", hdrOf(pixels.substr(0, size)), problems)) << size;
            EXPECT_EQ(problems.size(), 1U) << size;
        }
}

TEST(Hdr, IsRefusedWhereARunLeavesItsRow) {
    std::string pixels = apartChannels();
    pixels[13] = '\x89'; // the run of green
    Problems problems;
    EXPECT_FALSE(decodeImage("a.hdr", hdrOf(pixels), problems));
    EXPECT_FALSE(decodeImage("a.hdr", hdrOf("\1\1\1\2" + wholePixels()), problems));
    EXPECT_FALSE(decodeImage("a.hdr", hdrOf(wholePixels().substr(0, 4) + "\1\1\1\x08" + wholePixels()), problems));
    EXPECT_EQ(problems.size(), 3U);
}

TEST(Hdr, IsMeasuredBeforeItIsDecoded) {
    const auto header = imageHeader(bytesOf(kHdrHead + "-Y 20 +X 40\n"));
    ASSERT_TRUE(header);
    EXPECT_EQ(header->width, 40);
    EXPECT_EQ(header->height, 20);
    for (const char* size : {"-Y 0 +X 4\n", "+Y 4 +X 4\n", "-Y 99999999999 +X 4\n", "-Y 4", ""})
        EXPECT_FALSE(imageHeader(bytesOf(kHdrHead + size))) << size;
    Problems problems;
    EXPECT_FALSE(decodeImage("a.hdr", bytesOf(kHdrHead + "-Y 100000 +X 100000\n"), problems));
    EXPECT_EQ(problems.size(), 1U);
}

} // namespace
} // namespace gnomon
