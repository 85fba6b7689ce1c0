// Cone march down a ladder of shares epsilon apart: whatever comes nearer takes one rung.
#include "shadow/cone.glsl"
#include "shadow/fraction_inverse.glsl"

float met(float relative, float marched) { return marched; }
float narrower(float nearest) { return fractionInverse(fractionOf(nearest) - frame.coneError); }
bool dark(float nearest) { return fractionOf(nearest) <= frame.coneError; }
#include "shadow/march.glsl"

float visibility(ShadowQuery query) { return fractionOf(nearestAlong(coneOf(query))); }
