// Disc as textbooks have it: the baseline that shaders/primitive/disc.glsl is measured against.
//
// Source  the plane dot(normal, o + t d) = dot(normal, center), then the distance of o + t d from the centre
// Limits  the rim is off by the rounding of o + t d. An epsilon keeps rays off their own start; side is ignored
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
    float facing = dot(disc.normal, ray.direction);
    if (abs(facing) < 1e-6) return false;
    float hit = (dot(disc.normal, disc.center) - dot(disc.normal, ray.origin)) / facing;
    vec3 offset = ray.origin + hit * ray.direction - disc.center;
    if (!(hit > max(ray.tMin, 1e-4) && hit < t) || dot(offset, offset) > disc.radius * disc.radius) return false;
    t = hit;
    return true;
}

Surface surfaceDisc(Disc disc, Ray ray, float t) {
    vec3 point = ray.origin + t * ray.direction;
    Surface surface = surfacePlanar(disc.center, disc.normal, point - disc.center);
    surface.point = point;
    return surface;
}
