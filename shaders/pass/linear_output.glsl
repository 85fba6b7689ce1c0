// The linear picture, as passes write it: four float32 a pixel, neither clamped nor encoded. A GL that cannot draw to
// float textures (WebGL2 without EXT_color_buffer_float) keeps their bits in unsigned integers, which every GL can draw
// to.
//
// store   this pixel's value
#if FLOAT_TARGETS
layout(location = 0) out vec4 outLinear;
void store(vec4 value) { outLinear = value; }
#else
layout(location = 0) out uvec4 outLinear;
void store(vec4 value) { outLinear = floatBitsToUint(value); }
#endif
