// Soft shadow by rays to points of the light's disc.
//
// Error  that of few samples (shadow/samples.glsl); unbiased, so with enough of them it is the reference of the others
//
// kRounding  of coordinates and distance, short of the light: what it lies on is no occluder
const float kRounding = 1e-6;

bool hidden(ShadowQuery toPoint) {
    float rounding = kRounding * (dot(abs(toPoint.ray.origin), vec3(1.0)) + toPoint.distance);
    return occluded(toPoint.ray, toPoint.distance - rounding - toPoint.ray.tMin);
}
#include "shadow/samples.glsl"
