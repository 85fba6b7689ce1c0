#include "tracer/hdr.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace gnomon {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr int kMostSide = 1 << 24; ///< of an image that is measured: products stay within 64 bits

/// The number after `before`, which `line` begins with; what follows the number is left in `line`.
int numberAfter(std::string_view before, std::string_view& line) {
    if (!line.starts_with(before)) return 0;
    int value = 0;
    const auto [end, error] = std::from_chars(line.data() + before.size(), line.data() + line.size(), value);
    if (error != std::errc() || value < 0 || value > kMostSide) return 0;
    line.remove_prefix(std::size_t(end - line.data()));
    return value;
}

/// One row after another of what a file has behind its header.
class Rows {
  public:
    explicit Rows(Bytes bytes) : rest_(bytes) {}

    bool read(std::span<std::uint8_t> row) {
        const std::size_t width = row.size() / 4;
        constexpr std::size_t kShortest = 8, kLongest = 32767; // that the channels may be apart in
        const bool apart = width >= kShortest && width <= kLongest && rest_.size() >= 4 && rest_[0] == 2 &&
                           rest_[1] == 2 && (rest_[2] << 8 | rest_[3]) == int(width);
        return apart ? readChannels(row) : readPixels(row);
    }

  private:
    /// Each channel as runs of one byte and stretches of several.
    bool readChannels(std::span<std::uint8_t> row) {
        rest_ = rest_.subspan(4);
        for (std::size_t channel = 0; channel < 4; ++channel)
            for (std::size_t at = channel; at < row.size();) {
                if (rest_.size() < 2) return false;
                constexpr std::size_t kRun = 128;
                const bool run = rest_[0] > kRun;
                const std::size_t count = run ? rest_[0] - kRun : rest_[0], stored = run ? 1 : count;
                if (count == 0 || at + 4 * (count - 1) >= row.size() || rest_.size() <= stored) return false;
                for (std::size_t i = 0; i < count; ++i, at += 4) row[at] = rest_[run ? 1 : 1 + i];
                rest_ = rest_.subspan(1 + stored);
            }
        return true;
    }

    /// Whole pixels. 1, 1, 1, n repeats the one before n times; the next such one 256 n times, and so on.
    bool readPixels(std::span<std::uint8_t> row) {
        int shift = 0;
        for (std::size_t at = 0; at < row.size();) {
            if (rest_.size() < 4) return false;
            const Bytes pixel = rest_.first(4);
            rest_ = rest_.subspan(4);
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
                std::copy(pixel.begin(), pixel.end(), row.begin() + std::ptrdiff_t(at));
                at += 4;
                shift = 0;
                continue;
            }
            if (at == 0 || shift > 16) return false;
            const std::size_t end = at + 4 * (std::size_t(pixel[3]) << shift);
            if (end > row.size()) return false;
            for (; at < end; ++at) row[at] = row[at - 4];
            shift += 8;
        }
        return true;
    }

    Bytes rest_;
};

} // namespace

bool isHdr(Bytes bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.starts_with("#?RADIANCE\n") || text.starts_with("#?RGBE\n");
}

/// The resolution stands behind the first empty line, what pixels hold before it.
std::optional<HdrHeader> hdrHeader(Bytes bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t empty = text.find("\n\n");
    if (!isHdr(bytes) || empty == std::string_view::npos) return std::nullopt;
    if (text.substr(0, empty + 1).find("\nFORMAT=32-bit_rle_rgbe\n") == std::string_view::npos) return std::nullopt;
    std::string_view line = text.substr(empty + 2);
    HdrHeader header;
    header.height = numberAfter("-Y ", line);
    header.width = numberAfter(" +X ", line);
    if (header.width == 0 || header.height == 0 || !line.starts_with('\n')) return std::nullopt;
    header.size = text.size() - line.size() + 1;
    return header;
}

std::optional<std::vector<std::uint8_t>> hdrPixels(Bytes bytes, const HdrHeader& header) {
    std::vector<std::uint8_t> pixels(header.pixels() * 4);
    Rows rows(bytes.subspan(header.size));
    for (int y = 0; y < header.height; ++y) {
        const std::size_t row = std::size_t(header.width) * 4;
        if (!rows.read(std::span(pixels).subspan(y * row, row))) return std::nullopt;
    }
    return pixels;
}

} // namespace gnomon
