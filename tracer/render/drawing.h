/// What draws one picture: a scene on the GPU, the programs for it, and settings of which numbers may change.
#pragma once

#include "tracer/render/frame_block.h"
#include "tracer/render/gpu_scene.h"
#include "tracer/settings/settings.h"
#include "tracer/software/variant_programs.h"

#include <memory>

namespace gnomon {

struct Drawing {
    std::shared_ptr<GpuScene> scene;
    VariantPrograms trace;
    std::shared_ptr<CachedProgram> resolve;
    Settings settings;

    explicit operator bool() const { return scene && trace && resolve && resolve->program; }
    bool canDraw() const { return *this && trace.canDraw() && resolve->state == CompileState::Ready; }
};

/// What all drawings of a renderer share.
struct Frame {
    FrameBlock block;
    Pictures pictures;
    Problems problems; ///< found while drawing, told by the next poll
};

} // namespace gnomon
