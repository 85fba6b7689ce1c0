// The linear picture (pass/linear_output.glsl) that the pass before left, of the size of what is drawn.
//
// loadLinear   the pixel about `at`, in pixels as gl_FragCoord counts; beyond the edge, the one at the edge
//
// textureLod, as llvmpipe works out the level's size in each lane for texelFetch.
#if FLOAT_TARGETS
uniform sampler2D picture;
vec4 loadLinear(vec2 at) { return textureLod(picture, at / frame.canvas, 0.0); }
#else
uniform highp usampler2D picture;
vec4 loadLinear(vec2 at) { return uintBitsToFloat(textureLod(picture, at / frame.canvas, 0.0)); }
#endif
