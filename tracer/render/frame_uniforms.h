/// What changes from frame to frame, as shaders/frame.glsl has it.
#pragma once

#include "tracer/gl/objects.h"
#include "tracer/render/view.h"
#include "tracer/scene/scene.h"
#include "tracer/settings/settings.h"

#include <glm/glm.hpp>

namespace gnomon {

/// In std140.
struct FrameUniforms {
    glm::vec4 eye, right, up, forward, origin, background, cone, options, canvas;
    glm::ivec4 limits, budget, channels;
    glm::uvec4 zero;
};

/// `origin` is what the shader's coordinates are relative to; `shown`: for a display, else for reading back.
FrameUniforms frameUniforms(const View&, const Scene&, glm::dvec3 origin, const Settings&, bool shown);

/// The uniform block on the GPU, and the vertex array that every pass draws with: no vertex has data.
class FrameBlock {
  public:
    FrameBlock();
    /// Binds both for what is drawn next.
    void upload(const FrameUniforms&) const;

  private:
    gl::VertexArray vertexArray_;
    gl::Buffer buffer_;
};

} // namespace gnomon
