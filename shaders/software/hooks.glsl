// All that exists only for software rasterisers, llvmpipe and SwiftShader, lies in this folder. The library's other
// files call it in the places below, one line each; with its feature off (tracer/plan/codegen_target.h) each call is
// what a GPU would be given anyway.
//
// beforePixel, afterPixel   pass/trace.frag                     PRELOADS, FALLBACK
// lightPosition             integrator/shadow_rays.glsl         PRELOADS: light_position.glsl
// fallsBack                 integrator/whitted.glsl and shadow_rays.glsl   FALLBACK: fallback.glsl
// noteUncommon              ray/nearest.glsl                    FALLBACK: fallback.glsl
// markCovered               pass/trace.frag and sky.frag        COVERAGE_MASK: coverage_mask.glsl
// placeTile                 pass/canvas.vert                    TILES: tiles.glsl
//
// Loops whose ends are tested at their ends, and ITERATIONS_COUNTED in integrator/shadow_rays.glsl, stay where they
// are: they are the shape of a loop that has to be written one way or the other.
#if PRELOADS
#include "software/preloads.glsl"
vec4 preloaded;
#endif

void beforePixel() {
#if PRELOADS
    preloaded = preload();
#endif
}

vec4 afterPixel(vec4 value) {
#if FALLBACK
    if (fallsBack()) discard;
#endif
#if PRELOADS
    return frame.zero.x == 0u ? value : preloaded;
#else
    return value;
#endif
}
