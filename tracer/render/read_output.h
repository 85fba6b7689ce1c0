/// Pictures drawn to be read back, all at once and at their full size.
#pragma once

#include "tracer/gl/gl.h"
#include "tracer/render/pass/full_screen_passes.h"

namespace gnomon {

class OutputReader {
  public:
    /// The output that the settings name, float32, neither clamped nor encoded. Empty, with a problem, where this GL
    /// cannot.
    FloatImage values(const Drawing&, const View&, Frame&, const gl::Info&, Problems&);
    /// What a window would show.
    Image shown(const Drawing&, const View&, Frame&, const gl::Info&, Problems&);

  private:
    bool draw(const Drawing&, const Settings&, const View&, GLenum format, Frame&, const gl::Info&, Problems&);
    FloatImage valuesOf(const Drawing&, const Settings&, const View&, Frame&, const gl::Info&, Problems&);
    FloatImage meanOfBatches(const Drawing&, const View&, Frame&, const gl::Info&, Problems&);

    TracePass trace_;
    FullScreenPasses fullScreen_;
    gl::Target output_;
};

} // namespace gnomon
