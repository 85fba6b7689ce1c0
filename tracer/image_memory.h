/// The memory that a scene's images take on their way to the GL. On a software rasteriser textures lie in it, too, with
/// all their levels, beside images that wait.
#pragma once

#include <cstddef>
#include <span>

namespace gnomon {

/// Most for images: with all else that the program holds, less than 1 GB.
inline constexpr std::size_t kMostImageMemory = std::size_t(850) << 20;

/// Images that become one texture.
struct ImageUpload {
    std::size_t images = 0;  ///< bytes of them, dropped once the texture is filled
    std::size_t texels = 0;  ///< bytes of its finest level
    std::size_t scratch = 0; ///< bytes for the image that is made fit
};

/// The most at a time, where the textures are made one after another and all images wait from the beginning.
std::size_t peakMemory(std::span<const ImageUpload>);

} // namespace gnomon
