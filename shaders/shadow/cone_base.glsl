// Cone march whose error is epsilon of the fraction at every step: the marched cone leaves epsilon less.
#include "shadow/cone.glsl"
#include "shadow/fraction_inverse.glsl"

float met(float relative, float marched) { return relative; }
float narrower(float nearest) { return fractionInverse(fractionOf(nearest) - frame.coneError); }
bool dark(float nearest) { return fractionOf(nearest) <= frame.coneError; }
#include "shadow/march.glsl"

float visibility(ShadowQuery query) { return fractionOf(nearestAlong(coneOf(query))); }
