// Plane: all points p with dot(p - point, normal) = 0.
//
// intersectPlane  t of the plane in (ray.tMin, t)
// Error           o + t d is within 4 ulp of |origin - point| of the plane, the surface point within 2 * 2^-23 of its distance
//                 from `point` (tests/shader/intersect_test.cpp)
// Source          solved about the plane's own point (docs/numerics.md)
// Limits          normal is unit; a ray in the plane misses
#include "primitive/planar.glsl"

struct Plane {
    vec3 point;
    vec3 normal;
};

Plane loadPlane(int at) { return Plane(sceneTexel(at).xyz, sceneTexel(at + 1).xyz); }

bool intersectPlane(Plane plane, Ray ray, float side, inout float t) {
    if (side != 0.0) return false;
    float hit = planeAhead(ray.origin - plane.point, plane.normal, ray.direction);
    if (!(hit > ray.tMin && hit < t)) return false;
    t = hit;
    return true;
}

Surface surfacePlane(Plane plane, Ray ray, float t) {
    return surfacePlanar(plane.point, plane.normal, (ray.origin - plane.point) + t * ray.direction);
}
