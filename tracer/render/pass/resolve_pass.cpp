#include "tracer/render/pass/resolve_pass.h"

#include <cmath>

namespace gnomon {
namespace {

/// The lowest `rows` of the picture, into the framebuffer.
void drawRows(const Drawing& drawing, const TracePass& traced, int rows, bool shown, Frame& frame, GLuint framebuffer) {
    const View& view = traced.view();
    frame.block.upload(frameUniforms(view, drawing.scene->prepared(), drawing.settings, shown));
    glActiveTexture(GL_TEXTURE0 + kPictureUnit);
    glBindTexture(GL_TEXTURE_2D, traced.picture().color.get());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, view.width, view.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, view.width, rows);
    glUseProgram(drawing.resolve->program.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
    glBindTexture(GL_TEXTURE_2D, 0); // the next pass draws into it
    glActiveTexture(GL_TEXTURE0 + kDataUnit);
}

void fit(gl::Target& target, const View& view) {
    if (target && target.width == view.width && target.height == view.height) return;
    target = gl::makeTarget(view.width, view.height, GL_RGBA8);
}

} // namespace

void ResolvePass::show(const Drawing& drawing, const TracePass& traced, int rows, Frame& frame, const View& view,
                       unsigned framebuffer) {
    const View& from = traced.view();
    if (from.width == view.width && from.height == view.height)
        return drawRows(drawing, traced, rows, true, frame, framebuffer);
    fit(aside_, from);
    drawRows(drawing, traced, rows, true, frame, aside_.framebuffer.get());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, aside_.framebuffer.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    const int to = int(std::lround(double(view.height) * rows / from.height));
    glBlitFramebuffer(0, 0, from.width, rows, 0, 0, view.width, to, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, view.width, view.height);
}

void ResolvePass::draw(const Drawing& drawing, const TracePass& traced, bool shown, Frame& frame,
                       const gl::Target& target) {
    drawRows(drawing, traced, traced.view().height, shown, frame, target.framebuffer.get());
}

void ResolvePass::drawAside(const Drawing& drawing, const TracePass& traced, Frame& frame) {
    fit(aside_, traced.view());
    draw(drawing, traced, true, frame, aside_);
}

} // namespace gnomon
