#include "tracer/png.h"

#include "tracer/problem.h"

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kBeforeChunk = 8;  ///< length and name
constexpr std::size_t kAroundChunk = 12; ///< and the checksum behind it, which a file that was cut may lack

std::uint32_t numberAt(Bytes bytes, std::size_t at) {
    return std::uint32_t(bytes[at]) << 24 | std::uint32_t(bytes[at + 1]) << 16 | std::uint32_t(bytes[at + 2]) << 8 |
           std::uint32_t(bytes[at + 3]);
}

constexpr std::uint32_t named(const char (&name)[5]) {
    return std::uint32_t(name[0]) << 24 | std::uint32_t(name[1]) << 16 | std::uint32_t(name[2]) << 8 |
           std::uint32_t(name[3]);
}

/// By the header's colour type; 0 of unknown ones.
int channelsOf(std::uint8_t colorType) {
    switch (colorType) {
    case 0: // grey
    case 3: // palette
        return 1;
    case 2: return 3;
    case 4: return 2;
    case 6: return 4;
    default: return 0;
    }
}

} // namespace

std::uint64_t PngHeader::decodeBytes() const {
    const std::uint64_t channelBytes = bits == 16 ? 2 : 1;
    return pixels() * (std::uint64_t(channels) + 4) * channelBytes;
}

bool isPng(Bytes bytes) {
    return bytes.size() >= kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), bytes.begin());
}

std::optional<PngHeader> pngHeader(Bytes bytes) {
    constexpr std::uint32_t kMostSide = 0x7fffffff;
    if (bytes.size() < kPngHeaderBytes || !isPng(bytes) || numberAt(bytes, 12) != named("IHDR")) return std::nullopt;
    const std::uint32_t width = numberAt(bytes, 16), height = numberAt(bytes, 20);
    const int channels = channelsOf(bytes[25]);
    if (std::min(width, height) == 0 || std::max(width, height) > kMostSide || channels == 0) return std::nullopt;
    return PngHeader{int(width), int(height), bytes[24], channels};
}

std::string pngColors(Bytes bytes) {
    constexpr std::uint32_t kSrgbGamma = 45455, kNearby = 1000; // of 100000, as gAMA counts: 1 / 2.2
    std::string found;
    if (!isPng(bytes)) return found;
    for (std::uint64_t at = kSignature.size(); at + kBeforeChunk + 4 <= bytes.size();) {
        const std::uint32_t length = numberAt(bytes, std::size_t(at)), name = numberAt(bytes, std::size_t(at) + 4);
        const std::size_t data = std::size_t(at) + kBeforeChunk;
        const bool sRgbProfile = bytes[data] == 's' && bytes[data + 1] == 'R' && bytes[data + 2] == 'G';
        if (name == named("sRGB") || (name == named("iCCP") && sRgbProfile)) return {};
        if (name == named("iCCP")) found = "a colour profile";
        if (name == named("gAMA") && found.empty()) {
            const std::uint32_t gamma = numberAt(bytes, data);
            if (gamma + kNearby < kSrgbGamma || gamma > kSrgbGamma + kNearby)
                found = "gamma " + toString(double(gamma) / 100000);
        }
        if (name == named("IDAT")) break;
        at += kAroundChunk + length;
    }
    return found;
}

std::optional<std::vector<std::uint8_t>> withoutEmptyChunks(Bytes bytes) {
    std::uint64_t at = kSignature.size(); // whatever length a chunk claims, this does not overflow
    const auto chunkHere = [&] { return isPng(bytes) && at + kBeforeChunk <= bytes.size(); };
    while (chunkHere() && numberAt(bytes, std::size_t(at) + 4) != named("IDAT"))
        at += kAroundChunk + numberAt(bytes, std::size_t(at));
    const std::uint64_t begin = at;
    while (chunkHere() && numberAt(bytes, std::size_t(at) + 4) == named("IDAT") &&
           numberAt(bytes, std::size_t(at)) == 0)
        at += kAroundChunk;
    if (at == begin) return std::nullopt;
    std::vector<std::uint8_t> rest(bytes.begin(), bytes.begin() + std::ptrdiff_t(begin));
    const auto kept = std::min(at, std::uint64_t(bytes.size()));
    rest.insert(rest.end(), bytes.begin() + std::ptrdiff_t(kept), bytes.end());
    return rest;
}

} // namespace gnomon
