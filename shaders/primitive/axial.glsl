// What the shapes about an axis share: the axis between two points, and a ray seen from it.
//
// axialRay    the ray re-centred on the middle of the axis and split into its parts along and across it
// endsSpan    between the two planes across the ends. Along `toMiddle` as it is: a unit axis is rounded, and where an
//             end is met, along the ray, would be less exact the farther away it is
// onAxis      the point of the world at an offset from the middle
// axialPoint  a point's parts along and across it, from the middle
// around      unit direction from the axis to a point; any where the point lies on the axis
// Error       parts across: 2^-23 of the distance from the middle of the axis
// Limits      the two points differ
#include "primitive/convex.glsl"

struct Axis {
    vec3 from;
    vec3 toMiddle; // from there: far from the world's origin the middle itself may lie between two float32 numbers
    vec3 along;    // unit
    float halfLength;
};

struct AxialRay {
    NearRay near;
    vec3 across;     // of near.origin
    vec3 acrossStep; // of the direction
    float along;
    float alongStep;
};

Axis axisBetween(vec3 from, vec3 to) {
    vec3 toMiddle = 0.5 * (to - from);
    float halfLength = length(toMiddle);
    return Axis(from, toMiddle, toMiddle / halfLength, halfLength);
}

vec3 onAxis(Axis axis, vec3 offset) { return axis.from + (axis.toMiddle + offset); }

AxialRay axialRay(Axis axis, Ray ray) {
    vec3 middle = optimisationBarrier(axis.from + axis.toMiddle);
    NearRay near = recentre(ray.origin, middle, ray.direction);
    near.origin -= lostBy(middle, axis.from, -axis.toMiddle);
    float along = dot(near.origin, axis.along);
    float alongStep = dot(ray.direction, axis.along);
    return AxialRay(near, near.origin - along * axis.along, ray.direction - alongStep * axis.along, along, alongStep);
}

vec2 endsSpan(Axis axis, AxialRay ray, vec3 direction) {
    vec3 along = axis.toMiddle;
    return slabSpan(dot(ray.near.origin, along), dot(direction, along), dot(along, along));
}

#if DISTANCES
struct AxialPoint {
    vec3 across;
    float radial; // its length
    float along;
};

AxialPoint axialPoint(Axis axis, vec3 p) {
    vec3 offset = (p - axis.from) - axis.toMiddle;
    float along = dot(offset, axis.along);
    vec3 across = offset - along * axis.along;
    return AxialPoint(across, length(across), along);
}
#endif

// The world axis least along the shape's, laid across it; +x wherever the axis is not mostly x.
vec3 firstAcross(Axis axis) {
    vec3 first = abs(axis.along.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, -1.0);
    return normalize(first - dot(first, axis.along) * axis.along);
}

vec3 around(Axis axis, vec3 across) {
    across -= dot(across, axis.along) * axis.along; // what rounding left along the axis counts close to it
    float radial = length(across);
    return radial > 1e-15 ? across / radial : firstAcross(axis); // squares of shorter ones leave float32
}

// A flat end: the point at +-halfLength (`top`) of the axis, kept within the radius.
Surface surfaceEnd(Axis axis, float radius, float top, vec3 across) {
    across *= min(1.0, radius / max(length(across), 1e-30));
    vec3 normal = top * axis.along;
    Surface surface = bareSurface(onAxis(axis, axis.halfLength * normal + across), normal, 0.0);
#if IMAGES
    surface.tangent = firstAcross(axis);
    surface.uv = 0.5 + 0.5 * vec2(dot(across, surface.tangent), dot(across, cross(surface.tangent, normal))) / radius;
    surface.uvPerUnit = vec2(0.5 / radius);
#endif
    return surface;
}

#if IMAGES
// u runs once around the axis, `down` is v; `radius` is that of the circle around the axis.
void wrapAround(inout Surface surface, Axis axis, vec3 outward, float radius, float down, float downPerUnit) {
    const float kTwoPi = 6.28318530717959;
    vec3 first = firstAcross(axis);
    surface.uv = vec2(0.5 + atan(dot(outward, cross(axis.along, first)), dot(outward, first)) / kTwoPi, down);
    surface.uvPerUnit = vec2(1.0 / (kTwoPi * radius), downPerUnit);
    surface.tangent = cross(axis.along, outward);
}
#endif

#if COVERS
#include "shadow/outline.glsl"

// The apex of the cone as seen from the middle of an axis: unit vectors towards it and beside it, across the axis.
struct AxialView {
    float along;
    float radial; // from the axis
    vec3 towards;
    vec3 beside;
    vec3 toMiddle; // from the apex
};

AxialView axialView(Axis axis, vec3 apex) {
    vec3 offset = (apex - axis.from) - axis.toMiddle;
    float along = dot(offset, axis.along);
    vec3 across = offset - along * axis.along;
    vec3 towards = around(axis, across);
    return AxialView(along, length(across), towards, cross(axis.along, towards), -offset);
}

// Around the axis at a position along it.
Rim rimAround(LightCone cone, AxialView view, vec3 along, float radius, float from, float sweep) {
    return Rim(across(cone, view.toMiddle + along), across(cone, radius * view.towards),
        across(cone, radius * view.beside), from, sweep);
}
#endif
