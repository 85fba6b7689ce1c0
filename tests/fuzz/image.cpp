/// Any bytes as an image: what is decoded has the size it says, its mipmaps are made.
#include "tracer/image.h"
#include "tests/fuzz/fuzz.h"
#include "tracer/image_header.h"

#include <cstdint>

using namespace gnomon;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::uint64_t kMostPixels = 1 << 20; // larger ones only cost time
    const std::span bytes(data, size);
    const auto header = imageHeader(bytes);
    if (header && header->pixels() > kMostPixels && header->decodeBytes < (std::uint64_t(512) << 20)) return 0;
    Problems problems;
    const auto image = decodeImage("image.png", bytes, problems);
    fuzz::requireTold(!image, problems);
    if (!image) return 0;
    fuzz::require(image->rgba.size() == std::size_t(image->width) * image->height * 4, "four bytes a pixel");
    for (Image level = *image; level.width > 1 || level.height > 1;) level = halved(level, true);
    return 0;
}
