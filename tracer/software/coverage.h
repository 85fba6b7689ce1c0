/// What of a picture is drawn, where several shader variants draw it one after the other (variant_programs.h): pixels
/// that the base variant discards are left for the full one. Depths are not used: they are for surfaces.
///
/// Stencil  where the GL tests it before it runs the shader, as llvmpipe does: the full variant's triangle passes by
///          what is drawn
/// Mask     where the GL runs the shader first, as SwiftShader does: a second colour output, which the vertex shader of
///          the full variant reads to put aside squares that are drawn (shaders/pass/canvas.vert)
#pragma once

#include "tracer/gl/objects.h"

namespace gnomon {

class Coverage {
  public:
    enum class Kind { None, Stencil, Mask };

    Coverage() = default;
    /// For pictures drawn into such a target.
    Coverage(const gl::Target&, Kind);

    Kind kind() const { return kind_; }
    /// From here on what is drawn is marked, in the part of the picture that the scissor leaves; nothing of it is yet.
    void begin() const;
    /// Draws into the picture alone again.
    void end(const gl::Target&) const;
    const gl::Texture& mask() const { return mask_; }

  private:
    Kind kind_ = Kind::None;
    gl::Texture mask_;
    gl::Renderbuffer stencil_;
    gl::Framebuffer framebuffer_; ///< the picture with its coverage
};

} // namespace gnomon
