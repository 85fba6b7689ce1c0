// Soft shadow of one sphere trace to the light's centre: the least of distance over the light's cone, 0 where it is
// met. Takes the inner half of the penumbra for full shadow.
//
// Source  I. Quilez, Free penumbra shadows for raymarching distance fields, 2010
#include "shadow/cone.glsl"

float visibility(ShadowQuery query) {
    ShadowCone cone = coneOf(query);
    float slope = discSlope(query.distance, query.lightRadius);
    float taper = taperOf(cone);
    float end = endOf(cone, taper);
    float least = 1.0;
    float t = cone.radius;
    for (int i = 0; i < frame.shadowSteps; ++i) {
        float free = coneDistance(cone, t);
        float wide = (cone.radius + t * slope) * (1.0 - t * taper);
        least = min(least, free / wide);
        if (least < frame.coneError * 0.1) return 0.0;
        t += free;
        if (t >= end) break;
    }
    return clamp(least, 0.0, 1.0);
}
