// Box: the points within nearHalfsize of the centre along each of the axes x, y, z.
//
// ballBox       the ball through its corners
// distanceBox   gradient and signed distance; where faces are equally near, x before y before z
// intersectBox  nearest t in (ray.tMin, t); from inside the far face
// surfaceBox    point on the face that the ray crosses, exact in its own coordinates; each face shows uv 0 … 1 once
// Error         band 2^-23 size, ray 1.5 ulp, point 1 and normal 1 roundings, as docs/numerics.md names them
//               (tests/shader/intersect_test.cpp); distance 1.5 roundings, gradient 2 (tests/shader/distance_test.cpp;
//               measured 1.2 and 0.6)
// Source        ray re-centred on the box (ray/split.glsl), then three slabs (primitive/convex.glsl); the surface takes
//               the face whose slab decided, so that a face seen from outside always faces the ray
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
#include "sdf/safe_direction.glsl"

vec4 distanceBox(Box box, vec3 p, vec3 from) {
    vec3 offset = p - box.center;
    vec3 side = 1.0 - 2.0 * vec3(lessThan(offset, vec3(0.0)));
    vec3 beyond = abs(offset) - box.halfSize;
    vec3 outside = max(beyond, 0.0);
    float gap = length(outside);
    float depth = min(max(beyond.x, max(beyond.y, beyond.z)), 0.0);
    return vec4(side * safeDirection(outside, gap, largestAxis(beyond)), gap + depth);
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
#if BOX_IMAGES
    surface.tangent = face.x > 0.0 ? vec3(0.0, 0.0, -normal.x)
        : (face.y > 0.0 ? vec3(1.0, 0.0, 0.0) : vec3(normal.z, 0.0, 0.0));
    vec3 down = cross(surface.tangent, normal);
    vec2 size = 2.0 * vec2(dot(box.halfSize, abs(surface.tangent)), dot(box.halfSize, abs(down)));
    surface.uv = 0.5 + vec2(dot(p, surface.tangent), dot(p, down)) / size;
    surface.uvPerUnit = 1.0 / size;
#endif
    return surface;
}

#if COVERS
#include "shadow/outline.glsl"

// Corner i of the outline that the apex sees, as signs; towards it they are +. Six corners round the one nearest to the
// apex; those of them that are on no face that it sees move onto one.
vec3 outlineCorner(int i, vec3 sees) {
    vec3 corner = 2.0 * vec3((ivec3(35, 14, 56) >> i) & 1) - 1.0;
    return dot(max(corner, 0.0), sees) > 0.0 ? corner : max(corner, 2.0 * sees - 1.0);
}

// Corner i of the face across axis `face`.
vec3 faceCorner(int i, int face) {
    vec3 corner = vec3(1.0, 2.0 * float((6 >> i) & 1) - 1.0, 2.0 * float((12 >> i) & 1) - 1.0);
    return face == 0 ? corner : (face == 1 ? corner.zxy : corner.yzx);
}

// By its outline, or by the faces that the apex sees where the plane of the light's disc cuts them.
Cover coverBox(Box box, LightCone cone) {
    vec3 offset = cone.apex - box.center;
    vec3 sees = vec3(greaterThan(abs(offset), box.halfSize));
    if (sees == vec3(0.0)) return coverFromInside();
    vec3 nearHalf = box.halfSize * (1.0 - 2.0 * vec3(lessThan(offset, vec3(0.0))));
    float middle = -dot(offset, cone.axes[2]);
    float reach = dot(box.halfSize, abs(cone.axes[2]));
    if (middle - reach >= cone.distance) return coverNothing();
    bool whole = middle + reach < cone.distance;
    int corners = whole ? 6 : 4;
    Outline outline = startOutline(vec3(0.0));
    for (int face = 0; face < (whole ? 1 : 3); ++face) {
        bool drawn = whole || sees[face] > 0.0;
        outline.begun = false;
        outline.at = across(cone, nearHalf * (whole ? outlineCorner(0, sees) : faceCorner(0, face)) - offset);
        for (int i = 1; i <= (drawn ? corners : 0); ++i) {
            int at = i == corners ? 0 : i;
            vec3 corner = whole ? outlineCorner(at, sees) : faceCorner(at, face);
            edgeTo(outline, across(cone, nearHalf * corner - offset), 0.0);
        }
        closeOutline(outline);
    }
    return coverOf(outline);
}
#endif
