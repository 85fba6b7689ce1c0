/// The images on a scene's surfaces, by what they are for: the shader samples each purpose in one place, however many
/// images there are. Drivers for wide SIMD fetch at every place that a function has, whichever a pixel wants.
///
/// A paint is a colour with, as its alpha, the mask of a coat: one sample for both.
#pragma once

#include "tracer/scene/scene.h"

#include <string>
#include <vector>

namespace gnomon {

/// Names of images, empty where there is none.
struct Paint {
    std::string color, mask;
    bool operator==(const Paint&) const = default;
};

/// Most images of a purpose: what an array texture of every GL holds, less the number that says "none".
inline constexpr int kMostLayers = 255;

/// Each once, in the order of the materials that use them: the order of the array textures' layers.
struct TextureSet {
    std::vector<Paint> paints;
    std::vector<std::string> normals;

    int paintOf(const Material&) const;  ///< its layer, -1 for none
    int normalOf(const Material&) const; ///< its layer, -1 for none
    bool shows(const std::string& image) const;
};

TextureSet textureSetOf(const Scene&);

} // namespace gnomon
