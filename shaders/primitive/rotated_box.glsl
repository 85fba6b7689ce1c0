// RotatedBox: a box along three axes of its own. Scene files say "box" and rotate it, or a group around it does.
//
// ballRotatedBox, distanceRotatedBox, intersectRotatedBox, surfaceRotatedBox   as of a box, which all is asked of as
//                 its own axes see it
// Error           band 2^-22 size, ray 1.5 ulp, point 2 and normal 1 roundings, as docs/numerics.md names them
//                 (tests/shader/intersect_test.cpp); distance 2.5 roundings, gradient 3
//                 (tests/shader/distance_test.cpp; measured 1.9 and 1.1)
// Source          ray re-centred on the box (ray/split.glsl) before it is rotated, so that only the box's own size
//                 counts
// Limits          those of a box
#include "primitive/box.glsl"

struct RotatedBox {
    vec3 center;
    Box box; // about 0, along the axes
    mat3 axes; // as columns: axes * v rotates v, v * axes rotates it back
};

RotatedBox loadRotatedBox(int at) {
    mat3 axes = mat3(sceneTexel(at + 2).xyz, sceneTexel(at + 3).xyz, sceneTexel(at + 4).xyz);
    return RotatedBox(sceneTexel(at).xyz, Box(vec3(0.0), sceneTexel(at + 1).xyz), axes);
}

vec4 ballRotatedBox(RotatedBox rotated) { return vec4(rotated.center, length(rotated.box.halfSize)); }

#if DISTANCES
vec4 distanceRotatedBox(RotatedBox rotated, vec3 p, vec3 from) {
    vec4 distance = distanceBox(rotated.box, (p - rotated.center) * rotated.axes, from);
    return vec4(rotated.axes * distance.xyz, distance.w);
}
#endif

bool intersectRotatedBox(RotatedBox rotated, Ray ray, float side, inout float t) {
    NearRay near = recentre(ray.origin, rotated.center, ray.direction);
    vec3 enter, leave;
    boxSlabs(rotated.box, near.origin * rotated.axes, ray.direction * rotated.axes, enter, leave);
    return meetConvex(near, boxSpan(enter, leave), ray, side, t);
}

Surface surfaceRotatedBox(RotatedBox rotated, Ray ray, float t) {
    NearRay near = recentre(ray.origin, rotated.center, ray.direction);
    Ray local = Ray(near.origin * rotated.axes, ray.direction * rotated.axes, ray.tMin, ray.self, ray.side);
    Surface surface = surfaceBox(rotated.box, local, (t - near.tHigh) - near.tLow);
    surface.point = rotated.center + rotated.axes * surface.point;
    surface.normal = rotated.axes * surface.normal;
#if ROTATED_BOX_IMAGES
    surface.tangent = rotated.axes * surface.tangent;
#endif
    return surface;
}

#if COVERS
Cover coverRotatedBox(RotatedBox rotated, LightCone cone) {
    vec3 apex = (cone.apex - rotated.center) * rotated.axes;
    return coverBox(rotated.box, LightCone(apex, transpose(rotated.axes) * cone.axes, cone.slope, cone.distance));
}
#endif
