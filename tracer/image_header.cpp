#include "tracer/image_header.h"

#include "tracer/hdr.h"
#include "tracer/jpeg.h"
#include "tracer/png.h"

#include <utility>

namespace gnomon {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint64_t kMostDecodeBytes = std::uint64_t(512) << 20;

} // namespace

std::optional<ImageHeader> imageHeader(Bytes bytes) {
    if (const auto png = pngHeader(bytes)) return ImageHeader{png->width, png->height, png->decodeBytes()};
    if (const auto jpeg = jpegHeader(bytes)) return ImageHeader{jpeg->width, jpeg->height, jpeg->decodeBytes()};
    if (const auto hdr = hdrHeader(bytes)) return ImageHeader{hdr->width, hdr->height, hdr->decodeBytes()};
    return std::nullopt;
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
