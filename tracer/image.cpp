#include "tracer/image.h"

#include "tracer/hdr.h"
#include "tracer/image_header.h"
#include "tracer/jpeg.h"
#include "tracer/png.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>

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
#ifdef GNOMON_JPEG
#define STBI_ONLY_JPEG
#endif
#define STBI_MAX_DIMENSIONS 16384
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wshadow"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace gnomon {
namespace {

constexpr std::size_t kSmallBlocks = 1 << 16; ///< the decoder's own state, and what it takes for tiny pictures

float toLinear(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }
float toSrgb(float c) { return c <= 0.0031308f ? c * 12.92f : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f; }

// RGB9_E5: a channel is mantissa * 2^(exponent - kLightBias), the mantissas of nine bits, red in the lowest.
constexpr int kLightBits = 9, kLightBias = 15 + kLightBits, kMostExponent = 31;

glm::vec3 lightAt(const Image& image, int x, int y) {
    const int cx = std::min(x, image.width - 1), cy = std::min(y, image.height - 1);
    std::uint32_t word;
    std::memcpy(&word, &image.rgba[(std::size_t(cy) * image.width + cx) * 4], sizeof word);
    const float unit = std::ldexp(1.0f, int(word >> 27) - kLightBias);
    return unit * glm::vec3(word & 511, word >> 9 & 511, word >> 18 & 511);
}

void setLight(glm::vec3 light, std::uint8_t* texel) {
    constexpr float kMost = 65408;                                                       // of the format
    for (int c = 0; c < 3; ++c) light[c] = light[c] > 0 ? std::min(light[c], kMost) : 0; // what is no number is dark
    const float largest = std::max({light.r, light.g, light.b});
    int exponent = 0;
    std::frexp(largest, &exponent);
    exponent = std::clamp(exponent + kLightBias - kLightBits, 0, kMostExponent);
    const auto mantissa = [&](float c) { return std::uint32_t(std::lround(std::ldexp(c, kLightBias - exponent))); };
    if (mantissa(largest) > 511) ++exponent; // rounded up to the next power of two
    const std::uint32_t word =
        std::uint32_t(exponent) << 27 | mantissa(light.b) << 18 | mantissa(light.g) << 9 | mantissa(light.r);
    std::memcpy(texel, &word, sizeof word);
}

Image halvedLight(const Image& image) {
    Image half{std::max(image.width / 2, 1), std::max(image.height / 2, 1), {}, Image::Coding::SharedExponent};
    half.rgba.resize(std::size_t(half.width) * half.height * 4);
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            setLight((lightAt(image, 2 * x, 2 * y) + lightAt(image, 2 * x + 1, 2 * y) +
                      lightAt(image, 2 * x, 2 * y + 1) + lightAt(image, 2 * x + 1, 2 * y + 1)) /
                         4.0f,
                     &half.rgba[(std::size_t(y) * half.width + x) * 4]);
    return half;
}

/// Frees what the decoder allocated.
struct FreeTexels {
    void operator()(void* texels) const { stbi_image_free(texels); }
};

/// Empty where the file ends too early.
Image decodeLight(std::span<const std::uint8_t> bytes) {
    const auto header = hdrHeader(bytes);
    auto pixels = header ? hdrPixels(bytes, *header) : std::nullopt;
    if (!pixels) return {};
    for (std::size_t i = 0; i < pixels->size(); i += 4) {
        std::uint8_t* texel = &(*pixels)[i];
        const float unit = std::ldexp(1.0f, texel[3] - 136);
        setLight(unit * glm::vec3(texel[0], texel[1], texel[2]), texel);
    }
    return {header->width, header->height, std::move(*pixels), Image::Coding::SharedExponent};
}

std::string decodersReason() {
    const char* reason = stbi_failure_reason();
    return reason && *reason != '\0' ? std::string("it cannot be decoded: ") + reason : "it ends too early";
}

Image decodeBytes(std::span<const std::uint8_t> bytes) {
    Image image;
    int channels = 0;
    const std::unique_ptr<stbi_uc, FreeTexels> texels(
        stbi_load_from_memory(bytes.data(), int(bytes.size()), &image.width, &image.height, &channels, 4));
    if (texels) image.rgba.assign(texels.get(), texels.get() + std::size_t(image.width) * image.height * 4);
    return image;
}

} // namespace

Image halved(const Image& image, bool srgb) {
    if (image.coding == Image::Coding::SharedExponent) return halvedLight(image);
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
    const auto refuse = [&](const std::string& reason) {
        problems.push_back({name,
                            0,
                            {},
                            "cannot be read as a picture (" + reason + ")",
                            "use a PNG or JPEG file of at most 8192 x 8192"});
        return std::nullopt;
    };
    if (bytes.size() > INT_MAX) return refuse("too large");
    const auto header = measureImage(name, bytes, problems);
    if (!header) return std::nullopt;
    const auto cleaned = withoutEmptyChunks(bytes);
    if (cleaned) bytes = *cleaned;
    // Twice: interlaced pixels and chunks that follow one another make the decoder double its buffers.
    mostOfABlock = 2 * std::max(std::size_t(header->decodeBytes), bytes.size()) + kSmallBlocks;
    if (isHdr(bytes)) {
        Image light = decodeLight(bytes);
        return light.empty() ? refuse("it ends too early, or a run leaves its row") : std::optional(std::move(light));
    }
    Image image = decodeBytes(bytes);
    if (image.empty()) return refuse(decodersReason());
    return image;
}

std::string colorNote(std::span<const std::uint8_t> bytes) {
    const std::string declared = pngColors(bytes);
    return declared.empty() ? declared : "declares " + declared + "; its values are taken as sRGB";
}

} // namespace gnomon
