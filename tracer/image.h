/// Pictures in memory: eight-bit texels as they come from a file, float pixels as they come from the shader.
#pragma once

#include "tracer/problem.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

/// Four bytes a pixel, row 0 = top.
struct Image {
    enum class Coding {
        Bytes,         ///< RGBA, eight bits a channel
        SharedExponent ///< light beyond white: RGB of nine bits and their exponent in a word, as GL_RGB9_E5 has them
    };
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba; ///< width * height * 4
    Coding coding = Coding::Bytes;

    bool empty() const { return rgba.empty(); }
};

/// `channels` floats a pixel, row 0 = top.
struct FloatImage {
    int width = 0, height = 0, channels = 0;
    std::vector<float> pixels; ///< width * height * channels

    const float* at(int x, int y) const { return &pixels[(std::size_t(y) * width + x) * channels]; }
    float* at(int x, int y) { return &pixels[(std::size_t(y) * width + x) * channels]; }
};

/// Half the size by averages of 2 x 2 texels; colour is averaged as light where it is `srgb`, alpha and data as they
/// are.
Image halved(const Image&, bool srgb);

/// Left becomes right.
void mirror(Image&);

/// Decodes the bytes of a PNG, JPEG or Radiance HDR file; `name` stands in the problem where that fails. What would
/// take more than 512 MB is refused before it is decoded. JPEG only where GNOMON_JPEG is defined: browsers have it
/// already.
std::optional<Image> decodeImage(const std::string& name, std::span<const std::uint8_t> bytes, Problems&);

/// What a file says of its colours and is not followed: every image is taken as sRGB, and its alpha left out. Empty
/// where it says nothing.
std::string colorNote(std::span<const std::uint8_t> bytes);

} // namespace gnomon
