#include "tracer/render/programs.h"

#include "tracer/shader/parts.h"

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

} // namespace

Programs::Programs(const Features& features, ProgramCache& cache, Problems& problems)
    : whole_(cache.get(features, problems)), divides_(features.parted && !cache.overridden()) {
    if (!canDraw() || !divides_ || !beginParts(cache, problems)) return;
    const auto ready = [](const auto& part) { return !part || part->state == ProgramState::Ready; };
    parted_ = ready(sky_) && ready(usual_);
}

bool Programs::leaves() const { return divides_ && anyRare(features()); }

bool Programs::beginParts(ProgramCache& cache, Problems& problems) {
    if (!sky_) sky_ = cache.get(features(), problems, "pass/sky.frag");
    if (!usual_ && leaves()) usual_ = cache.get(usualOf(features()), problems);
    return sky_ && (usual_ || !leaves());
}

ProgramState Programs::poll(ProgramCache& cache, const WarmUp& warmUp, Problems& problems) {
    const ProgramState state = cache.poll(
        *whole_, [&] { warmUp(*whole_); }, problems);
    if (state != ProgramState::Ready || !divides_) return state;
    return pollParts(cache, warmUp, problems);
}

ProgramState Programs::pollParts(ProgramCache& cache, const WarmUp& warmUp, Problems& problems) {
    if (parted_) return ProgramState::Ready;
    if (!beginParts(cache, problems)) return ProgramState::Failed;
    for (const auto& part : {sky_, usual_}) {
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
    for (const auto& program : {whole_, sky_, usual_}) {
        if (!program || program->state != ProgramState::Ready) continue;
        sum.sourceBytes += program->stats.sourceBytes;
        sum.buildMs += program->stats.buildMs;
        sum.compileMs += program->stats.compileMs;
    }
    return sum;
}

// What is drawn is noted in the depths: an early test on them is a branch, the only one that some drivers have. They
// are tested also where one program draws alone: drivers compile it anew for what they test.
void Programs::begin(const Rectangle& band) const {
    glEnable(GL_SCISSOR_TEST);
    if (!leaves()) return;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glScissor(band.x, band.y, band.width, band.height);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void Programs::end() {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
}

void Programs::draw(const Regions& regions, const Rectangle& band) const {
    begin(band);
    if (parted_) {
        drawIn(*sky_, regions.sky, band);
        if (usual_) drawIn(*usual_, regions.usual, band);
        drawIn(*whole_, regions.usual, band); // what is left of them
        drawIn(*whole_, regions.rare, band);
    } else {
        drawIn(*whole_, {&band, 1}, band);
    }
    end();
}

void Programs::drawAlone(const CachedProgram& program, const Rectangle& band) const {
    begin(band);
    drawIn(program, {&band, 1}, band);
    end();
}

} // namespace gnomon
