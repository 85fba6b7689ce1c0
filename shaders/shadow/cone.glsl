// The cone between a surface point and a light, and the fraction of the light that distances measured along it leave.
//
// ShadowCone  axis from the centre of the surface sphere to that of the light; it touches both spheres (its radii are
//             those of the discs where it does so, measured across the axis)
// coneRadius    at t along the axis
// coneDistance  what the scene leaves free there
// fractionOf    tau: the part of a unit disc that a half plane at signed distance r from its middle leaves, -1: none,
//               1: all
// taperOf       of marches that end at what they meet: 0, or 1 / reach where the light lies on a surface, which every
//             march to it meets. Then widths taper to nothing at the light, and the last thousandth is not marched
// Model       what stands in the way is a half plane, and of several things the nearest to the axis alone counts: the
//             fraction is fractionOf(least of distance / radius). Pointed, several and thin occluders break that; so do
//             wide lights, since a cone that touches the surface at its start finds cos(alpha) there instead of 1
// Source      the source document of one-ray soft shadows; docs/shadows.md
#include "sdf/scene.glsl"

struct ShadowCone {
    vec3 start;
    vec3 axis;
    float reach;
    float radius;
    float slope;
    float at;   // where the scene's distance was asked for last
    float free; // and what it was
};

// The surface sphere touches the surface and has the pixel's radius, at least what float32 resolves of the coordinates.
ShadowCone coneOf(ShadowQuery query) {
    vec3 size = abs(query.ray.origin);
    float r0 = max(query.pixelRadius, 4e-6 * (max(size.x, max(size.y, size.z)) + 1e-3));
    vec3 start = query.ray.origin + r0 * query.normal;
    vec3 toLight = query.ray.origin + query.distance * query.ray.direction - start;
    float distance = max(length(toLight), 1e-20);
    float sine = clamp((query.lightRadius - r0) / distance, -0.999, 0.999);
    float secant = inversesqrt(1.0 - sine * sine);
    return ShadowCone(start, toLight / distance, distance, r0 * secant, sine * secant, 0.0, 3e38);
}

// Never quite 0: towards a light without size the cone ends in a point.
float coneRadius(ShadowCone cone, float t) { return max(cone.radius + t * cone.slope, 1e-6 * cone.radius); }

// The language's own is off by up to 2e-4 on some GLs. Error 2e-8, and rounding. Source: M. Abramowitz and I. Stegun,
// 4.4.46.
float arcsine(float x) {
    float a = abs(x);
    float high = ((-0.0012624911 * a + 0.0066700901) * a - 0.0170881256) * a + 0.0308918810;
    float all = (((high * a - 0.0501743046) * a + 0.0889789874) * a - 0.2145988016) * a + 1.5707963050;
    float angle = 1.57079632679490 - sqrt(1.0 - a) * all;
    return x < 0.0 ? -angle : angle;
}

float fractionOf(float r) {
    r = clamp(r, -1.0, 1.0);
    return clamp(0.5 + (r * sqrt(1.0 - r * r) + arcsine(r)) / 3.14159265358979, 0.0, 1.0);
}

// A distance grows by no more than its point moves, and its rounding: what is farther need not be asked.
float coneDistance(inout ShadowCone cone, float t) {
    vec3 p = cone.start + t * cone.axis;
    float atMost = 1.0001 * (cone.free + abs(t - cone.at)) + 1e-5 * (abs(p.x) + abs(p.y) + abs(p.z));
    cone.at = t;
    cone.free = sceneDistance(p, cone.start, min(atMost, 3e38)).w;
    return cone.free;
}

float taperOf(inout ShadowCone cone) {
    float resolution = 4e-6 * (dot(abs(cone.start), vec3(1.0)) + cone.reach); // of float32, of the coordinates
    return coneDistance(cone, cone.reach) < resolution ? 1.0 / cone.reach : 0.0;
}

float endOf(ShadowCone cone, float taper) { return taper > 0.0 ? 0.999 * cone.reach : cone.reach; }
