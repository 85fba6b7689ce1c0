/// What a PNG file says of itself before its pixels are decoded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

/// The header chunk.
struct PngHeader {
    int width = 0, height = 0;
    int bits = 8;     ///< of a channel
    int channels = 4; ///< as they are stored: a palette has one

    std::uint64_t pixels() const { return std::uint64_t(width) * std::uint64_t(height); }
    /// Memory that decoding to RGBA takes at most: the pixels as they are stored, and as four channels.
    std::uint64_t decodeBytes() const;
};

bool isPng(std::span<const std::uint8_t> bytes);

/// Of the first bytes of a file; none where they are no PNG's, or its header is broken.
inline constexpr std::size_t kPngHeaderBytes = 33;
std::optional<PngHeader> pngHeader(std::span<const std::uint8_t> bytes);

/// What the file says of its colours that is not sRGB, in words: "gamma 1" or "a colour profile"; else empty.
std::string pngColors(std::span<const std::uint8_t> bytes);

/// The file without the empty chunks that its pixels begin with, where there are any: the decoder copies them to null.
std::optional<std::vector<std::uint8_t>> withoutEmptyChunks(std::span<const std::uint8_t> bytes);

} // namespace gnomon
