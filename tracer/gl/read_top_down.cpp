#include "tracer/gl/read_top_down.h"

#include "tracer/gl/gl.h"

#include <algorithm>

namespace gnomon::gl {
namespace {

constexpr int kChannels = 4; // what every framebuffer can be read as

template<class Value>
std::vector<Value> readRows(int width, int height, GLenum type) {
    std::vector<Value> rows(std::size_t(width) * height * kChannels);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, type, rows.data());
    const std::size_t row = std::size_t(width) * kChannels;
    for (int y = 0; y < height / 2; ++y)
        std::swap_ranges(rows.begin() + y * row, rows.begin() + (y + 1) * row, rows.end() - (y + 1) * row);
    return rows;
}

} // namespace

Image readTopDown(int width, int height) {
    return {width, height, readRows<std::uint8_t>(width, height, GL_UNSIGNED_BYTE)};
}

FloatImage readTopDown(int width, int height, int channels) {
    const std::vector<float> rgba = readRows<float>(width, height, GL_FLOAT);
    FloatImage image{width, height, channels, std::vector<float>(std::size_t(width) * height * channels)};
    for (std::size_t pixel = 0; pixel < std::size_t(width) * height; ++pixel)
        std::copy_n(&rgba[pixel * kChannels], channels, &image.pixels[pixel * channels]);
    return image;
}

} // namespace gnomon::gl
