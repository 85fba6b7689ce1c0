/// What shaders do otherwise where the GL is a software rasteriser.
#pragma once

#include "tracer/gl/gl.h"
#include "tracer/plan/codegen_target.h"

namespace gnomon {

enum class Rasteriser {
    Gpu,
    Llvmpipe,   ///< and every other that we do not know better
    SwiftShader ///< Chromium's: draws a pixel before it tests depth or stencil
};

/// `target`, for such a GL whose largest point is `mostPoint` pixels wide.
CodegenTarget tunedFor(Rasteriser, int mostPoint = 64, CodegenTarget target = {});

/// What shaders are written for where the GL is this one.
CodegenTarget targetOf(const gl::Info&);

} // namespace gnomon
