/// Pictures that results hold beside their rows (docs/results.md): small, and each image once.
#pragma once

#include "lab/results/results.h"
#include "tracer/image.h"

#include <glm/glm.hpp>

namespace gnomon {

/// Of each of `count` pictures of frames of `frame` pixels: of its shape, at most 320×240 and no larger than it, and so
/// small that all together add about a megabyte to a file.
glm::ivec2 pictureSize(glm::ivec2 frame, std::size_t count);

/// Colours as Renderer::readOutput gives them, as shaders/shade/encode.glsl shows them; every so many pixels where
/// `size` is smaller. `linear`: the scene's colours are linear light.
Image shown(const FloatImage& colors, glm::ivec2 size, bool linear);

/// Index of the image in `results`, to which it is added unless it is there.
std::size_t addImage(const Image&, Results&);

/// A row's picture beside that of another row, or of a reference; nothing where there is no image of the row.
void addPicture(Picture, const Image& image, const Image& reference, Results&);

} // namespace gnomon
