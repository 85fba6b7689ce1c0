// Rotated box as textbooks have it: the baseline that shaders/primitive/rotated_box.glsl is measured against.
//
// Source  the whole ray rotated into the box' axes, then its textbook intersector
// Limits  those of primitive/box.glsl; the far origin is rotated, too, and so rounded by what it is far away
#include "primitive/box.glsl"

struct RotatedBox {
    vec3 center;
    vec3 halfSize;
    mat3 axes;
};

RotatedBox loadRotatedBox(int at) {
    mat3 axes = mat3(sceneTexel(at + 2).xyz, sceneTexel(at + 3).xyz, sceneTexel(at + 4).xyz);
    return RotatedBox(sceneTexel(at).xyz, sceneTexel(at + 1).xyz, axes);
}

Ray alongAxesOf(RotatedBox rotated, Ray ray) {
    return Ray((ray.origin - rotated.center) * rotated.axes, ray.direction * rotated.axes, ray.tMin, ray.self,
        ray.side);
}

bool intersectRotatedBox(RotatedBox rotated, Ray ray, float side, inout float t) {
    return intersectBox(Box(vec3(0.0), rotated.halfSize), alongAxesOf(rotated, ray), side, t);
}

Surface surfaceRotatedBox(RotatedBox rotated, Ray ray, float t) {
    Surface surface = surfaceBox(Box(vec3(0.0), rotated.halfSize), alongAxesOf(rotated, ray), t);
    surface.point = rotated.center + rotated.axes * surface.point;
    surface.normal = rotated.axes * surface.normal;
    return surface;
}
