// Cone march down a ladder of shares epsilon apart: whatever comes nearer takes one rung.
#include "shadow/cone.glsl"
#include "shadow/share_inverse.glsl"

float met(float relative, float marched) { return marched; }
float narrower(float nearest) { return shareInverse(shareOf(nearest) - frame.coneError); }
bool dark(float nearest) { return shareOf(nearest) <= frame.coneError; }
#include "shadow/march.glsl"

float visibility(ShadowQuery query) { return shareOf(nearestAlong(coneOf(query))); }
