/// What a JPEG file says of itself before its pixels are decoded.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace gnomon {

/// The frame header (ITU-T T.81, B.2.2).
struct JpegHeader {
    int width = 0, height = 0;
    int components = 3;       ///< 1 of grey, 3, or 4 of CMYK
    bool progressive = false; ///< its coefficients are all kept until the last scan is read

    /// Memory that decoding to RGBA takes at most.
    std::uint64_t decodeBytes() const;
};

bool isJpeg(std::span<const std::uint8_t> bytes);

/// Of the first bytes of a file; none where they are no JPEG's, or end before its frame header.
std::optional<JpegHeader> jpegHeader(std::span<const std::uint8_t> bytes);

} // namespace gnomon
