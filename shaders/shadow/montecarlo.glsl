// Soft shadow by rays to points of the light's disc.
//
// Error  that of few samples (shadow/samples.glsl); unbiased, so with enough of them it is the reference of the others
bool hidden(ShadowQuery toPoint) { return occluded(toPoint.ray, toPoint.distance - toPoint.ray.tMin); }
#include "shadow/samples.glsl"
