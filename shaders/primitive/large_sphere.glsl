// LargeSphere: a sphere that is huge beside what is seen of it, as the ground under things. Scene files say "sphere";
// one that is huge for its scene is drawn as this (drawnKinds() in tracer/plan/drawn.h).
//
// distanceLargeSphere   gradient and signed distance; about the centre some direction
// intersectLargeSphere  nearest t in (ray.tMin, t); from inside the far side
// surfaceLargeSphere    point put back onto the surface by one Newton step; uv = longitude, latitude, as of a sphere
// Error           E = 2^-22 D (1 + D / 2r), D being the distance from the anchor: t: 1 ulp of the distance + E /
//                 cosine; edge decisions wrong only within E of tangency, D that of the tangent point; surface point
//                 within E of the surface, before it is rounded to its own coordinates (measured,
//                 tests/shader/large_sphere_test.cpp); distance 1.75 E, gradient 2 roundings
//                 (tests/shader/distance_test.cpp; measured 1.5 and 0.7)
// Source          a sphere is a bent plane: about an anchor near the surface, under the eye, its points p have
//                 curvature p.p / 2 + normal.p + height = 0, whose terms are as small as what is near the anchor. The
//                 ray is re-centred on the anchor (ray/split.glsl), so that only where it meets the large sphere
//                 counts: from far away it is as good as a sphere to a factor of two, and needs no other form
// Limits          curvature > 0; normal is unit; the anchor is within rounding of the surface
#include "primitive/convex.glsl"

struct LargeSphere {
    vec3 anchor;
    float curvature; // 1 / distance of the anchor from the centre
    vec3 normal;     // at the anchor
    float height;    // of the anchor, which is a float32 point, above the surface
};

LargeSphere loadLargeSphere(int at) {
    vec4 a = sceneTexel(at);
    vec4 b = sceneTexel(at + 1);
    return LargeSphere(a.xyz, a.w, b.xyz, b.w);
}

#if DISTANCES
#include "sdf/safe_direction.glsl"

vec4 distanceLargeSphere(LargeSphere sphere, vec3 p, vec3 from) {
    vec3 offset = p - sphere.anchor;
    float k = sphere.curvature;
    vec3 outward = sphere.normal + k * offset; // k times the way from the centre
    float radial = length(outward);
    float radius = sqrt(1.0 - 2.0 * k * sphere.height); // k times it
    float bent = 0.5 * k * dot(offset, offset) + dot(sphere.normal, offset) + sphere.height;
    return vec4(safeDirection(outward, radial, sphere.normal), 2.0 * bent / (radial + radius));
}
#endif

// The interval of the ray p + s d inside.
vec2 largeSphereSpan(LargeSphere sphere, vec3 p, vec3 d) {
    float a = dot(d, d);
    float along = dot(p, d);
    float rise = dot(sphere.normal, d);
    float above = dot(sphere.normal, p) + sphere.height;
    float k = sphere.curvature;
    float discriminant = rise * rise + 2.0 * k * (along * rise - a * above) - k * k * (a * dot(p, p) - along * along);
    if (!(discriminant >= 0.0)) return kNever;
    return rootsOf(k * a, k * along + rise, k * dot(p, p) + 2.0 * above, discriminant);
}

bool intersectLargeSphere(LargeSphere sphere, Ray ray, float side, inout float t) {
    if (side > 0.0) return false; // convex: what leaves it never comes back
    NearRay near = recentre(ray.origin, sphere.anchor, ray.direction);
    return meetConvex(near, largeSphereSpan(sphere, near.origin, ray.direction), ray, side, t);
}

Surface surfaceLargeSphere(LargeSphere sphere, Ray ray, float t) {
    NearRay near = recentre(ray.origin, sphere.anchor, ray.direction);
    float end;
    vec3 p = near.origin + spanEnd(near, largeSphereSpan(sphere, near.origin, ray.direction), t, end) * ray.direction;
    vec3 gradient = sphere.normal + sphere.curvature * p;
    float off = 0.5 * sphere.curvature * dot(p, p) + dot(sphere.normal, p) + sphere.height;
    p -= (off / dot(gradient, gradient)) * gradient;
    vec3 normal = normalize(sphere.normal + sphere.curvature * p);
    Surface surface = bareSurface(sphere.anchor + p, normal, sphere.curvature);
#if LARGE_SPHERE_IMAGES
    // The latitude is not acos(y), which near a pole, where a ground has its anchor, moves in steps of radius / 3000.
    const float kPi = 3.14159265358979;
    float equator = length(normal.xz);
    surface.uv = vec2(0.5, atan(equator, normal.y) / kPi);
    surface.uvPerUnit = vec2(0.5, 1.0) * sphere.curvature / kPi;
    surface.tangent = vec3(1.0, 0.0, 0.0);
    if (equator > 0.0) {
        surface.uv.x += atan(-normal.z, normal.x) / (2.0 * kPi);
        surface.tangent = vec3(normal.z, 0.0, -normal.x) / equator;
    }
#endif
    return surface;
}

#if COVERS
#include "shadow/round_cover.glsl"

// In lengths of its radius, with the gradient for the way from the centre.
Cover coverLargeSphere(LargeSphere sphere, LightCone cone) {
    vec3 offset = cone.apex - sphere.anchor;
    float k = sphere.curvature;
    float above = 0.5 * k * dot(offset, offset) + dot(sphere.normal, offset) + sphere.height;
    vec3 outward = (sphere.normal + k * offset) * cone.axes;
    float radius = sqrt(1.0 - 2.0 * k * sphere.height);
    return coverRound(-outward, radius, 2.0 * k * above, k * cone.distance, cone.slope);
}
#endif
