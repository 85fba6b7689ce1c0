// Soft shadow by sphere traces to points of the light's disc: Monte Carlo where a scene is known by its distances only,
// as the source document has it beside its cones.
//
// kMet    a trace has met something where less than this fraction of the surface sphere's radius is free, or what
//         float32 resolves of the coordinates. A smaller one lessens no error; 0.1 adds a tenth to that of one sample
//         in the scene `simple`
// Error   that of few samples (shadow/samples.glsl). Besides, traces start at the surface sphere's centre as cones do,
//         half a pixel above the surface, which moves shadows: .013 RMSE in `simple` at 160x120, .004 at 640x480
//         (docs/shadows.md)
// Limits  when the steps run out nothing was met; where distances are estimates a short one is taken for something met
// Source  J. Hart, Sphere Tracing, 1996; the source document of one-ray soft shadows
#include "shadow/cone.glsl"

const float kMet = 0.03;

bool hidden(ShadowQuery toPoint) {
    ShadowCone cone = coneOf(toPoint);
#if DIRECTIONAL
    float met = max(kMet * cone.radius, 1e-6 * dot(abs(cone.start), vec3(1.0))); // a light may be at no distance
#else
    float met = max(kMet * cone.radius, 1e-6 * (dot(abs(cone.start), vec3(1.0)) + cone.reach));
#endif
    float taper = taperOf(cone);
    float end = endOf(cone, taper);
    float t = 0.0;
    for (int i = 0; i < frame.shadowSteps && t < end; ++i) {
        float free = coneDistance(cone, t);
        if (free < met * (1.0 - t * taper)) return true;
        t += free;
    }
    return false;
}
#include "shadow/samples.glsl"
