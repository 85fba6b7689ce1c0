// Gradient descent of a fixed rate.
#include "field/patch.glsl"

vec2 stepAgainst(vec2 g, inout vec2 first, inout vec2 second, vec2 powers) { return g; }

#include "field/descents.glsl"
