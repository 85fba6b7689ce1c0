/// Brings a linear picture to where it is seen or read: encoded for a display, or the values of its output
/// (shaders/pass/resolve.frag).
#pragma once

#include "tracer/render/pass/trace_pass.h"

namespace gnomon {

class ResolvePass {
  public:
    /// Shows the lowest `rows` of the picture over as much of the framebuffer, which is of the view's size, as they are
    /// of the whole: pixel by pixel where the sizes are the same, else stretched.
    void show(const Drawing&, const TracePass&, int rows, Frame&, const View&, unsigned framebuffer);
    /// Draws all of it into the target, which is as large: encoded colours, or values.
    static void draw(const Drawing&, const TracePass&, bool shown, Frame&, const gl::Target&);

    /// Draws all of it as it would be shown, into a framebuffer of its own, which stays bound.
    void drawAside(const Drawing&, const TracePass&, Frame&);

  private:
    gl::Target aside_; ///< of the size of the last picture that was not shown pixel by pixel
};

} // namespace gnomon
