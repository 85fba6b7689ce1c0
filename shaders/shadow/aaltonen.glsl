// As quilez, with the nearest point between two steps estimated from both: fewer bands.
//
// Source  S. Aaltonen, GPU-based clay simulation and ray-tracing tech in Claybook, GDC 2018
#include "shadow/cone.glsl"

float visibility(ShadowQuery query) {
    ShadowCone cone = coneOf(query);
    float slope = discSlope(query.distance, query.lightRadius);
    float taper = taperOf(cone);
    float end = endOf(cone, taper);
    float least = 1.0;
    float before = 1e20;
    float t = cone.radius;
    for (int i = 0; i < frame.shadowSteps; ++i) {
        float free = coneDistance(cone, t);
        float back = free * free / (2.0 * before);
        if (free >= before) back = 0.0; // what recedes was nearest before
        float nearer = sqrt(max(free * free - back * back, 0.0));
        float taken = 1.0 - t * taper;
        least = min(least, nearer / ((cone.radius + max(t - back, 0.0) * slope) * taken));
        if (free < 0.1 * frame.coneError * (cone.radius + t * slope) * taken) return 0.0;
        before = free;
        t += free;
        if (t >= end) break;
    }
    return clamp(least, 0.0, 1.0);
}
