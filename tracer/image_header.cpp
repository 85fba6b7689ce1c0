#include "tracer/image_header.h"

#include "tracer/jpeg.h"
#include "tracer/png.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace gnomon {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint64_t kMostDecodeBytes = std::uint64_t(512) << 20;
constexpr int kMostSide = 1 << 24; ///< of an HDR image that is measured: products stay within 64 bits

/// The number after `before`, which `line` begins with; what follows the number is left in `line`.
int numberAfter(std::string_view before, std::string_view& line) {
    if (!line.starts_with(before)) return 0;
    int value = 0;
    const auto [end, error] = std::from_chars(line.data() + before.size(), line.data() + line.size(), value);
    if (error != std::errc() || value < 0 || value > kMostSide) return 0;
    line.remove_prefix(std::size_t(end - line.data()));
    return value;
}

/// The resolution stands behind the first empty line.
std::optional<ImageHeader> hdrHeader(Bytes bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t empty = text.find("\n\n");
    if (empty == std::string_view::npos) return std::nullopt;
    std::string_view line = text.substr(empty + 2);
    const int height = numberAfter("-Y ", line), width = numberAfter(" +X ", line);
    if (width == 0 || height == 0) return std::nullopt;
    ImageHeader header{width, height, 0};
    header.decodeBytes = header.pixels() * (3 * sizeof(float) + 4);
    return header;
}

} // namespace

bool isHdr(Bytes bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.starts_with("#?RADIANCE\n") || text.starts_with("#?RGBE\n");
}

std::optional<ImageHeader> imageHeader(Bytes bytes) {
    if (const auto png = pngHeader(bytes)) return ImageHeader{png->width, png->height, png->decodeBytes()};
    if (const auto jpeg = jpegHeader(bytes)) return ImageHeader{jpeg->width, jpeg->height, jpeg->decodeBytes()};
    return isHdr(bytes) ? hdrHeader(bytes) : std::nullopt;
}

std::optional<ImageHeader> measureImage(const std::string& name, Bytes bytes, Problems& problems) {
    const auto refuse = [&](std::string what) {
        problems.push_back({name, 0, {}, std::move(what), "use a PNG or JPEG file of at most 8192 x 8192"});
        return std::nullopt;
    };
    if (bytes.empty()) return refuse("cannot be read as a picture (the file is empty)");
    const auto header = imageHeader(bytes);
    if (!header)
        return refuse(isPng(bytes) || isJpeg(bytes) || isHdr(bytes)
                          ? "cannot be read as a picture (its header is broken)"
                          : "cannot be read as a picture (it is neither PNG nor JPEG nor Radiance HDR)");
    if (header->decodeBytes > kMostDecodeBytes)
        return refuse("its " + std::to_string(header->width) + " x " + std::to_string(header->height) +
                      " pixels take " + std::to_string(header->decodeBytes >> 20) +
                      " MB to decode; 512 MB are the most");
    return header;
}

} // namespace gnomon
