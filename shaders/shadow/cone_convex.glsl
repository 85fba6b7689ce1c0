// The linear march with longer steps: a convex object lies behind the plane across the way to its nearest point, and
// the marched cone may continue until it touches that plane. Kinds that are not convex keep their distance; so do all
// once the marched cone is thinner than nothing.
//
// convexStep  how far the cone of relative radius `marched` can go from `at` without touching an object, and the
//             distance of the nearest
// Source      J. Hart, Sphere Tracing, 1994; the source document's convex variant
#include "shadow/cone.glsl"
#include "shadow/linear.glsl"

float convexStep(ShadowCone cone, float at, float towards, float marched, out float free) {
#if OUTPUT == STEPS
    ++evaluations;
#endif
    vec3 p = cone.start + at * cone.axis;
    float wide = marched * coneRadius(cone, at);
    float widening = marched * cone.slope * towards;
    float step = 1e30;
    free = 1e30;
#for Shape in CASTERS
    for (int i = 0; i < k$ShapeCasters; ++i) {
        vec4 field = distance$Shape(load$Shape(k$ShapeBase + i * k$ShapeTexels), p, cone.start);
        free = min(free, field.w);
#if $SHAPE_CONVEX
        float closing = widening - towards * dot(field.xyz, cone.axis);
        float clear = marched >= 0.0 ? (closing > 0.0 ? (field.w - wide) / closing : 1e30)
            : (field.w - wide) / (1.0 + abs(widening));
#else
        float clear = (field.w - wide) / (1.0 + abs(widening));
#endif
        step = min(step, clear);
    }
#endfor
    return step;
}

float visibility(ShadowQuery query) {
    ShadowCone cone = coneOf(query);
    float nearest = 1.0;
    float marched = narrower(nearest);
    float t = 0.0;
    for (int i = 0; i < frame.shadowSteps; ++i) {
#if FROM_LIGHT
        float at = cone.reach - t;
        const float towards = -1.0;
#else
        float at = t;
        const float towards = 1.0;
#endif
        float free;
        float radius = coneRadius(cone, at);
        float step = convexStep(cone, at, towards, marched, free);
        if (free < nearest * radius) {
            nearest = free / radius;
            marched = narrower(nearest);
        }
        if (dark(nearest)) break;
        t += max(step, max(free - radius * marched, 0.0) / (1.0 + abs(marched * cone.slope)));
        if (t >= cone.reach) break;
    }
    return fractionOf(nearest);
}
