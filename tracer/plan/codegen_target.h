/// The GL that a shader is written for.
#pragma once

namespace gnomon {

/// The defaults are a GPU's. A software rasteriser's are told by tracer/software/tuning.h.
struct CodegenTarget {
    bool es300 = true;        ///< prelude `#version 300 es`, else `330 core`
    bool floatTargets = true; ///< the linear picture is of floats, else of their bits: shaders/pass/linear_output.glsl
    bool floatFilter = false; ///< textures of float32 can be filtered
    int blockTexels = 1024;   ///< vec4 that a uniform block holds: 16 KiB, as every GL does
    bool textureBest = false; ///< scene data is read faster from a texture than from a uniform block
    bool split = false;       ///< shader variants pay off: each pixel pays for all that its program has
    bool fallback = true;     ///< a base variant may leave pixels to the full one
    int tile = 0;             ///< side in pixels of the squares in which the full variant draws them; 0: stencil test
    /// By the loop of shadow rays, which ends by itself: shaders/integrator/shadow_rays.glsl.
    bool iterationsCounted = true;
    bool preloads = false; ///< values at fixed positions are read before all loops

    bool operator==(const CodegenTarget&) const = default;
};

} // namespace gnomon
