// Capsule: the points within `radius` of the stretch from one point to another.
//
// ballCapsule       about the middle of the axis
// distanceCapsule   gradient and signed distance; on the axis a fixed direction across it
// intersectCapsule  nearest t in (ray.tMin, t); from inside the far side
// surfaceCapsule    point put back to `radius` from the stretch; u runs once around, v from the tip at `to` to that at `from`
// Error             band 2^-22 size, ray 2 ulp, point 2 and normal 2 roundings, as docs/numerics.md names them
//                   (tests/shader/intersect_test.cpp); distance 2 roundings, gradient 2 (tests/shader/distance_test.cpp;
//                   measured 1.7 and 1.1)
// Source            ray re-centred on the middle (ray/split.glsl), then the hull of the spans of its two spheres and of the
//                   cylinder between them (primitive/convex.glsl)
// Limits            radius > 0; from and to differ
#include "primitive/axial.glsl"

struct Capsule {
    Axis axis;
    float radius;
};

Capsule loadCapsule(int at) {
    vec4 a = sceneTexel(at);
    return Capsule(axisBetween(a.xyz, sceneTexel(at + 1).xyz), a.w);
}

vec4 ballCapsule(Capsule capsule) { return vec4(onAxis(capsule.axis, vec3(0.0)), capsule.axis.halfLength + capsule.radius); }

#if DISTANCES
#include "sdf/away.glsl"

vec4 distanceCapsule(Capsule capsule, vec3 p, vec3 from) {
    Axis axis = capsule.axis;
    vec3 offset = (p - axis.from) - axis.toMiddle;
    offset -= clamp(dot(offset, axis.along), -axis.halfLength, axis.halfLength) * axis.along;
    float away = length(offset);
    return vec4(awayFrom(offset, away, firstAcross(axis)), away - capsule.radius);
}
#endif

vec2 capsuleSpan(Capsule capsule, AxialRay local, vec3 direction) {
    vec3 tip = capsule.axis.halfLength * capsule.axis.along;
    vec2 wall = commonSpan(roundSpan(local.across, local.acrossStep, capsule.radius),
                           slabSpan(local.along, local.alongStep, capsule.axis.halfLength));
    vec2 tips = hullSpan(roundSpan(local.near.origin - tip, direction, capsule.radius),
                         roundSpan(local.near.origin + tip, direction, capsule.radius));
    return hullSpan(wall, tips);
}

bool intersectCapsule(Capsule capsule, Ray ray, float side, inout float t) {
    if (side > 0.0) return false; // convex: what leaves it never comes back
    if (side == 0.0 && passesBy(ray, ballCapsule(capsule))) return false;
    AxialRay local = axialRay(capsule.axis, ray);
    return meetConvex(local.near, capsuleSpan(capsule, local, ray.direction), ray, side, t);
}

Surface surfaceCapsule(Capsule capsule, Ray ray, float t) {
    Axis axis = capsule.axis;
    AxialRay local = axialRay(axis, ray);
    float end;
    float s = spanEnd(local.near, capsuleSpan(capsule, local, ray.direction), t, end);
    float along = local.along + s * local.alongStep;
    float core = clamp(along, -axis.halfLength, axis.halfLength);
    vec3 across = local.across + s * local.acrossStep;
    vec3 normal = normalize(across + (along - core) * axis.along);
    Surface surface = bareSurface(onAxis(axis, core * axis.along + capsule.radius * normal), normal, 1.0 / capsule.radius);
#if IMAGES
    float perUnit = 1.0 / (3.14159265358979 * capsule.radius + 2.0 * axis.halfLength);
    float lean = asin(clamp(dot(normal, axis.along), -1.0, 1.0));
    wrapAround(surface, axis, around(axis, across), capsule.radius, 0.5 - (core + capsule.radius * lean) * perUnit, perUnit);
#endif
    return surface;
}
