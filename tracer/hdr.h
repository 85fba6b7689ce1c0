/// Radiance HDR files: red, green and blue of eight bits and the exponent that they share (G. Ward, Real Pixels,
/// Graphics Gems II, 1991).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gnomon {

struct HdrHeader {
    int width = 0, height = 0;
    std::size_t size = 0; ///< in bytes: the pixels follow

    std::uint64_t pixels() const { return std::uint64_t(width) * std::uint64_t(height); }
    /// Memory that decoding takes at most.
    std::uint64_t decodeBytes() const { return 4 * pixels(); }
};

bool isHdr(std::span<const std::uint8_t> bytes);

/// Of the first bytes of a file; none where they are no HDR file's, or its rows do not go down and to the right.
std::optional<HdrHeader> hdrHeader(std::span<const std::uint8_t> bytes);

/// Red, green, blue and exponent of each pixel: a channel is its byte times 2^(exponent - 136). None where the file
/// ends before its last pixel or a run leaves its row.
std::optional<std::vector<std::uint8_t>> hdrPixels(std::span<const std::uint8_t> bytes, const HdrHeader&);

} // namespace gnomon
