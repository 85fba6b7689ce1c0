// Disc: the points of a plane within `radius` of `center`.
//
// ballDisc       about its centre
// intersectDisc  t of the plane in (ray.tMin, t) where it lies within the radius
// surfaceDisc    the point put back onto the plane; uv as in planar.glsl
// Error          band 2^-22 radius, ray 1.5 ulp, point 2 and normal 1 roundings, as docs/numerics.md names them
//                (tests/shader/intersect_test.cpp)
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

// Where the ray meets the disc's plane, relative to its centre.
vec3 discOffset(Disc disc, Ray ray, out float t) {
    NearRay near = recentre(ray.origin, disc.center, ray.direction);
    float s = planeAhead(near.origin, disc.normal, ray.direction);
    t = near.tHigh + (near.tLow + s);
    return near.origin + s * ray.direction;
}

bool intersectDisc(Disc disc, Ray ray, float side, inout float t) {
    if (side != 0.0 || passesBy(ray, ballDisc(disc))) return false;
    float hit;
    vec3 offset = discOffset(disc, ray, hit);
    if (!(hit > ray.tMin && hit < t && dot(offset, offset) <= disc.radius * disc.radius)) return false;
    t = hit;
    return true;
}

Surface surfaceDisc(Disc disc, Ray ray, float t) {
    float again;
    vec3 offset = discOffset(disc, ray, again);
    return surfacePlanar(disc.center, disc.normal, offset * min(1.0, disc.radius * inversesqrt(max(dot(offset, offset), 1e-30))));
}
