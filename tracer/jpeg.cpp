#include "tracer/jpeg.h"

#include <algorithm>

namespace gnomon {
namespace {

constexpr int kStartOfImage = 0xd8, kFill = 0xff;

/// SOF0 … SOF15, among which DHT, JPG and DAC lie.
bool beginsFrame(int marker) {
    return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

/// Progressive, with Huffman or arithmetic coding, alone or differential.
bool isProgressive(int marker) { return (marker & 3) == 2; }

} // namespace

std::uint64_t JpegHeader::decodeBytes() const {
    const std::uint64_t perComponent = progressive ? 3 : 1; // its samples, and coefficients of 16 bits
    return std::uint64_t(width) * std::uint64_t(height) * (std::uint64_t(components) * perComponent + 4);
}

bool isJpeg(std::span<const std::uint8_t> bytes) {
    return bytes.size() >= 3 && bytes[0] == kFill && bytes[1] == kStartOfImage && bytes[2] == kFill;
}

std::optional<JpegHeader> jpegHeader(std::span<const std::uint8_t> bytes) {
    if (!isJpeg(bytes)) return std::nullopt;
    const auto number = [&](std::size_t at) { return bytes[at] << 8 | bytes[at + 1]; };
    constexpr std::size_t kFrameBytes = 8; // length, precision, height, width, components
    for (std::size_t at = 2; at + 2 + kFrameBytes <= bytes.size();) {
        if (bytes[at] != kFill) return std::nullopt;
        const int marker = bytes[at + 1];
        if (marker == kFill) {
            ++at; // fill bytes may stand before a marker
            continue;
        }
        const std::size_t segment = at + 2;
        const int length = number(segment);
        if (beginsFrame(marker)) {
            const int height = number(segment + 3), width = number(segment + 5), components = bytes[segment + 7];
            const bool possible = std::min(width, height) > 0 && components >= 1 && components <= 4;
            return possible ? std::optional(JpegHeader{width, height, components, isProgressive(marker)})
                            : std::nullopt;
        }
        if (length < 2) return std::nullopt;
        at = segment + std::size_t(length);
    }
    return std::nullopt;
}

} // namespace gnomon
