#include "tracer/layers.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
Image stretched(Image image, int width, int height) {
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

/// The image again and again.
Image repeated(const Image& tile, int width, int height) {
    Image out{width, height, {}};
    out.rgba.reserve(std::size_t(width) * std::size_t(height) * kChannels);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; x += tile.width) {
            const std::uint8_t* row = texel(tile, 0, y % tile.height);
            out.rgba.insert(out.rgba.end(), row, row + std::min(tile.width, width - x) * kChannels);
        }
    return out;
}

Image white(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * kChannels, 255)};
}

} // namespace

std::size_t layerBytes(const std::vector<glm::ivec2>& sizes) {
    glm::ivec2 most(0);
    for (const glm::ivec2 size : sizes) most = glm::max(most, size);
    return std::size_t(most.x) * std::size_t(most.y) * kChannels;
}

Layers::Layers(const std::vector<glm::ivec2>& sizes, bool srgb, int side, std::size_t bytes) : srgb_(srgb) {
    for (const glm::ivec2 size : sizes) tiles_.push_back({size});
    for (;;) {
        glm::ivec2 most(0);
        for (const Tile& tile : tiles_) most = glm::max(most, tile.size);
        width_ = most.x;
        height_ = most.y;
        const std::size_t taken = std::size_t(width_) * std::size_t(height_) * kChannels * tiles_.size();
        if ((taken <= bytes && std::max(width_, height_) <= side) || (width_ == 1 && height_ == 1)) break;
        reduced_ = true;
        for (Tile& tile : tiles_) {
            if (2 * tile.size.x <= width_ && 2 * tile.size.y <= height_) continue;
            tile.size = glm::max(tile.size / 2, 1);
            ++tile.halvings;
        }
    }
    for (Tile& tile : tiles_) {
        tile.whole = tile.size == glm::ivec2(width_, height_);
        tile.size = {tileSide(tile.size.x, width_), tileSide(tile.size.y, height_)};
    }
}

std::vector<int> Layers::largestFirst() const {
    std::vector<int> order;
    for (const bool whole : {true, false})
        for (int i = 0; i < count(); ++i)
            if (tiles_[std::size_t(i)].whole == whole) order.push_back(i);
    return order;
}

int Layers::levels() const {
    int count = 1;
    while (std::max(width_, height_) >> count > 0) ++count;
    return count;
}

void Layers::forEachLevel(int layer, Image image, const std::function<void(int, const Image&)>& take) const {
    const Tile& tile = tiles_[std::size_t(layer)];
    for (int i = 0; i < tile.halvings; ++i) image = halved(image, srgb_);
    image = stretched(std::move(image), tile.size.x, tile.size.y);
    for (int level = 0; level < levels(); ++level) {
        const bool fills = image.width == width(level) && image.height == height(level);
        if (fills)
            take(level, image);
        else
            take(level, repeated(image, width(level), height(level)));
        if (image.width > 1 || image.height > 1) image = halved(image, srgb_);
    }
}

glm::ivec2 paintedSize(glm::ivec2 color, glm::ivec2 mask) { return glm::max(glm::max(color, mask), 1); }

Image painted(Image color, Image mask) {
    const glm::ivec2 size = paintedSize({color.width, color.height}, {mask.width, mask.height});
    Image out = color.empty() ? white(size.x, size.y) : stretched(std::move(color), size.x, size.y);
    const Image cover = mask.empty() ? Image() : stretched(std::move(mask), size.x, size.y);
    for (std::size_t i = 0; i < out.rgba.size(); i += kChannels) out.rgba[i + 3] = cover.empty() ? 255 : cover.rgba[i];
    return out;
}

} // namespace gnomon
