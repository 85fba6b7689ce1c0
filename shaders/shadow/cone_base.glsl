// Cone march whose error is epsilon of the share at every step: the marched cone is the one that leaves epsilon less.
#include "shadow/cone.glsl"
#include "shadow/share_inverse.glsl"

float met(float relative, float marched) { return relative; }
float narrower(float nearest) { return shareInverse(shareOf(nearest) - frame.coneError); }
bool dark(float nearest) { return shareOf(nearest) <= frame.coneError; }
#include "shadow/march.glsl"

float visibility(ShadowQuery query) { return shareOf(nearestAlong(coneOf(query))); }
