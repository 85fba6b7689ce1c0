#include "tracer/software/variant_programs.h"

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

/// What is not covered of the band, tile by tile (shaders/pass/canvas.vert).
void drawTiles(const CachedProgram& program, int tile, const gl::Target& target, const Coverage& coverage,
               const Rectangle& band) {
    const int columns = (target.width + tile - 1) / tile;
    const int first = band.y / tile, end = (band.y + band.height + tile - 1) / tile;
    glUseProgram(program.program.get());
    glActiveTexture(GL_TEXTURE0 + kCoverageUnit);
    glBindTexture(GL_TEXTURE_2D, coverage.mask().get());
    glActiveTexture(GL_TEXTURE0 + kDataUnit);
    glScissor(band.x, band.y, band.width, band.height);
    glDrawArrays(GL_POINTS, 3 + first * columns, (end - first) * columns);
}

bool isReady(const std::shared_ptr<CachedProgram>& program) { return program && program->state == CompileState::Ready; }

} // namespace

VariantPrograms::VariantPrograms(const Plan& plan, ProgramCache& cache, Problems& problems)
    : plan_(plan), full_(cache.get(plan, problems)) {
    if (!canDraw() || !plan.split.on || !beginVariants(cache, problems)) return;
    split_ = isReady(sky_) && (!base_ || isReady(base_));
}

bool VariantPrograms::fallsBack() const { return plan_.split.anyUncommon(); }

Coverage::Kind VariantPrograms::coverage() const {
    if (!fallsBack()) return Coverage::Kind::None;
    return plan_.split.tile > 0 ? Coverage::Kind::Mask : Coverage::Kind::Stencil;
}

bool VariantPrograms::beginVariants(ProgramCache& cache, Problems& problems) {
    if (!sky_) sky_ = cache.get(skyOf(plan_), problems, "pass/sky.frag");
    if (!base_ && fallsBack()) base_ = cache.get(baseOf(plan_), problems);
    return sky_ && (base_ || !fallsBack());
}

CompileState VariantPrograms::poll(ProgramCache& cache, const WarmUp& warmUp, Problems& problems) {
    const CompileState state = cache.poll(
        *full_, [&] { warmUp(*full_); }, problems);
    if (state != CompileState::Ready || !plan_.split.on) return state;
    return pollVariants(cache, warmUp, problems);
}

CompileState VariantPrograms::pollVariants(ProgramCache& cache, const WarmUp& warmUp, Problems& problems) {
    if (split_) return CompileState::Ready;
    if (!beginVariants(cache, problems)) return CompileState::Failed;
    for (const auto& variant : {sky_, base_}) {
        if (!variant) continue;
        const CompileState state = cache.poll(
            *variant, [&] { warmUp(*variant); }, problems);
        if (state != CompileState::Ready) return state;
    }
    split_ = true;
    return CompileState::Ready;
}

double VariantPrograms::compiled() const {
    const int wanted = 1 + plan_.split.on + fallsBack();
    return double(isReady(full_) + isReady(sky_) + isReady(base_)) / wanted;
}

ProgramStats VariantPrograms::stats() const {
    ProgramStats sum;
    for (const auto& program : {full_, sky_, base_}) {
        if (!isReady(program)) continue;
        sum.sourceBytes += program->stats.sourceBytes;
        sum.buildMs += program->stats.buildMs;
        sum.compileMs += program->stats.compileMs;
    }
    return sum;
}

bool VariantPrograms::marksCoverage(const CachedProgram& program) const {
    const Coverage::Kind kind = coverage();
    return kind == Coverage::Kind::Stencil || (kind == Coverage::Kind::Mask && &program != full_.get());
}

void VariantPrograms::draw(const gl::Target& target, const Coverage& coverage, const ScreenPartition& partition,
                           const Rectangle& band) const {
    if (!split_) return drawAlone(target, coverage, *full_, band);
    glEnable(GL_SCISSOR_TEST);
    glScissor(band.x, band.y, band.width, band.height);
    const bool marks = coverage.kind() != Coverage::Kind::None;
    if (marks) coverage.begin();
    drawIn(*sky_, partition.sky, band);
    if (base_) drawIn(*base_, partition.base, band);
    if (coverage.kind() == Coverage::Kind::Mask) {
        coverage.end(target);
        drawTiles(*full_, plan_.split.tile, target, coverage, band);
    } else {
        drawIn(*full_, partition.base, band); // what is left of them
        drawIn(*full_, partition.uncommon, band);
        if (marks) coverage.end(target);
    }
    glDisable(GL_SCISSOR_TEST);
}

// Marked also where one program draws alone: drivers compile it anew for what they test.
void VariantPrograms::drawAlone(const gl::Target& target, const Coverage& coverage, const CachedProgram& program,
                                const Rectangle& band) const {
    glEnable(GL_SCISSOR_TEST);
    glScissor(band.x, band.y, band.width, band.height);
    const bool marks = marksCoverage(program);
    if (marks) coverage.begin();
    drawIn(program, {&band, 1}, band);
    if (marks) coverage.end(target);
    glDisable(GL_SCISSOR_TEST);
}

} // namespace gnomon
