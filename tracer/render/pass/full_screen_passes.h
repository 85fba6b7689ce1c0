/// Brings a traced picture to where it is seen or read, through the passes of full_screen_table.h: the last encodes it
/// for a display, or leaves the values of its output (shaders/pass/resolve.frag).
#pragma once

#include "tracer/render/pass/trace_pass.h"

#include <array>

namespace gnomon {

class FullScreenPasses {
  public:
    /// Shows the lowest `rows` of the picture over as much of the framebuffer, which is of the view's size, as they are
    /// of the whole: pixel by pixel where the sizes are the same, else stretched.
    void show(const Drawing&, const TracePass&, int rows, Frame&, const View&, unsigned framebuffer);
    /// Draws all of it into the target, which is as large: encoded colours, or values.
    void draw(const Drawing&, const TracePass&, bool shown, Frame&, const gl::Target&);
    /// Draws all of it as it would be shown, into a framebuffer of its own, which stays bound.
    void drawAside(const Drawing&, const TracePass&, Frame&);

    /// One of the passes alone, the picture as its input: drivers compile at the first draw.
    void warmUp(const CachedProgram&, const Drawing&, const TracePass&, Frame&);

  private:
    void drawRows(const Drawing&, const TracePass&, int rows, bool shown, Frame&, GLuint framebuffer);

    std::array<gl::Target, 2> linear_; ///< what passes but the last leave, in turn
    gl::Target shown_;                 ///< of the size of the last picture that was not shown pixel by pixel
};

} // namespace gnomon
