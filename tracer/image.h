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

/// RGBA, eight bits a channel, row 0 = top.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba; ///< width * height * 4

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

/// Decodes PNG bytes; `name` stands in the problem where that fails. What would take more than 512 MB is refused before
/// it is decoded.
std::optional<Image> decodeImage(const std::string& name, std::span<const std::uint8_t> bytes, Problems&);

} // namespace gnomon
