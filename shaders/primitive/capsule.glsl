// Capsule: the points within `radius` of the segment from one point to another.
//
// ballCapsule       about the middle of the axis
// distanceCapsule   gradient and signed distance; on the axis a fixed direction across it
// intersectCapsule  nearest t in (ray.tMin, t); from inside the far side
// surfaceCapsule    point put back to `radius` from the segment; u runs once around, v from the tip at `to` to that at
//                   `from`
// Error             band 2^-22 size, ray 2 ulp, point 2 and normal 2 roundings, as docs/numerics.md names them
//                   (tests/shader/intersect_test.cpp); distance 2 roundings, gradient 2
//                   (tests/shader/distance_test.cpp; measured 1.7 and 1.1)
// Source            ray re-centred on the middle (ray/split.glsl), then the hull of the spans of its two spheres and of
//                   the cylinder between them (primitive/convex.glsl)
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

vec4 ballCapsule(Capsule capsule) {
    return vec4(onAxis(capsule.axis, vec3(0.0)), capsule.axis.halfLength + capsule.radius);
}

#if DISTANCES
#include "sdf/safe_direction.glsl"

vec4 distanceCapsule(Capsule capsule, vec3 p, vec3 from) {
    Axis axis = capsule.axis;
    vec3 offset = (p - axis.from) - axis.toMiddle;
    offset -= clamp(dot(offset, axis.along), -axis.halfLength, axis.halfLength) * axis.along;
    float radial = length(offset);
    return vec4(safeDirection(offset, radial, firstAcross(axis)), radial - capsule.radius);
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
    Surface surface = bareSurface(onAxis(axis, core * axis.along + capsule.radius * normal), normal,
        1.0 / capsule.radius);
#if CAPSULE_IMAGES
    float perUnit = 1.0 / (3.14159265358979 * capsule.radius + 2.0 * axis.halfLength);
    float lean = asin(clamp(dot(normal, axis.along), -1.0, 1.0));
    wrapAround(surface, axis, around(axis, across), capsule.radius, 0.5 - (core + capsule.radius * lean) * perUnit,
        perUnit);
#endif
    return surface;
}

#if COVERS
#include "shadow/outline.glsl"

// The circle where the light's rays touch the ball about one end: `outward` leads from the other end to it.
Rim touchedRim(LightCone cone, AxialView view, vec3 end, vec3 outward, float radius, float cosine) {
    vec3 m = view.toMiddle + end;
    float square = max(dot(m, m), 1e-30);
    vec3 first = outward - (dot(outward, m) / square) * m;
    first /= max(length(first), 1e-20);
    float r = radius * sqrt(max(1.0 - radius * radius / square, 0.0));
    // Where the straight edge begins.
    float from = atan(sqrt(max(1.0 - cosine * cosine, 0.0)), cosine * dot(view.towards, first));
    vec3 center = m * (1.0 - radius * radius / square);
    return Rim(across(cone, center), across(cone, r * first), across(cone, r * view.beside), -from, 2.0 * from);
}

// The balls about its ends, each by the arc on its own side of the edges that touch both.
Cover coverCapsule(Capsule capsule, LightCone cone) {
    AxialView view = axialView(capsule.axis, cone.apex);
    vec3 outward = view.along < 0.0 ? -capsule.axis.along : capsule.axis.along; // to the end nearer to the apex
    vec3 end = capsule.axis.halfLength * outward;
    float beyond = max(abs(view.along) - capsule.axis.halfLength, 0.0);
    if (length(vec2(view.radial, beyond)) <= capsule.radius) return coverFromInside();
    bool alone = view.radial <= capsule.radius; // one behind the other
    float cosine = alone ? 1.0 : capsule.radius / view.radial;
    Rim one = touchedRim(cone, view, end, alone ? view.towards : outward, capsule.radius, cosine);
    if (alone) one.sweep = 2.0 * kPi;
    Rim other = touchedRim(cone, view, -end, -outward, capsule.radius, cosine);
    other.from = -other.from;
    other.sweep = -other.sweep;
    return coverRims(one, other, alone);
}
#endif
