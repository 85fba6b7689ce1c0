// Box: the points within half_size of the centre along each of the axes x, y, z.
//
// ballBox       the ball through its corners
// distanceBox   gradient and signed distance; where faces are equally near, x before y before z
// intersectBox  nearest t in (ray.tMin, t); from inside the far face
// surfaceBox    point on the face that the ray crosses, exact in its own coordinates; each face shows uv 0 … 1 once
// Error         band 2^-23 size, ray 1.5 ulp, point 1 and normal 1 roundings, as docs/numerics.md names them
//               (tests/shader/intersect_test.cpp); distance 1.5 roundings, gradient 2 (tests/shader/distance_test.cpp;
//               measured 1.2 and 0.6)
// Source        ray re-centred on the box (ray/split.glsl), then three slabs (primitive/convex.glsl); the surface takes the
//               face whose slab decided, so that a face seen from outside always faces the ray
// Limits        half sizes > 0; a ray within a face counts as inside of its slab
#include "primitive/convex.glsl"

struct Box {
    vec3 center;
    vec3 halfSize;
};

Box loadBox(int at) { return Box(sceneTexel(at).xyz, sceneTexel(at + 1).xyz); }

vec4 ballBox(Box box) { return vec4(box.center, length(box.halfSize)); }

// 1 in the largest component.
vec3 largestAxis(vec3 v) {
    if (v.x >= v.y && v.x >= v.z) return vec3(1.0, 0.0, 0.0);
    return v.y >= v.z ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
}

#if DISTANCES
#include "sdf/away.glsl"

vec4 distanceBox(Box box, vec3 p, vec3 from) {
    vec3 offset = p - box.center;
    vec3 side = 1.0 - 2.0 * vec3(lessThan(offset, vec3(0.0)));
    vec3 beyond = abs(offset) - box.halfSize;
    vec3 outside = max(beyond, 0.0);
    float away = length(outside);
    float depth = min(max(beyond.x, max(beyond.y, beyond.z)), 0.0);
    return vec4(side * awayFrom(outside, away, largestAxis(beyond)), away + depth);
}
#endif

void boxSlabs(Box box, vec3 p, vec3 d, out vec3 enter, out vec3 leave) {
    vec2 x = slabSpan(p.x, d.x, box.halfSize.x);
    vec2 y = slabSpan(p.y, d.y, box.halfSize.y);
    vec2 z = slabSpan(p.z, d.z, box.halfSize.z);
    enter = vec3(x.x, y.x, z.x);
    leave = vec3(x.y, y.y, z.y);
}

vec2 boxSpan(vec3 enter, vec3 leave) {
    return vec2(max(enter.x, max(enter.y, enter.z)), min(leave.x, min(leave.y, leave.z)));
}

bool intersectBox(Box box, Ray ray, float side, inout float t) {
    if (side > 0.0) return false; // convex: what leaves it never comes back
    if (side == 0.0 && passesBy(ray, ballBox(box))) return false;
    NearRay near = recentre(ray.origin, box.center, ray.direction);
    vec3 enter, leave;
    boxSlabs(box, near.origin, ray.direction, enter, leave);
    return meetConvex(near, boxSpan(enter, leave), ray, side, t);
}

Surface surfaceBox(Box box, Ray ray, float t) {
    NearRay near = recentre(ray.origin, box.center, ray.direction);
    vec3 enter, leave;
    boxSlabs(box, near.origin, ray.direction, enter, leave);
    float end;
    float s = spanEnd(near, boxSpan(enter, leave), t, end);
    vec3 p = clamp(near.origin + s * ray.direction, -box.halfSize, box.halfSize);
    vec3 face = end < 0.0 ? largestAxis(enter) : largestAxis(-leave);
    vec3 normal = face * slabSide(dot(near.origin, face), dot(ray.direction, face), end);
    p = mix(p, normal * box.halfSize, face);
    Surface surface = bareSurface(box.center + p, normal, 0.0);
#if IMAGES
    surface.tangent = face.x > 0.0 ? vec3(0.0, 0.0, -normal.x) : (face.y > 0.0 ? vec3(1.0, 0.0, 0.0) : vec3(normal.z, 0.0, 0.0));
    vec3 down = cross(surface.tangent, normal);
    vec2 size = 2.0 * vec2(dot(box.halfSize, abs(surface.tangent)), dot(box.halfSize, abs(down)));
    surface.uv = 0.5 + vec2(dot(p, surface.tangent), dot(p, down)) / size;
    surface.uvPerUnit = 1.0 / size;
#endif
    return surface;
}
