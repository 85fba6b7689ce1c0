/// Fills the uniform block of what changes from frame to frame (frame_uniforms.h) and brings it to the GPU.
#pragma once

#include "tracer/gl/objects.h"
#include "tracer/plan/prepared_scene.h"
#include "tracer/render/frame_uniforms.h"
#include "tracer/render/view.h"
#include "tracer/settings/settings.h"

namespace gnomon {

/// `shown`: for a display, else for reading back.
FrameUniforms frameUniforms(const View&, const PreparedScene&, const Settings&, bool shown);

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
