/// Fills the uniform block of what changes from frame to frame (frame_uniforms.h) and brings it to the GPU.
#pragma once

#include "tracer/gl/objects.h"
#include "tracer/render/frame_uniforms.h"
#include "tracer/render/view.h"
#include "tracer/scene/scene.h"
#include "tracer/settings/settings.h"

namespace gnomon {

/// `origin` is what the shader's coordinates are relative to; `shown`: for a display, else for reading back.
FrameUniforms frameUniforms(const View&, const Scene&, glm::dvec3 origin, const Settings&, bool shown);

/// The block, and the vertex array that every pass draws with: no vertex has data.
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
