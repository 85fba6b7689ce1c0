#include "tracer/render/programs.h"

#include "tracer/software/uncommon_features.h"

#include <algorithm>
#include <span>

namespace gnomon {
namespace {

/// The part of a rectangle within the rows of a band.
Rectangle within(Rectangle rectangle, const Rectangle& band) {
    const int top = std::min(rectangle.y + rectangle.height, band.y + band.height);
    rectangle.y = std::max(rectangle.y, band.y);
    rectangle.height = top - rectangle.y;
    return rectangle;
}

/// One triangle over all, of which the scissor leaves a rectangle: of two triangles pixels along the seam would be
/// drawn twice on wide SIMD.
void drawIn(const CachedProgram& program, std::span<const Rectangle> rectangles, const Rectangle& band) {
    glUseProgram(program.program.get());
    for (const Rectangle& rectangle : rectangles) {
        const Rectangle r = within(rectangle, band);
        if (r.height <= 0) continue;
        glScissor(r.x, r.y, r.width, r.height);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

/// What is drawn from here on is noted in the target's depths, and not drawn again.
void beginCoverage(const gl::Target& target, const Rectangle& band) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.coverage.get());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glScissor(band.x, band.y, band.width, band.height);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void endCoverage(const gl::Target& target) {
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
}

/// What is not noted of the band, tile by tile (shaders/pass/canvas.vert).
void drawTiles(const CachedProgram& program, int tile, const gl::Target& target, const Rectangle& band) {
    const int columns = (target.width + tile - 1) / tile;
    const int first = band.y / tile, end = (band.y + band.height + tile - 1) / tile;
    glUseProgram(program.program.get());
    glActiveTexture(GL_TEXTURE0 + kDrawnUnit);
    glBindTexture(GL_TEXTURE_2D, target.depth.get());
    glActiveTexture(GL_TEXTURE0 + kDataUnit);
    glScissor(band.x, band.y, band.width, band.height);
    glDrawArrays(GL_POINTS, 3 + first * columns, (end - first) * columns);
}

} // namespace

Programs::Programs(const Plan& plan, ProgramCache& cache, Problems& problems)
    : plan_(plan), full_(cache.get(plan, problems)) {
    if (!canDraw() || !plan.split.on || !beginParts(cache, problems)) return;
    const auto ready = [](const auto& part) { return !part || part->state == ProgramState::Ready; };
    parted_ = ready(sky_) && ready(base_);
}

bool Programs::fallsBack() const { return plan_.split.anyUncommon(); }

bool Programs::beginParts(ProgramCache& cache, Problems& problems) {
    if (!sky_) sky_ = cache.get(skyOf(plan_), problems, "pass/sky.frag");
    if (!base_ && fallsBack()) base_ = cache.get(baseOf(plan_), problems);
    return sky_ && (base_ || !fallsBack());
}

ProgramState Programs::poll(ProgramCache& cache, const WarmUp& warmUp, Problems& problems) {
    const ProgramState state = cache.poll(
        *full_, [&] { warmUp(*full_); }, problems);
    if (state != ProgramState::Ready || !plan_.split.on) return state;
    return pollParts(cache, warmUp, problems);
}

ProgramState Programs::pollParts(ProgramCache& cache, const WarmUp& warmUp, Problems& problems) {
    if (parted_) return ProgramState::Ready;
    if (!beginParts(cache, problems)) return ProgramState::Failed;
    for (const auto& part : {sky_, base_}) {
        if (!part) continue;
        const ProgramState state = cache.poll(
            *part, [&] { warmUp(*part); }, problems);
        if (state != ProgramState::Ready) return state;
    }
    parted_ = true;
    return ProgramState::Ready;
}

ProgramStats Programs::stats() const {
    ProgramStats sum;
    for (const auto& program : {full_, sky_, base_}) {
        if (!program || program->state != ProgramState::Ready) continue;
        sum.sourceBytes += program->stats.sourceBytes;
        sum.buildMs += program->stats.buildMs;
        sum.compileMs += program->stats.compileMs;
    }
    return sum;
}

bool Programs::marksCoverage(const CachedProgram& program) const {
    return fallsBack() && (&program != full_.get() || plan_.split.tile == 0);
}

void Programs::draw(const gl::Target& target, const ScreenPartition& partition, const Rectangle& band) const {
    if (!parted_) return drawAlone(target, *full_, band);
    glEnable(GL_SCISSOR_TEST);
    if (fallsBack()) beginCoverage(target, band);
    drawIn(*sky_, partition.sky, band);
    if (base_) drawIn(*base_, partition.base, band);
    if (plan_.split.tile > 0) {
        endCoverage(target);
        drawTiles(*full_, plan_.split.tile, target, band);
    } else {
        drawIn(*full_, partition.base, band); // what is left of them
        drawIn(*full_, partition.uncommon, band);
        if (fallsBack()) endCoverage(target);
    }
    glDisable(GL_SCISSOR_TEST);
}

// Noting also where one program draws alone: drivers compile it anew for what they test.
void Programs::drawAlone(const gl::Target& target, const CachedProgram& program, const Rectangle& band) const {
    glEnable(GL_SCISSOR_TEST);
    if (marksCoverage(program)) beginCoverage(target, band);
    drawIn(program, {&band, 1}, band);
    if (marksCoverage(program)) endCoverage(target);
    glDisable(GL_SCISSOR_TEST);
}

} // namespace gnomon
