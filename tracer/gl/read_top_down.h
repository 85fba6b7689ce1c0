/// Pixels of the framebuffer that is bound, as pictures in memory have them: row 0 = top, where GL's first row is the
/// lowest.
#pragma once

#include "tracer/image.h"

namespace gnomon::gl {

/// Of a framebuffer of eight-bit colours, the window's or a target's. Alpha as it is drawn.
Image readTopDown(int width, int height);
/// Of a framebuffer of float32, the first `channels` of each pixel.
FloatImage readTopDown(int width, int height, int channels);

} // namespace gnomon::gl
