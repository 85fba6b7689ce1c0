// Cone: a round solid that narrows from `radius` about one point, its base, to nothing at another, its apex.
//
// ballCone       about the middle of the axis
// distanceCone   gradient and signed distance; on the axis, where the side is nearest, the way around() names
// intersectCone  nearest t in (ray.tMin, t); from inside the far side
// surfaceCone    point put back onto side or base; u runs once around, v from 0 at the apex to 1 at the base; the base
//                shows uv 0 … 1 over the square about it
// Error          band 2^-21 size, ray 2 ulp, point 2 and normal 2 roundings, as docs/numerics.md names them
//                (tests/shader/intersect_test.cpp); distance 3 roundings, gradient 2 (tests/shader/distance_test.cpp;
//                measured 2.6 and 1.6)
// Source         ray re-centred on the middle (ray/split.glsl). With w below the apex, x across the axis (x1 along the
//                ray's own way across, x2 beside it) and the half angle's sine S and cosine C the side is C²x² - S²w² =
//                0, along the ray a s² + 2 b s + c. Its discriminant is C²(S²h² - a x2²) with h the ray's moment about
//                the apex in the plane of the axis and x1: nothing cancels but what tangency is made of, down to rays
//                along the side itself. The slab between base and apex keeps the right one of the two nappes
// Limits         radius > 0; base and apex differ; the normal at the apex is that of the side nearest to the ray
#include "primitive/axial.glsl"

struct Cone {
    Axis axis; // from the base to the apex
    float radius;
};

Cone loadCone(int at) {
    vec4 a = sceneTexel(at);
    return Cone(axisBetween(a.xyz, sceneTexel(at + 1).xyz), a.w);
}

vec4 ballCone(Cone cone) { return vec4(onAxis(cone.axis, vec3(0.0)), length(vec2(cone.axis.halfLength, cone.radius))); }

// Sine and cosine of the angle between axis and side.
vec2 coneAngle(Cone cone) { return normalize(vec2(cone.radius, 2.0 * cone.axis.halfLength)); }

#if DISTANCES
#include "sdf/safe_direction.glsl"

vec4 distanceCone(Cone cone, vec3 p, vec3 from) {
    AxialPoint local = axialPoint(cone.axis, p);
    vec2 angle = coneAngle(cone);
    vec2 outward = angle.yx;             // of the side, in the half plane of the axis
    vec2 upward = vec2(-angle.x, angle.y); // along the side, from the rim to the apex
    vec2 fromRim = vec2(local.radial - cone.radius, local.along + cone.axis.halfLength);
    float above = dot(fromRim, outward);
    float up = dot(fromRim, upward);
    float past = up - clamp(up, 0.0, length(vec2(cone.radius, 2.0 * cone.axis.halfLength)));
    bool under = fromRim.y < 0.0;
    bool inside = !under && above <= 0.0;
    vec2 apart = under ? vec2(max(fromRim.x, 0.0), fromRim.y) : above * outward + past * upward;
    float gap = length(apart);
    vec2 inner = above > -fromRim.y ? outward : vec2(0.0, -1.0);
    vec2 nearest = inside ? inner : safeDirection(apart, gap, inner);
    vec3 gradient = nearest.x * around(cone.axis, local.across) + nearest.y * cone.axis.along;
    return vec4(gradient, inside ? max(above, -fromRim.y) : gap);
}
#endif

