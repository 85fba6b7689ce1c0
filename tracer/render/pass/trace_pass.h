/// Traces rays into a linear float picture (shaders/pass/trace.frag), some rows at a time.
///
/// The order of use: begin, then step until done() is 1. The picture keeps the rows of the one before until they are
/// drawn.
#pragma once

#include "tracer/render/drawing.h"

namespace gnomon {

/// What one step of a pass may take.
struct Budget {
    int rows = 1 << 30;
};

class TracePass {
  public:
    /// A picture of the view from here on. False where this GL has no memory for it.
    bool begin(const Drawing&, const View&);
    /// Draws on from where the last step ended, by the drawing's programs with such settings.
    void step(const Drawing&, const Settings&, Frame&, Budget = {});

    const View& view() const { return view_; }
    int rows() const { return rows_; } ///< that are drawn, from the lowest up
    /// Fraction of the picture that is drawn.
    double done() const { return view_.height > 0 ? double(rows_) / view_.height : 0; }
    const gl::Target& picture() const { return picture_; }

    /// One pixel with one program: drivers compile at the first draw.
    void warmUp(const Drawing&, const CachedProgram&, Frame&);

  private:
    bool resize(const Drawing&, int width, int height);
    void upload(const Drawing&, const Settings&, Frame&) const;

    View view_;
    int rows_ = 0;
    gl::Target picture_;
    Coverage coverage_;
};

} // namespace gnomon
