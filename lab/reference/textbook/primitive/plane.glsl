// Plane as textbooks have it: the baseline that shaders/primitive/plane.glsl is measured against.
//
// Source  dot(normal, o + t d) = dot(normal, point)
// Limits  both sides of the equation are of the size of the distance from the world's origin, and so is the error.
//         An epsilon keeps rays off their own start; side is ignored
#include "primitive/planar.glsl"

struct Plane {
    vec3 point;
    vec3 normal;
};

Plane loadPlane(int at) { return Plane(sceneTexel(at).xyz, sceneTexel(at + 1).xyz); }

bool intersectPlane(Plane plane, Ray ray, float side, inout float t) {
    float facing = dot(plane.normal, ray.direction);
    if (abs(facing) < 1e-6) return false;
    float hit = (dot(plane.normal, plane.point) - dot(plane.normal, ray.origin)) / facing;
    if (!(hit > max(ray.tMin, 1e-4) && hit < t)) return false;
    t = hit;
    return true;
}

Surface surfacePlane(Plane plane, Ray ray, float t) {
    vec3 point = ray.origin + t * ray.direction;
    Surface surface = surfacePlanar(plane.point, plane.normal, point - plane.point);
    surface.point = point;
    return surface;
}
