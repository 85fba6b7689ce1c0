// PNG files that are small and want much: what they ask for is known before it is decoded.
#include "tracer/png.h"

#include "tracer/image.h"

#include <gtest/gtest.h>

#include <string_view>

namespace gnomon {
namespace {

using Bytes = std::vector<std::uint8_t>;

void addNumber(Bytes& file, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) file.push_back(std::uint8_t(value >> shift));
}

/// The checksum is left 0: the decoder does not look at it.
void addChunk(Bytes& file, std::string_view name, const Bytes& data) {
    addNumber(file, std::uint32_t(data.size()));
    file.insert(file.end(), name.begin(), name.end());
    file.insert(file.end(), data.begin(), data.end());
    addNumber(file, 0);
}

Bytes begun(std::uint32_t width, std::uint32_t height, std::uint8_t bits = 8, std::uint8_t colorType = 6) {
    Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, header;
    addNumber(header, width);
    addNumber(header, height);
    header.insert(header.end(), {bits, colorType, 0, 0, 0});
    addChunk(file, "IHDR", header);
    return file;
}

void end(Bytes& file) { addChunk(file, "IEND", {}); }

/// `length` bytes as one deflate block: what stands in `first`, and then its last byte over and over.
Bytes deflated(const Bytes& first, std::size_t length) {
    Bytes stream{0x78, 0x01, 0x00, std::uint8_t(first.size()), 0, std::uint8_t(~first.size()), 0xff};
    for (const std::uint8_t byte : first) stream.push_back(byte);
    std::uint32_t bits = 0;
    int count = 0;
    const auto put = [&](std::uint32_t value, int width) {
        bits |= value << count;
        for (count += width; count >= 8; count -= 8, bits >>= 8) stream.push_back(std::uint8_t(bits));
    };
    put(3, 3);                                                              // the last block, with the fixed codes
    for (std::size_t i = first.size(); i < length; i += 258) put(0xA3, 13); // 285: 258 bytes, from one byte back
    put(0, 7);
    put(0, 7);
    return stream;
}

std::optional<Image> decode(const Bytes& file, Problems& problems) { return decodeImage("a.png", file, problems); }

TEST(Png, SaysWhatDecodingTakes) {
    const auto header = pngHeader(begun(16384, 16384));
    ASSERT_TRUE(header);
    EXPECT_EQ(header->decodeBytes(), std::size_t(2) << 30);
    EXPECT_EQ(pngHeader(begun(8, 4, 8, 2))->decodeBytes(), 8U * 4 * 7);
    EXPECT_EQ(pngHeader(begun(8, 4, 16, 0))->decodeBytes(), 8U * 4 * 10);
    EXPECT_FALSE(pngHeader(begun(0, 4)));
    EXPECT_FALSE(pngHeader(begun(0x80000000, 1)));
    EXPECT_FALSE(pngHeader(begun(4, 4, 8, 5)));
    EXPECT_FALSE(pngHeader({}));
}

TEST(Png, IsRefusedBeforeItTakesMoreThanItMay) {
    for (const Bytes& file : {begun(16384, 16384), begun(8193, 8192), begun(8192, 8192, 16), begun(0x7fffffff, 1)}) {
        Problems problems;
        EXPECT_FALSE(decode(file, problems));
        ASSERT_EQ(problems.size(), 1U);
        EXPECT_NE(problems[0].what.find("MB to decode; 512 MB are the most"), std::string::npos) << problems[0].what;
    }
}

TEST(Png, OfOnePixelDoesNotUnpackToAThousandMegabytes) {
    Bytes file = begun(1, 1);
    addChunk(file, "IDAT", deflated({0, 1, 2, 3, 4}, std::size_t(1) << 30));
    end(file);
    Problems problems;
    EXPECT_FALSE(decode(file, problems));
    EXPECT_EQ(problems.size(), 1U);
}

TEST(Png, MayBeginItsPixelsWithEmptyChunks) {
    Bytes file = begun(1, 1), empty = begun(1, 1);
    addChunk(file, "tEXt", {'a', 0, 'b'});
    for (int i = 0; i < 3; ++i) addChunk(file, "IDAT", {});
    addChunk(file, "IDAT", deflated({0, 1, 2, 3, 4}, 5));
    addChunk(file, "IDAT", {});
    end(file);
    Problems problems;
    const auto image = decode(file, problems);
    ASSERT_TRUE(image) << toString(problems);
    EXPECT_EQ(image->rgba, (Bytes{1, 2, 3, 4}));
    addChunk(empty, "IDAT", {});
    end(empty);
    EXPECT_FALSE(decode(empty, problems));
}

TEST(Png, MayBeCutAnywhere) {
    Bytes file = begun(1, 1);
    addChunk(file, "IDAT", {});
    addChunk(file, "IDAT", deflated({0, 1, 2, 3, 4}, 5));
    for (std::size_t size = 0; size < file.size(); ++size) {
        Problems problems;
        EXPECT_FALSE(decode(Bytes(file.begin(), file.begin() + std::ptrdiff_t(size)), problems)) << size;
        EXPECT_EQ(problems.size(), 1U) << size;
    }
}

} // namespace
} // namespace gnomon
