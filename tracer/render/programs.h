/// The programs that draw one picture: the whole one, and beside it those that draw what they can of it at less cost
/// (tracer/software/uncommon_features.h). The whole one draws alone until they are ready.
#pragma once

#include "tracer/render/program_cache.h"
#include "tracer/software/screen_partition.h"

#include <functional>
#include <memory>

namespace gnomon {

class Programs {
  public:
    using WarmUp = std::function<void(const CachedProgram&)>;

    Programs() = default;
    /// Begins to build the whole one, where it is new; its parts follow when it is ready.
    Programs(const Plan&, ProgramCache&, Problems&);

    /// There is something to draw with, soon or now.
    explicit operator bool() const { return full_ != nullptr; }
    const CachedProgram& full() const { return *full_; }
    const Plan& plan() const { return plan_; }
    bool canDraw() const { return full_ && full_->state == ProgramState::Ready; }
    /// Smaller programs draw, too.
    bool parted() const { return parted_; }
    /// One of them leaves pixels to the whole one: targets note what is drawn.
    bool fallsBack() const;
    /// Ready when all are.
    ProgramState poll(ProgramCache&, const WarmUp&, Problems&);
    /// Source and times of all.
    ProgramStats stats() const;

    /// Draws `band` of the picture into the target, whose framebuffer is bound.
    void draw(const gl::Target&, const ScreenPartition&, const Rectangle& band) const;
    /// Draws with one of them alone.
    void drawAlone(const gl::Target&, const CachedProgram&, const Rectangle& band) const;

  private:
    /// What it draws is noted in the target.
    bool marksCoverage(const CachedProgram&) const;
    bool beginParts(ProgramCache&, Problems&);
    ProgramState pollParts(ProgramCache&, const WarmUp&, Problems&);

    Plan plan_;
    std::shared_ptr<CachedProgram> full_, sky_, base_;
    bool parted_ = false;
};

} // namespace gnomon
