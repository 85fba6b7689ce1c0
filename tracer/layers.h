/// Images as layers of one array texture. All layers have one size: an image whose sides go into it by powers of two is
/// repeated, level by level, and looks as it does alone; any other is stretched. What an image takes of its layer is
/// its tile.
#pragma once

#include "tracer/image.h"

#include <glm/glm.hpp>

#include <vector>

namespace gnomon {

class Layers {
  public:
    /// Colour is averaged as light where it is `srgb`. No layer is wider or higher than `side`, and the finest levels
    /// of all take no more than `bytes`: what does not fit is halved until it does. At least one image, and none empty.
    Layers(std::vector<Image>, bool srgb, int side, std::size_t bytes);

    int count() const { return int(chains_.size()); }
    int levels() const; ///< of detail, each half as wide and high as the one before, down to one texel
    int width(int level) const { return std::max(width_ >> level, 1); }
    int height(int level) const { return std::max(height_ >> level, 1); }
    /// The whole layer at that level.
    Image at(int layer, int level) const;

    /// Share of its layer that an image takes, along x and y.
    glm::vec2 tile(int layer) const;
    /// Images were halved.
    bool reduced() const { return reduced_; }

  private:
    int width_ = 0, height_ = 0;
    bool reduced_ = false;
    std::vector<std::vector<Image>> chains_; ///< of each layer: its tile, at all levels that it has
};

/// `color` with the red channel of `mask` as its alpha, as large as the larger of the two along each side. Where one is
/// empty it counts as white.
Image painted(const Image& color, const Image& mask);

} // namespace gnomon
