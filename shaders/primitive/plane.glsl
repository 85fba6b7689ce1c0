// Plane: all points p with dot(p - point, normal) = 0.
//
// distancePlane   gradient and signed distance: it divides space, and the side where `from` is not is its inside
// intersectPlane  t of the plane in (ray.tMin, t)
// Error           o + t d is within 4 ulp of |origin - point| of the plane, the surface point within 2 * 2^-23 of its
//                 distance from `point` (tests/shader/intersect_test.cpp); distance 1.5 * 2^-23 of 1 and of the way
//                 from `point`, the gradient is the normal (tests/shader/distance_test.cpp; measured 1.3)
// Source          solved about the plane's own point (docs/numerics.md)
// Limits          normal is unit; a ray in the plane misses
#include "primitive/planar.glsl"

struct Plane {
    vec3 point;
    vec3 normal;
};

Plane loadPlane(int at) { return Plane(sceneTexel(at).xyz, sceneTexel(at + 1).xyz); }

#if DISTANCES
vec4 distancePlane(Plane plane, vec3 p, vec3 from) {
    float side = dot(from - plane.point, plane.normal) < 0.0 ? -1.0 : 1.0;
    return side * vec4(plane.normal, dot(p - plane.point, plane.normal));
}
#endif

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

#if COVERS
#include "shadow/cover.glsl"

// A direction meets a plane at a height that falls linearly along it: half of the disc's own plane.
Cover coverPlane(Plane plane, LightCone cone) {
    vec3 normal = plane.normal * cone.axes;
    float height = dot(cone.apex - plane.point, plane.normal);
    if (height < 0.0) normal = -normal;
    return halfDisc(-cone.slope * normal.xy, normal.z + abs(height) / cone.distance);
}
#endif
