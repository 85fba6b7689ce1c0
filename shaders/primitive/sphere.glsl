// Sphere: the points at distance `radius` from `center`.
//
// ballSphere       itself
// distanceSphere   gradient and signed distance; at the centre +y
// intersectSphere  nearest t in (ray.tMin, t) along the unit direction; from inside the far side
// surfaceSphere    point and normal exact to the radius' own rounding; uv = longitude, latitude (u = 0 at -x, v = 0 at
//                  +y)
// Error            band 2^-22 radius, ray 1.5 ulp, point 2 and normal 2 roundings, as docs/numerics.md names them
//                  (tests/shader/intersect_test.cpp); distance 1.5 roundings, gradient 2
//                  (tests/shader/distance_test.cpp; measured 1.1 and 0.6)
// Source           ray re-centred on the sphere (ray/split.glsl), then (r - |l|)(r + |l|) instead of r² - l²
// Limits           radius > 0
struct Sphere {
    vec3 center;
    float radius;
};

Sphere loadSphere(int at) {
    vec4 a = sceneTexel(at);
    return Sphere(a.xyz, a.w);
}

vec4 ballSphere(Sphere sphere) { return vec4(sphere.center, sphere.radius); }

#if DISTANCES
#include "sdf/safe_direction.glsl"

vec4 distanceSphere(Sphere sphere, vec3 p, vec3 from) {
    vec3 offset = p - sphere.center;
    float radial = length(offset);
    return vec4(safeDirection(offset, radial, vec3(0.0, 1.0, 0.0)), radial - sphere.radius);
}
#endif

// Half the chord, and the foot of the centre on the ray relative to the centre; negative where the ray passes by.
float halfChord(Sphere sphere, NearRay near, vec3 direction, out vec3 foot, out float fromNear) {
    float a = dot(direction, direction);
    fromNear = -dot(near.origin, direction) / a; // what the first re-centring left over
    foot = near.origin + fromNear * direction;
    float l = length(foot);
    float h2 = (sphere.radius - l) * (sphere.radius + l) / a;
    return h2 < 0.0 ? -1.0 : sqrt(h2);
}

bool intersectSphere(Sphere sphere, Ray ray, float side, inout float t) {
    NearRay near = recentre(ray.origin, sphere.center, ray.direction);
    vec3 foot;
    float fromNear;
    float h = halfChord(sphere, near, ray.direction, foot, fromNear);
    bool passes = h < 0.0;
    h = max(h, 0.0); // a ray inside leaves at its start where rounding says it passes by
    float entry = near.tHigh + ((near.tLow + fromNear) - h);
    float leave = near.tHigh + ((near.tLow + fromNear) + h);
    float hit = side < 0.0 ? max(leave, 0.0) : (entry > ray.tMin ? entry : leave);
    // Convex: what leaves it never comes back.
    bool meets = side <= 0.0 && hit < t && (side < 0.0 || (!passes && hit > ray.tMin));
    t = meets ? hit : t;
    return meets;
}

Surface surfaceSphere(Sphere sphere, Ray ray, float t) {
    NearRay near = recentre(ray.origin, sphere.center, ray.direction);
    vec3 foot;
    float fromNear;
    float h = max(halfChord(sphere, near, ray.direction, foot, fromNear), 0.0);
    float middle = near.tHigh + (near.tLow + fromNear);
    vec3 normal = normalize(t < middle ? foot - h * ray.direction : foot + h * ray.direction);
    Surface surface = bareSurface(sphere.center + sphere.radius * normal, normal, 1.0 / sphere.radius);
#if SPHERE_IMAGES
    const float kPi = 3.14159265358979;
    surface.uv = vec2(0.5 + atan(-normal.z, normal.x) / (2.0 * kPi), acos(clamp(normal.y, -1.0, 1.0)) / kPi);
    surface.uvPerUnit = vec2(0.5, 1.0) / (kPi * sphere.radius);
    float equator = length(normal.xz);
    surface.tangent = equator > 1e-6 ? vec3(-normal.z, 0.0, normal.x) / -equator : vec3(1.0, 0.0, 0.0);
#endif
    return surface;
}

#if COVERS
#include "shadow/round_cover.glsl"

Cover coverSphere(Sphere sphere, LightCone cone) {
    vec3 m = (sphere.center - cone.apex) * cone.axes;
    float radial = length(m);
    return coverRound(m, sphere.radius, (radial - sphere.radius) * (radial + sphere.radius), cone.distance, cone.slope);
}
#endif
