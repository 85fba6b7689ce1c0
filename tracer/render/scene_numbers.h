/// The scene's packed numbers on the GPU, in a uniform block or in a float texture: shaders/scene.glsl.
#pragma once

#include "tracer/gl/objects.h"

#include <glm/glm.hpp>

#include <span>

namespace gnomon {

class SceneNumbers {
  public:
    /// Brings them to where programs with the data block, or without, read them, and binds them.
    void upload(std::span<const glm::vec4>, bool block);
    /// Once more, where others have been bound since.
    void bind();

  private:
    void uploadBlock(std::span<const glm::vec4>);
    void uploadTexture(std::span<const glm::vec4>);

    gl::Buffer buffer_;
    gl::Texture texture_;
    int rows_ = 0; ///< of the texture
};

} // namespace gnomon
