// Disc: the points of a plane within `radius` of `center`.
//
// intersectDisc  t of the plane in (ray.tMin, t) where it lies within the radius
// Error          t: 3 ulp of |origin - center| / |cos|; edge decisions wrong only within 2^-22 of that distance
// Source         plane solved about the disc's own centre, so that the distance from the eye cancels (docs/numerics.md)
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

bool intersectDisc(Disc disc, Ray ray, float side, inout float t) {
    if (side != 0.0) return false;
    float hit = meetPlane(disc.center, disc.normal, ray);
    vec3 offset = (ray.origin - disc.center) + hit * ray.direction;
    if (!(hit > ray.tMin && hit < t && dot(offset, offset) <= disc.radius * disc.radius)) return false;
    t = hit;
    return true;
}

Surface surfaceDisc(Disc disc, Ray ray, float t) { return surfacePlanar(disc.center, disc.normal, ray, t); }
