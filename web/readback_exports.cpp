// Pictures read back for page/tracer.js: the canvas' bytes and an output's floats, row 0 = top.
#include "tracer/gl/gl.h"
#include "tracer/gl/read_top_down.h"
#include "tracer/image.h"
#include "web/viewer_host.h"

#include <algorithm>
#include <cstdint>

namespace {

using namespace gnomon;

void draw(const View& view) { host.viewer->renderer().draw(view, host.viewer->settings().scale, 0); }

} // namespace

extern "C" {

/// Draws the view as it stands, without a step in time, and waits for the last pixel of it.
EMSCRIPTEN_KEEPALIVE void drawAndWait() {
    draw(host.viewer->view());
    std::uint8_t pixel[4];
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
}

/// Draws the view as it stands and reads the canvas back: bytes of four channels.
EMSCRIPTEN_KEEPALIVE const int* readPicture() {
    static Image picture;
    const View view = host.viewer->view();
    draw(view);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    picture = gl::readTopDown(view.width, view.height);
    return hand(view.width, view.height, 4, picture.rgba.data());
}

/// Reads the output that the settings name: floats. Needs a ready program.
EMSCRIPTEN_KEEPALIVE const int* readOutput() {
    static FloatImage output;
    output = host.viewer->renderer().readOutput(host.viewer->view(), host.problems);
    return hand(output.width, output.height, output.channels, output.pixels.data());
}

} // extern "C"
