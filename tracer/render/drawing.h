/// What draws one picture: a scene on the GPU, the programs for it, and settings of which numbers may change.
#pragma once

#include "tracer/render/frame_block.h"
#include "tracer/render/gpu_scene.h"
#include "tracer/settings/settings.h"
#include "tracer/software/variant_programs.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace gnomon {

struct Drawing {
    std::shared_ptr<GpuScene> scene;
    VariantPrograms trace;
    std::vector<std::shared_ptr<CachedProgram>> fullScreen; ///< in the order of pass/full_screen_table.h
    Settings settings;

    explicit operator bool() const {
        return scene && trace && !fullScreen.empty() &&
               std::all_of(fullScreen.begin(), fullScreen.end(),
                           [](const auto& pass) { return pass && pass->program; });
    }
    bool canDraw() const {
        if (!*this || (trace.plan().scene.fields && !scene->fields().usable())) return false;
        return trace.canDraw() && std::all_of(fullScreen.begin(), fullScreen.end(), [](const auto& pass) {
            return pass->state == CompileState::Ready;
        });
    }
};

/// What all drawings of a renderer share.
struct Frame {
    FrameBlock block;
    Pictures pictures;
    Problems problems; ///< found while drawing, told by the next poll
};

} // namespace gnomon
