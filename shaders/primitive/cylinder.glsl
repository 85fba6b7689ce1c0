// Cylinder: the points within `radius` of the line from one point to another, between the two planes across its ends.
//
// ballCylinder       about the middle of the axis
// distanceCylinder   gradient and signed distance; on the axis, where the side is nearest, the way around() names
// intersectCylinder  nearest t in (ray.tMin, t); from inside the far side
// surfaceCylinder    point put back onto side or end; u runs once around, v from 0 at `to` to 1 at `from`; each end
//                    shows uv 0 … 1 over the square about it
// Error              band 2^-22 size, ray 1.5 ulp, point 2 and normal 2 roundings, as docs/numerics.md names them
//                    (tests/shader/intersect_test.cpp); distance 2.5 roundings, gradient 2
//                    (tests/shader/distance_test.cpp; measured 2.2 and 1.1)
// Source             ray re-centred on the middle (ray/split.glsl), then the common part of a round span across the
//                    axis and a slab along it (primitive/convex.glsl)
// Limits             radius > 0; from and to differ
#include "primitive/axial.glsl"

struct Cylinder {
    Axis axis;
    float radius;
};

Cylinder loadCylinder(int at) {
    vec4 a = sceneTexel(at);
    return Cylinder(axisBetween(a.xyz, sceneTexel(at + 1).xyz), a.w);
}

vec4 ballCylinder(Cylinder cylinder) {
    return vec4(onAxis(cylinder.axis, vec3(0.0)), length(vec2(cylinder.axis.halfLength, cylinder.radius)));
}

#if DISTANCES
#include "sdf/safe_direction.glsl"

vec4 distanceCylinder(Cylinder cylinder, vec3 p, vec3 from) {
    AxialPoint local = axialPoint(cylinder.axis, p);
    float top = local.along < 0.0 ? -1.0 : 1.0;
    vec2 beyond = vec2(local.radial - cylinder.radius, abs(local.along) - cylinder.axis.halfLength);
    vec2 outside = max(beyond, 0.0);
    float gap = length(outside);
    vec2 nearest = safeDirection(outside, gap, beyond.x > beyond.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
    vec3 gradient = nearest.x * around(cylinder.axis, local.across) + top * nearest.y * cylinder.axis.along;
    return vec4(gradient, gap + min(max(beyond.x, beyond.y), 0.0));
}
#endif

bool intersectCylinder(Cylinder cylinder, Ray ray, float side, inout float t) {
    if (side > 0.0) return false; // convex: what leaves it never comes back
    if (side == 0.0 && passesBy(ray, ballCylinder(cylinder))) return false;
    AxialRay local = axialRay(cylinder.axis, ray);
    vec2 span = commonSpan(roundSpan(local.across, local.acrossStep, cylinder.radius),
                           endsSpan(cylinder.axis, local, ray.direction));
    return meetConvex(local.near, span, ray, side, t);
}

Surface surfaceCylinder(Cylinder cylinder, Ray ray, float t) {
    Axis axis = cylinder.axis;
    AxialRay local = axialRay(axis, ray);
    vec2 wall = roundSpan(local.across, local.acrossStep, cylinder.radius);
    vec2 ends = endsSpan(axis, local, ray.direction);
    float end;
    float s = spanEnd(local.near, commonSpan(wall, ends), t, end);
    vec3 across = local.across + s * local.acrossStep;
    if (end < 0.0 ? ends.x >= wall.x : ends.y <= wall.y)
        return surfaceEnd(axis, cylinder.radius, slabSide(local.along, local.alongStep, end), across);
    vec3 normal = around(axis, across);
    float along = clamp(local.along + s * local.alongStep, -axis.halfLength, axis.halfLength);
    vec3 offset = along * axis.along + cylinder.radius * normal;
    Surface surface = bareSurface(onAxis(axis, offset), normal, 1.0 / cylinder.radius);
#if CYLINDER_IMAGES
    float perUnit = 0.5 / axis.halfLength;
    wrapAround(surface, axis, normal, cylinder.radius, 0.5 - along * perUnit, perUnit);
#endif
    return surface;
}

#if COVERS
#include "shadow/outline.glsl"

// The two ends' rims, each by the half that is seen against the light: of an end that faces the apex the one behind.
Cover coverCylinder(Cylinder cylinder, LightCone cone) {
    AxialView view = axialView(cylinder.axis, cone.apex);
    vec3 end = cylinder.axis.halfLength * cylinder.axis.along;
    float beyond = abs(view.along) - cylinder.axis.halfLength;
    bool within = view.radial <= cylinder.radius;
    if (within && beyond <= 0.0) return coverFromInside();
    float halfAngle = within ? kPi : acos(cylinder.radius / view.radial);
    vec3 first = view.along < 0.0 ? -end : end; // of the two the one nearer to the apex
    float sweep = beyond > 0.0 && !within ? -2.0 * (kPi - halfAngle) : 2.0 * halfAngle;
    Rim one = rimAround(cone, view, first, cylinder.radius, -halfAngle, sweep);
    Rim other = rimAround(cone, view, -first, cylinder.radius, halfAngle, -2.0 * halfAngle);
    return coverRims(one, other, within);
}
#endif
