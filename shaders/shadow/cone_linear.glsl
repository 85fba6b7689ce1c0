// Cone march with equal steps of the relative radius: the fraction is worked out once, at the end.
#include "shadow/cone.glsl"
#include "shadow/linear.glsl"

float met(float relative, float marched) { return relative; }
#include "shadow/march.glsl"

float visibility(ShadowQuery query) { return fractionOf(nearestAlong(coneOf(query))); }
