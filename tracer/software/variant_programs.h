/// The programs that draw one linear picture: the full one, and where a software rasteriser draws, beside it variants
/// that draw what they can of it at less cost (tracer/software/uncommon_features.h). The full one draws alone until
/// they are ready, and wherever the plan has no variants.
#pragma once

#include "tracer/shader/program_cache.h"
#include "tracer/software/coverage.h"
#include "tracer/software/screen_partition.h"

#include <functional>
#include <memory>

namespace gnomon {

class VariantPrograms {
  public:
    using WarmUp = std::function<void(const CachedProgram&)>;

    VariantPrograms() = default;
    /// Begins to build the full one, where it is new; variants follow when it is ready.
    VariantPrograms(const Plan&, ProgramCache&, Problems&);

    /// The library had a full one for the features, well or badly written.
    bool began() const { return full_ != nullptr; }
    /// There is something to draw with, soon or now: not where its context is gone.
    explicit operator bool() const { return began() && full_->program; }
    const CachedProgram& full() const { return *full_; }
    const Plan& plan() const { return plan_; }
    bool canDraw() const { return *this && full_->state == CompileState::Ready; }
    /// Variants draw, too.
    bool split() const { return split_; }
    /// How targets mark what is drawn.
    Coverage::Kind coverage() const;
    /// Ready when all are.
    CompileState poll(ProgramCache&, const WarmUp&, Problems&);
    /// Share of the programs that are ready.
    double compiled() const;
    /// Source and times of all.
    ProgramStats stats() const;

    /// Draws `band` of the picture into the target, whose framebuffer is bound.
    void draw(const gl::Target&, const Coverage&, const ScreenPartition&, const Rectangle& band) const;
    /// Draws with one of them alone.
    void drawAlone(const gl::Target&, const Coverage&, const CachedProgram&, const Rectangle& band) const;

  private:
    /// The base variant leaves pixels to the full one.
    bool fallsBack() const;
    /// What it draws is marked in the coverage.
    bool marksCoverage(const CachedProgram&) const;
    bool beginVariants(ProgramCache&, Problems&);
    CompileState pollVariants(ProgramCache&, const WarmUp&, Problems&);

    Plan plan_;
    std::shared_ptr<CachedProgram> full_, sky_, base_;
    bool split_ = false;
};

} // namespace gnomon
