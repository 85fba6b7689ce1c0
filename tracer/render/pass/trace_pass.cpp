#include "tracer/render/pass/trace_pass.h"

#include "tracer/software/uncommon_features.h"

#include <algorithm>

namespace gnomon {
namespace {

/// Where the variants draw, of what was uploaded last.
ScreenPartition partitionFor(const Drawing& drawing, const View& view) {
    if (!drawing.trace.split()) return {};
    CameraFrame camera = frameOf(view.camera);
    camera.eye = glm::dvec3(glm::vec3(camera.eye - drawing.scene->prepared().origin)); // as the shader gets it
    const auto bounds = screenBoundsOf(drawing.scene->prepared(), drawing.trace.plan(), drawing.scene->shapes());
    return partitionOf(bounds, camera, view.width, view.height);
}

} // namespace

bool TracePass::resize(const Drawing& drawing, int width, int height) {
    const GLenum format = drawing.trace.plan().target.floatTargets ? GL_RGBA32F : GL_RGBA32UI;
    const Coverage::Kind coverage = drawing.trace.coverage();
    const bool fits = picture_ && picture_.width == width && picture_.height == height && picture_.format == format;
    if (fits && coverage_.kind() == coverage) return true;
    if (!fits) picture_ = gl::makeTarget(width, height, format);
    if (picture_) coverage_ = Coverage(picture_, coverage);
    return bool(picture_);
}

bool TracePass::begin(const Drawing& drawing, const View& view) {
    view_ = view;
    rows_ = 0;
    return resize(drawing, view.width, view.height);
}

void TracePass::upload(const Drawing& drawing, const Settings& settings, Frame& frame) const {
    GpuScene& scene = *drawing.scene;
    frame.block.upload(frameUniforms(view_, scene.prepared(), settings, false));
    scene.upload(drawing.trace.plan(), view_, frame.pictures, frame.problems);
    glBindFramebuffer(GL_FRAMEBUFFER, picture_.framebuffer.get());
    glViewport(0, 0, view_.width, view_.height);
    glDisable(GL_BLEND);
}

void TracePass::step(const Drawing& drawing, const Settings& settings, Frame& frame, Budget budget) {
    const int rows = std::min(budget.rows, view_.height - rows_);
    if (rows <= 0 || !picture_) return;
    upload(drawing, settings, frame);
    drawing.trace.draw(picture_, coverage_, partitionFor(drawing, view_), {0, rows_, view_.width, rows});
    rows_ += rows;
}

void TracePass::warmUp(const Drawing& drawing, const CachedProgram& program, Frame& frame) {
    begin(drawing, {drawing.scene->prepared().scene.camera, 0, 1, 1});
    upload(drawing, drawing.settings, frame);
    drawing.trace.drawAlone(picture_, coverage_, program, {0, 0, 1, 1});
}

} // namespace gnomon
