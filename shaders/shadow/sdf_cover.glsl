// What a shape covers of a light's disc that is known by its distance only: it is marched alone, along seven cones that
// part the disc, its middle and six about it. Where a cone comes relatively nearest to the shape, at the least q =
// distance / way, the shape's side there counts as a plane, and hides one side of a line across the cone.
//
// hide$Shape  adds the shape's cover
// thick$Shape how far behind its near side a shape ends at the latest, across a direction at a point: a plane gets a
// far side,
//             so that a small solid hides no more than itself
// Source      shadows.md's sub-cones; the least q by a secant between two steps where it stops falling
// Limits      of each cone only the nearest approach counts
#if OUTPUT == STEPS
#include "sdf/count.glsl"
#endif

#include "shadow/sphere_parts.glsl"

struct Approach {
    vec3 gradient;
    float q; // distance over t
    float t;
};

#for Shape in CASTERS
#if $SHAPE_SOLID && !$SHAPE_ESTIMATED
// Where along the direction the shape is relatively nearest; q = 1 where it is not met.
Approach approach$Shape($Shape shape, vec3 apex, vec3 direction, float end, float slope) {
    const int kMostSteps = 64;
    vec4 ball = ball$Shape(shape);
    vec3 toBall = ball.xyz - apex;
    float t = max(length(toBall) - ball.w, 2e-3 * ball.w);
    end = min(end, length(toBall) + ball.w);
    float ahead = t;
    Approach nearest = Approach(-direction, 1.0, end);
    float lastT = t;
    float lastFall = 0.0; // t f' - f: below 0 where q falls
    bool counts = false;  // not yet where the ray leaves the shape's own surface
    bool between = false; // back to where q stopped falling
    for (int i = 0; i < kMostSteps && t <= end; ++i) {
#if OUTPUT == STEPS
        ++evaluations;
#endif
        vec4 f = distance$Shape(shape, apex + t * direction, apex);
        float q = f.w / t;
        float fall = t * dot(f.xyz, direction) - f.w;
        counts = counts || fall < 0.0;
        if (counts && q < nearest.q) {
            nearest = Approach(f.xyz, q, t);
        }
        bool bracketed = !between && i > 0 && lastFall < 0.0 && fall > 0.0;
        if (!between) ahead = t;
        float secant = mix(lastT, t, lastFall / min(lastFall - fall, -1e-20));
        float step = max(max(abs(f.w), 0.3 * slope * t), 1e-3 * ball.w);
        float next = between ? ahead + step : t + step;
        lastT = t;
        lastFall = between ? max(lastFall, 1e-20) : fall;
        between = bracketed;
        // The last step ends at the light itself.
        t = bracketed ? secant : (t < end ? min(next, end) : next + end);
    }
    return nearest;
}

void hide$Shape(int index, ShadowQuery query, LightCone cone, inout Shade shade) {
    $Shape shape = load$Shape(k$ShapeBase + index * k$ShapeTexels);
    float slope = cone.slope * kPartSlope;
    float area = 0.0;
    Points points = Points(uvec4(0u), uvec4(0u));
    for (int part = 0; part < 7; ++part) {
        vec2 middle = partMiddle(part);
        vec3 along = vec3(cone.slope * middle, 1.0);
        float secant = length(along);
        vec3 direction = cone.axes * along / secant;
        Approach nearest = approach$Shape(shape, cone.apex, direction, cone.distance * secant, slope);
        // The plane through the apex at q's own angle, whose normal is the gradient's part across the cone's axis.
        vec3 beside = nearest.gradient - dot(nearest.gradient, direction) * direction;
        float q = clamp(nearest.q, -1.0, 1.0);
        vec3 normal = (q * direction + sqrt(1.0 - q * q) * beside / max(length(beside), 1e-6)) * cone.axes;
        vec2 facing = cone.slope * normal.xy;
        float size = max(length(facing), 1e-12);
        float r = (normal.z + dot(facing, middle)) / (kPartSlope * size);
        // Where the shape ends on its other side, at the latest.
        float behind = thick$Shape(shape, cone.apex + nearest.t * direction, direction) / max(nearest.t, 1e-12) /
            cone.slope * length(vec3(cone.slope * middle, 1.0));
        Points near = pointsOf(halfDisc(-facing, normal.z));
        Points far = pointsOf(halfDisc(-facing, normal.z + behind * size));
        points = together(points, inBoth(without(near, far), kParts[part]));
        area += (segmentArea(r) - segmentArea(r + behind / kPartSlope)) / 7.0;
    }
    unite(shade, area, points);
}
#endif
#endfor
