#include "tracer/render/pass/full_screen_passes.h"

#include <cmath>

namespace gnomon {
namespace {

void fit(gl::Target& target, const View& view, GLenum format) {
    if (target && target.width == view.width && target.height == view.height && target.format == format) return;
    target = gl::makeTarget(view.width, view.height, format);
}

/// One pass over the lowest `rows`, from a linear picture into the framebuffer.
void drawPass(const CachedProgram& program, const gl::Target& input, int rows, GLuint framebuffer) {
    glActiveTexture(GL_TEXTURE0 + kPictureUnit);
    glBindTexture(GL_TEXTURE_2D, input.color.get());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, input.width, input.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, input.width, rows);
    glUseProgram(program.program.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
    glBindTexture(GL_TEXTURE_2D, 0); // the next pass draws into it
    glActiveTexture(GL_TEXTURE0 + kDataUnit);
}

} // namespace

void FullScreenPasses::drawRows(const Drawing& drawing, const TracePass& traced, int rows, bool shown, Frame& frame,
                                GLuint framebuffer) {
    frame.block.upload(frameUniforms(traced.view(), drawing.scene->prepared(), drawing.settings, shown));
    const gl::Target* input = &traced.picture();
    for (std::size_t pass = 0; pass + 1 < drawing.fullScreen.size(); ++pass) {
        gl::Target& output = linear_[pass % 2];
        fit(output, traced.view(), input->format);
        drawPass(*drawing.fullScreen[pass], *input, rows, output.framebuffer.get());
        input = &output;
    }
    drawPass(*drawing.fullScreen.back(), *input, rows, framebuffer);
}

void FullScreenPasses::show(const Drawing& drawing, const TracePass& traced, int rows, Frame& frame, const View& view,
                            unsigned framebuffer) {
    const View& from = traced.view();
    if (from.width == view.width && from.height == view.height)
        return drawRows(drawing, traced, rows, true, frame, framebuffer);
    fit(shown_, from, GL_RGBA8);
    drawRows(drawing, traced, rows, true, frame, shown_.framebuffer.get());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, shown_.framebuffer.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    const int to = int(std::lround(double(view.height) * rows / from.height));
    glBlitFramebuffer(0, 0, from.width, rows, 0, 0, view.width, to, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, view.width, view.height);
}

void FullScreenPasses::draw(const Drawing& drawing, const TracePass& traced, bool shown, Frame& frame,
                            const gl::Target& target) {
    drawRows(drawing, traced, traced.view().height, shown, frame, target.framebuffer.get());
}

void FullScreenPasses::drawAside(const Drawing& drawing, const TracePass& traced, Frame& frame) {
    fit(shown_, traced.view(), GL_RGBA8);
    draw(drawing, traced, true, frame, shown_);
}

void FullScreenPasses::warmUp(const CachedProgram& program, const Drawing& drawing, const TracePass& traced,
                              Frame& frame) {
    frame.block.upload(frameUniforms(traced.view(), drawing.scene->prepared(), drawing.settings, true));
    // Some drivers compile a program anew for each format of target; floats cannot be drawn to all of them.
    const bool last = &program == drawing.fullScreen.back().get();
    gl::Target& target = last ? shown_ : linear_[0];
    fit(target, traced.view(), last ? GL_RGBA8 : traced.picture().format);
    drawPass(program, traced.picture(), traced.view().height, target.framebuffer.get());
}

} // namespace gnomon
