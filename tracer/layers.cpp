#include "tracer/layers.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

constexpr int kChannels = 4;

const std::uint8_t* texel(const Image& image, int x, int y) {
    return &image.rgba[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * kChannels];
}

/// Where a texel of `to` lies among `from` ones that repeat: between two of them.
struct Between {
    int first, second;
    float share; ///< of the second
};

Between between(int i, int from, int to) {
    const float at = (float(i) + 0.5f) * float(from) / float(to) - 0.5f;
    const int first = int(std::floor(at));
    return {(first + from) % from, (first + 1) % from, at - float(first)};
}

/// At least as wide and high; between texels by shares, as a GPU would magnify it.
Image stretched(const Image& image, int width, int height) {
    if (image.width == width && image.height == height) return image;
    Image out{width, height, {}};
    out.rgba.reserve(std::size_t(width) * std::size_t(height) * kChannels);
    for (int y = 0; y < height; ++y) {
        const Between row = between(y, image.height, height);
        for (int x = 0; x < width; ++x) {
            const Between column = between(x, image.width, width);
            const auto mixed = [&](int r, int c) {
                const float a = texel(image, column.first, r)[c], b = texel(image, column.second, r)[c];
                return a + column.share * (b - a);
            };
            for (int c = 0; c < kChannels; ++c) {
                const float a = mixed(row.first, c), b = mixed(row.second, c);
                out.rgba.push_back(std::uint8_t(std::lround(a + row.share * (b - a))));
            }
        }
    }
    return out;
}

bool powerOfTwo(int n) { return (n & (n - 1)) == 0; }

/// Side of the tile that an image of side `n` becomes in layers of side `layer`.
int tileSide(int n, int layer) { return layer % n == 0 && powerOfTwo(n) && powerOfTwo(layer / n) ? n : layer; }

Image blank(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * kChannels, 255)};
}

} // namespace

Layers::Layers(std::vector<Image> images, bool srgb, int side, std::size_t bytes) {
    for (;;) {
        width_ = height_ = 0;
        for (const Image& image : images) {
            width_ = std::max(width_, image.width);
            height_ = std::max(height_, image.height);
        }
        const std::size_t taken = std::size_t(width_) * std::size_t(height_) * kChannels * images.size();
        if ((taken <= bytes && std::max(width_, height_) <= side) || (width_ == 1 && height_ == 1)) break;
        reduced_ = true;
        for (Image& image : images)
            if (2 * image.width > width_ || 2 * image.height > height_) image = halved(image, srgb);
    }
    for (const Image& image : images) {
        std::vector<Image> chain{stretched(image, tileSide(image.width, width_), tileSide(image.height, height_))};
        while (chain.back().width > 1 || chain.back().height > 1) chain.push_back(halved(chain.back(), srgb));
        chains_.push_back(std::move(chain));
    }
}

int Layers::levels() const {
    int count = 1;
    while (std::max(width_, height_) >> count > 0) ++count;
    return count;
}

Image Layers::at(int layer, int level) const {
    const std::vector<Image>& chain = chains_[std::size_t(layer)];
    const Image& tile = chain[std::min(std::size_t(level), chain.size() - 1)];
    Image out{width(level), height(level), {}};
    if (tile.width == out.width && tile.height == out.height) return tile;
    out.rgba.reserve(std::size_t(out.width) * std::size_t(out.height) * kChannels);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; x += tile.width) {
            const std::uint8_t* row = texel(tile, 0, y % tile.height);
            out.rgba.insert(out.rgba.end(), row, row + std::min(tile.width, out.width - x) * kChannels);
        }
    return out;
}

glm::vec2 Layers::tile(int layer) const {
    const Image& image = chains_[std::size_t(layer)].front();
    return glm::vec2(image.width, image.height) / glm::vec2(width_, height_);
}

Image painted(const Image& color, const Image& mask) {
    const int width = std::max({color.width, mask.width, 1}), height = std::max({color.height, mask.height, 1});
    Image out = color.empty() ? blank(width, height) : stretched(color, width, height);
    const Image cover = mask.empty() ? blank(width, height) : stretched(mask, width, height);
    for (std::size_t i = 0; i < out.rgba.size(); i += kChannels) out.rgba[i + 3] = cover.rgba[i];
    return out;
}

} // namespace gnomon
