#include "tracer/image.h"

#include "tracer/png.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdlib>

namespace {

/// A file of a few pixels may unpack to any length: no block that the decoder takes is larger.
thread_local std::size_t mostOfABlock = 0;

void* allocate(std::size_t size) { return size <= mostOfABlock ? std::malloc(size) : nullptr; }
void* reallocate(void* block, std::size_t size) { return size <= mostOfABlock ? std::realloc(block, size) : nullptr; }

} // namespace

#define STBI_MALLOC allocate
#define STBI_REALLOC reallocate
#define STBI_FREE std::free
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS 16384
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wshadow"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace gnomon {
namespace {

constexpr std::size_t kMostDecodeBytes = std::size_t(512) << 20;
constexpr std::size_t kSmallBlocks = 1 << 16; ///< the decoder's own state, and what it takes for tiny pictures

float toLinear(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }
float toSrgb(float c) { return c <= 0.0031308f ? c * 12.92f : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f; }

} // namespace

Image halved(const Image& image, bool srgb) {
    Image half{std::max(image.width / 2, 1), std::max(image.height / 2, 1), {}};
    half.rgba.resize(std::size_t(half.width) * half.height * 4);
    const auto at = [&](int x, int y, int c) {
        const int cx = std::min(x, image.width - 1), cy = std::min(y, image.height - 1);
        return image.rgba[(std::size_t(cy) * image.width + cx) * 4 + c];
    };
    std::array<float, 256> decode;
    for (int i = 0; i < 256; ++i) decode[i] = srgb ? toLinear(float(i) / 255) : float(i) / 255;
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            for (int c = 0; c < 4; ++c) {
                const int x2 = 2 * x, y2 = 2 * y;
                const auto value = [&](int dx, int dy) {
                    const auto byte = at(x2 + dx, y2 + dy, c);
                    return c == 3 ? float(byte) / 255 : decode[byte];
                };
                const float mean = (value(0, 0) + value(1, 0) + value(0, 1) + value(1, 1)) / 4;
                const float coded = srgb && c != 3 ? toSrgb(mean) : mean;
                half.rgba[(std::size_t(y) * half.width + x) * 4 + c] = std::uint8_t(std::lround(coded * 255));
            }
    return half;
}

void mirror(Image& image) {
    for (int y = 0; y < image.height; ++y)
        for (int left = 0, right = image.width - 1; left < right; ++left, --right) {
            std::uint8_t* row = &image.rgba[std::size_t(y) * image.width * 4];
            std::swap_ranges(row + 4 * left, row + 4 * left + 4, row + 4 * right);
        }
}

std::optional<Image> decodeImage(const std::string& name, std::span<const std::uint8_t> bytes, Problems& problems) {
    const auto refuse = [&](std::string what) {
        problems.push_back({name, 0, {}, std::move(what), "use a PNG file of at most 8192 x 8192"});
        return std::nullopt;
    };
    const auto refuseFor = [&](const char* reason) {
        return refuse(std::string("cannot be read as a picture (") + (reason ? reason : "broken") + ")");
    };
    if (bytes.empty()) return refuseFor("the file is empty");
    if (bytes.size() > INT_MAX) return refuseFor("too large");
    const auto header = pngHeader(bytes);
    if (isPng(bytes) && !header) return refuseFor("its header is broken");
    if (const std::uint64_t needed = header ? header->decodeBytes() : 0; needed > kMostDecodeBytes)
        return refuse("its " + std::to_string(header->width) + " x " + std::to_string(header->height) +
                      " pixels take " + std::to_string(needed >> 20) + " MB to decode; 512 MB are the most");
    const auto cleaned = withoutEmptyChunks(bytes);
    if (cleaned) bytes = *cleaned;
    // Twice: interlaced pixels and chunks that follow one another make the decoder double its buffers.
    mostOfABlock = 2 * std::max(header ? std::size_t(header->decodeBytes()) : 0, bytes.size()) + kSmallBlocks;
    int width = 0, height = 0, channels = 0;
    stbi_uc* texels = stbi_load_from_memory(bytes.data(), int(bytes.size()), &width, &height, &channels, 4);
    if (!texels) return refuseFor(stbi_failure_reason());
    Image image{width, height, {texels, texels + std::size_t(width) * height * 4}};
    stbi_image_free(texels);
    return image;
}

} // namespace gnomon
