// Disc: the points of a plane within `radius` of `center`.
//
// ballDisc       about its centre
// distanceDisc   gradient and distance, without a sign: a disc has no inside; on it the normal
// intersectDisc  t of the plane in (ray.tMin, t) where it lies within the radius
// surfaceDisc    the point put back onto the plane; uv as in planar.glsl
// Error          band 2^-22 radius, ray 1.5 ulp, point 2 and normal 1 roundings, as docs/numerics.md names them
//                (tests/shader/intersect_test.cpp); distance 2 roundings, gradient 2 (tests/shader/distance_test.cpp;
//                measured 1.7 and 1.0)
// Source         ray re-centred on the disc (ray/split.glsl), then the plane through its centre
// Limits         normal is unit; radius > 0; a ray in the plane misses: edge-on a disc has no area
#include "primitive/planar.glsl"

struct Disc {
    vec3 center;
    float radius;
    vec3 normal;
};

Disc loadDisc(int at) {
    vec4 a = sceneTexel(at);
    return Disc(a.xyz, a.w, sceneTexel(at + 1).xyz);
}

vec4 ballDisc(Disc disc) { return vec4(disc.center, disc.radius); }

#if DISTANCES
#include "sdf/safe_direction.glsl"

vec4 distanceDisc(Disc disc, vec3 p, vec3 from) {
    vec3 offset = p - disc.center;
    float above = dot(offset, disc.normal);
    vec3 across = offset - above * disc.normal;
    float radial = length(across);
    float beyond = max(radial - disc.radius, 0.0);
    float least = length(vec2(above, beyond));
    vec3 fromRim = above * disc.normal + beyond * safeDirection(across, radial, vec3(0.0));
    return vec4(safeDirection(fromRim, least, disc.normal), least);
}
#endif

// Where the ray meets the disc's plane, relative to its centre.
vec3 discOffset(Disc disc, Ray ray, out float t) {
    NearRay near = recentre(ray.origin, disc.center, ray.direction);
    float s = planeAhead(near.origin, disc.normal, ray.direction);
    t = near.tHigh + (near.tLow + s);
    return near.origin + s * ray.direction;
}

bool intersectDisc(Disc disc, Ray ray, float side, inout float t) {
    if (side != 0.0) return false;
    float hit;
    vec3 offset = discOffset(disc, ray, hit);
    bool meets = hit > ray.tMin && hit < t && dot(offset, offset) <= disc.radius * disc.radius;
    t = meets ? hit : t;
    return meets;
}

Surface surfaceDisc(Disc disc, Ray ray, float t) {
    float again;
    vec3 offset = discOffset(disc, ray, again);
    return surfacePlanar(disc.center, disc.normal,
        offset * min(1.0, disc.radius * inversesqrt(max(dot(offset, offset), 1e-30))));
}

#if COVERS
#include "shadow/outline.glsl"

Cover coverDisc(Disc disc, LightCone cone) {
    vec3 first = abs(disc.normal.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, -1.0);
    first = normalize(first - dot(first, disc.normal) * disc.normal);
    vec3 center = across(cone, disc.center - cone.apex);
    Rim rim = Rim(center, across(cone, disc.radius * first), across(cone, disc.radius * cross(disc.normal, first)), 0.0,
        2.0 * kPi);
    return coverRims(rim, rim, true);
}
#endif
