/// Images as layers of one array texture. All layers have one size: an image whose sides go into it by powers of two is
/// repeated, level by level, and looks as it does alone; any other is stretched. What an image takes of its layer is
/// its tile.
#pragma once

#include "tracer/image.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace gnomon {

/// Of one layer's finest level, for images of these sizes.
std::size_t layerBytes(const std::vector<glm::ivec2>& sizes);

class Layers {
  public:
    /// For images of these sizes, at least one and none empty. Colour is averaged as light where it is `srgb`. No layer
    /// is wider or higher than `side`, and the finest levels of all take no more than `bytes`: what does not fit is
    /// halved until it does.
    Layers(const std::vector<glm::ivec2>& sizes, bool srgb, int side, std::size_t bytes);

    int count() const { return int(tiles_.size()); }
    int levels() const; ///< of detail, each half as wide and high as the one before, down to one texel
    int width(int level) const { return std::max(width_ >> level, 1); }
    int height(int level) const { return std::max(height_ >> level, 1); }
    /// Hands out the whole layer at each level of detail, the finest first: one is in memory at a time.
    void forEachLevel(int layer, Image, const std::function<void(int level, const Image&)>& take) const;

    /// Share of its layer that an image takes, along x and y.
    glm::vec2 tile(int layer) const { return glm::vec2(tiles_[std::size_t(layer)].size) / glm::vec2(width_, height_); }
    /// The layers, those first whose images are as large.
    std::vector<int> largestFirst() const;
    /// Images were halved.
    bool reduced() const { return reduced_; }

  private:
    struct Tile {
        glm::ivec2 size;
        int halvings = 0;   ///< of the image, before it is made as large as its tile
        bool whole = false; ///< the image is then as large as the layer
    };

    int width_ = 0, height_ = 0;
    bool srgb_, reduced_ = false;
    std::vector<Tile> tiles_;
};

/// `color` with the red channel of `mask` as its alpha, as large as the larger of the two along each side. Where one is
/// empty it counts as white.
Image painted(Image color, Image mask);
/// Its size.
glm::ivec2 paintedSize(glm::ivec2 color, glm::ivec2 mask);

} // namespace gnomon
