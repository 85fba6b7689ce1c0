/// The programs that draw one picture: the whole one, and beside it those that draw what they can of it at less cost
/// (tracer/shader/parts.h). The whole one draws alone until they are ready.
#pragma once

#include "tracer/render/program_cache.h"
#include "tracer/render/regions.h"

#include <functional>
#include <memory>

namespace gnomon {

class Programs {
  public:
    using WarmUp = std::function<void(const CachedProgram&)>;

    Programs() = default;
    /// Begins to build the whole one, where it is new; its parts follow when it is ready.
    Programs(const Features&, ProgramCache&, Problems&);

    /// There is something to draw with, soon or now.
    explicit operator bool() const { return whole_ != nullptr; }
    const CachedProgram& whole() const { return *whole_; }
    const Features& features() const { return features_; }
    bool canDraw() const { return whole_ && whole_->state == ProgramState::Ready; }
    /// Smaller programs draw, too.
    bool parted() const { return parted_; }
    /// One of them leaves pixels to the whole one: targets note what is drawn.
    bool leaves() const;
    /// Ready when all are.
    ProgramState poll(ProgramCache&, const WarmUp&, Problems&);
    /// Source and times of all.
    ProgramStats stats() const;

    /// Draws `band` of the picture into the target, whose framebuffer is bound.
    void draw(const gl::Target&, const Regions&, const Rectangle& band) const;
    /// Draws with one of them alone.
    void drawAlone(const gl::Target&, const CachedProgram&, const Rectangle& band) const;

  private:
    /// What it draws is noted in the target.
    bool notes(const CachedProgram&) const;
    bool beginParts(ProgramCache&, Problems&);
    ProgramState pollParts(ProgramCache&, const WarmUp&, Problems&);

    Features features_;
    std::shared_ptr<CachedProgram> whole_, sky_, usual_;
    bool parted_ = false;
};

} // namespace gnomon