// Within the side, without its ends: of the nappe about the base where the ray meets both. Solved about the ray's
// closest approach to the apex: near the apex the squares of farther points would drown it.
vec2 coneSide(Cone cone, AxialRay local) {
    vec2 angle = coneAngle(cone);
    float fromApex = local.along - cone.axis.halfLength;
    float nearest = -(dot(local.across, local.acrossStep) + fromApex * local.alongStep) /
                    (dot(local.acrossStep, local.acrossStep) + local.alongStep * local.alongStep);
    vec3 across = local.across + nearest * local.acrossStep;
    float below = -(fromApex + nearest * local.alongStep);
    float belowStep = -local.alongStep;
    float step = length(local.acrossStep);
    vec3 way = step > kParallel ? local.acrossStep / step : vec3(0.0);
    float ahead = dot(across, way);               // x1
    float beside = length(across - ahead * way);  // x2
    float h = angle.x * (ahead * belowStep - step * below);
    float radial = angle.y * length(across);
    float a = (angle.y * step - angle.x * abs(belowStep)) * (angle.y * step + angle.x * abs(belowStep));
    float b = angle.y * angle.y * ahead * step - angle.x * angle.x * below * belowStep;
    float c = (radial - angle.x * below) * (radial + angle.x * below);
    float side = sqrt(abs(a)) * beside;
    float discriminant = angle.y * angle.y * (a > 0.0 ? (abs(h) - side) * (abs(h) + side) : h * h + side * side);
    if (discriminant < 0.0) return kNever;
    if (abs(a) < kParallel) a = a < 0.0 ? -kParallel : kParallel; // along a side: the other root is far off
    // A steep ray always meets the side, at the apex at the latest.
    vec2 roots = nearest + rootsOf(a, b, c, discriminant);
    if (a > 0.0) return roots;
    return belowStep > 0.0 ? vec2(roots.y, kAlways.y) : vec2(kAlways.x, roots.x);
}

bool intersectCone(Cone cone, Ray ray, float side, inout float t) {
    if (side > 0.0) return false; // convex: what leaves it never comes back
    if (side == 0.0 && passesBy(ray, ballCone(cone))) return false;
    AxialRay local = axialRay(cone.axis, ray);
    vec2 span = commonSpan(coneSide(cone, local), slabSpan(local.along, local.alongStep, cone.axis.halfLength));
    return meetConvex(local.near, span, ray, side, t);
}

Surface surfaceCone(Cone cone, Ray ray, float t) {
    Axis axis = cone.axis;
    AxialRay local = axialRay(axis, ray);
    vec2 wall = coneSide(cone, local);
    vec2 ends = slabSpan(local.along, local.alongStep, axis.halfLength);
    float end;
    float s = spanEnd(local.near, commonSpan(wall, ends), t, end);
    vec3 across = local.across + s * local.acrossStep;
    bool atEnd = end < 0.0 ? ends.x >= wall.x : ends.y <= wall.y;
    if (atEnd && slabSide(local.along, local.alongStep, end) < 0.0) return surfaceEnd(axis, cone.radius, -1.0, across);
    vec2 angle = coneAngle(cone);
    vec3 outward = around(axis, across);
    float below = axis.halfLength - (local.along + s * local.alongStep);
    float slant = length(vec2(cone.radius, 2.0 * axis.halfLength));
    float down = clamp(angle.x * dot(across, outward) + angle.y * below, 0.0, slant); // from the apex along the side
    vec3 offset = (axis.halfLength - angle.y * down) * axis.along + angle.x * down * outward;
    float radial = max(angle.x * down, 1e-6 * cone.radius);
    Surface surface = bareSurface(onAxis(axis, offset), angle.y * outward + angle.x * axis.along, angle.y / radial);
#if CONE_IMAGES
    wrapAround(surface, axis, outward, radial, down / slant, 1.0 / slant);
#endif
    return surface;
}

#if COVERS
#include "shadow/outline.glsl"

// The base's rim, or what of it the side does not hide, and the apex.
Cover coverCone(Cone cone, LightCone light) {
    AxialView view = axialView(cone.axis, light.apex);
    vec2 angle = coneAngle(cone);
    float below = cone.axis.halfLength - view.along;
    float side = angle.x * below / max(angle.y * view.radial, 1e-20); // cosine of where the side hides itself
    bool seesBase = below > 2.0 * cone.axis.halfLength;
    if (side >= 1.0 && !seesBase) return coverFromInside();
    bool alone = abs(side) >= 1.0;
    float halfAngle = alone ? kPi : acos(side);
    vec3 end = cone.axis.halfLength * cone.axis.along;
    float sweep = seesBase && !alone ? -2.0 * (kPi - halfAngle) : 2.0 * halfAngle;
    Rim base = rimAround(light, view, -end, cone.radius, -halfAngle, sweep);
    Rim tip = rimAround(light, view, end, 0.0, 0.0, 0.0);
    return coverRims(base, tip, alone);
}
#endif
