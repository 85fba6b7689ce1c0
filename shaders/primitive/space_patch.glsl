// SpacePatch: a bicubic Bézier surface in space, polynomial or rational. An open surface: the side that S_u × S_v
// points to counts as outside.
//
// ballSpacePatch       about it
// intersectSpacePatch  nearest t in (ray.tMin, t)
// surfaceSpacePatch    the point of the surface that the ray meets at t; uv = (u, v), so that an image's first row lies
//                      at v = 0. Where an edge is one point the normal is the limit there
// Error                a rounding is 2^-23 of how far the farthest control point is from the anchor, over the lightest
//                      weight. No wrong decision beyond 16 of them; point off the surface 3, and off the ray 8 (24
//                      where the net is wild); normal 16 over how far the slopes span the tangent plane
//                      (tests/shader/space_patch_test.cpp)
// Source               seen along the ray the net is one of points of a plane, and the ray meets the surface where
//                      that is 0. Parts of the net, by means only so that nothing cancels, in halves of halves: one
//                      whose hull misses 0 along the directions of its sides (T. Nishita et al., Ray Tracing Trimmed
//                      Rational Surface Patches, 1990) is left out, in one whose slopes differ little from their mean
//                      there is one crossing at most, which Newton's steps lead to
// Limits               weights above 0; a radius of 1e-6 to 1e6
#include "field/height_net.glsl"
#include "shadow/frame_about.glsl"

const int kDeepest = 12; // halves along u or v: there rounding is as large as what is left of the bend
const int kNarrow = 4;   // halves along the other one by then
const int kMostParts = 2000;

struct SpacePatch {
    vec3 anchor;
    vec4 ball;
    int net; // texels of its control points times their weights, relative to the anchor, and of the weights
};

SpacePatch loadSpacePatch(int at) {
    vec4 anchor = sceneTexel(at);
    return SpacePatch(anchor.xyz, vec4(sceneTexel(at + 1).xyz, anchor.w), at + 2);
}

vec4 ballSpacePatch(SpacePatch patch_) { return patch_.ball; }

mat4 fourTexels(int at) { return mat4(sceneTexel(at), sceneTexel(at + 1), sceneTexel(at + 2), sceneTexel(at + 3)); }

// {weight * point, weight}
vec4 weightedPoint(SpacePatch patch_, vec2 uv) {
    vec4 u = bernstein(uv.x), v = bernstein(uv.y);
    return vec4(dot(u * fourTexels(patch_.net), v), dot(u * fourTexels(patch_.net + 4), v),
        dot(u * fourTexels(patch_.net + 8), v), dot(u * fourTexels(patch_.net + 12), v));
}

float leastOf(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
float mostOf(mat4 m) {
    vec4 v = max(max(m[0], m[1]), max(m[2], m[3]));
    return max(max(v.x, v.y), max(v.z, v.w));
}

// Whether all of it lies farther from 0 than `room`, on one side.
bool misses(mat4 m, float room) {
    vec4 v = min(min(m[0], m[1]), min(m[2], m[3]));
    return leastOf(v) > room || mostOf(m) < -room;
}

// How much the slopes of a net differ from `along` in u and 0 in v.
float uneven(mat4 net, float along) {
    vec3 u = max(max(abs(3.0 * (net[0].yzw - net[0].xyz) - along), abs(3.0 * (net[1].yzw - net[1].xyz) - along)),
        max(abs(3.0 * (net[2].yzw - net[2].xyz) - along), abs(3.0 * (net[3].yzw - net[3].xyz) - along)));
    vec4 v = max(abs(net[1] - net[0]), max(abs(net[2] - net[1]), abs(net[3] - net[2])));
    return max(u.x, max(u.y, u.z)) + 3.0 * max(max(v.x, v.y), max(v.z, v.w));
}

// What the ray sees: the net across it, times the weights.
struct SeenNet {
    mat4 a;
    mat4 b;
};

struct SeenPoint {
    vec2 place;
    vec2 u; // derivatives
    vec2 v;
};

SeenPoint seenAt(SeenNet net, vec2 uv) {
    vec4 v = bernstein(uv.y), dv = bernsteinSlope(uv.y), u = bernstein(uv.x), du = bernsteinSlope(uv.x);
    vec4 a = u * net.a, b = u * net.b;
    return SeenPoint(vec2(dot(a, v), dot(b, v)), vec2(dot(du * net.a, v), dot(du * net.b, v)),
        vec2(dot(a, dv), dot(b, dv)));
}

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// A part of the square: a half of a half …, of 2^-level. `turns` tells across which axis each half was cut, `path`
// which one it is, the latest in the lowest bit.
struct Part {
    ivec2 at;
    ivec2 level;
    uint path;
    uint turns;
};

vec2 widthOf(Part part) { return uintBitsToFloat(uvec2(127 - part.level) << 23); }
ivec2 lastAxis(Part part) { return (part.turns & 1u) == 0u ? ivec2(1, 0) : ivec2(0, 1); }

Part firstHalf(Part part, bool acrossV) {
    part.path <<= 1;
    part.turns = (part.turns << 1) | uint(acrossV);
    ivec2 axis = lastAxis(part);
    part.at <<= axis;
    part.level += axis;
    return part;
}

// After all parts of this one.
Part after(Part part) {
    while ((part.path & 1u) == 1u) {
        ivec2 axis = lastAxis(part);
        part.at >>= axis;
        part.level -= axis;
        part.path >>= 1;
        part.turns >>= 1;
    }
    part.path |= 1u;
    part.at += lastAxis(part);
    return part;
}

// The last half of the last half …
bool isLast(Part part) { return part.path + 1u == 1u << uint(part.level.x + part.level.y); }

// What of a part may be met: nothing, one crossing at most, or anything in its halves across u, or v.
const int kNoCrossing = 0, kOneCrossing = 1, kHalvesOfU = 2, kHalvesOfV = 3;
int crossingsIn(SeenNet net, Part part, float room) {
    vec2 width = widthOf(part), low = vec2(part.at) * width;
    mat4 a = partOfNet(net.a, low, low + width), b = partOfNet(net.b, low, low + width);
    vec2 p00 = vec2(a[0].x, b[0].x), p10 = vec2(a[0].w, b[0].w), p01 = vec2(a[3].x, b[3].x), p11 = vec2(a[3].w, b[3].w);
    vec2 u = 0.5 * ((p11 - p01) + (p10 - p00)), v = 0.5 * ((p11 - p10) + (p01 - p00));
    float turn = cross2(u, v);
    mat4 acrossV = v.y * a - v.x * b, acrossU = u.x * b - u.y * a;
    if (misses(a, room) || misses(b, room) || misses(acrossV, room * (abs(v.x) + abs(v.y)))
        || misses(acrossU, room * (abs(u.x) + abs(u.y)))) return kNoCrossing;
    float most = max(uneven(acrossV, turn), uneven(transpose(acrossU), turn));
    if (most < 0.8 * abs(turn)) return kOneCrossing;
    // What a half takes from how the slopes vary: along the sides, and by the twist from either side to the other.
    float bendU = 3.0 * max(length(vec2(a[0].w - a[0].z, b[0].w - b[0].z) - vec2(a[0].y - a[0].x, b[0].y - b[0].x)),
        length(vec2(a[3].w - a[3].z, b[3].w - b[3].z) - vec2(a[3].y - a[3].x, b[3].y - b[3].x)));
    float bendV = 3.0 * max(length(vec2(a[3].x - a[2].x, b[3].x - b[2].x) - vec2(a[1].x - a[0].x, b[1].x - b[0].x)),
        length(vec2(a[3].w - a[2].w, b[3].w - b[2].w) - vec2(a[1].w - a[0].w, b[1].w - b[0].w)));
    float twist = length((p11 - p01) - (p10 - p00)), lengthU = length(u), lengthV = length(v);
    bool acrossV_ = bendV * lengthU + twist * lengthV > bendU * lengthV + twist * lengthU;
    ivec2 levels = acrossV_ ? part.level.yx : part.level;
    if (levels.x >= kDeepest && levels.y >= kNarrow) return kOneCrossing;
    return acrossV_ == (levels.x < kDeepest) ? kHalvesOfV : kHalvesOfU;
}

// Where Newton's steps lead within a part: uv, and whether the ray is met there.
bool findCrossing(SeenNet net, Part part, float room, out vec2 uv) {
    vec2 width = widthOf(part);
    vec2 low = max((vec2(part.at) - 0.125) * width, 0.0), high = min((vec2(part.at) + 1.125) * width, 1.0);
    uv = 0.5 * (low + high);
    bool met = false;
    for (int i = 0; i < 8 && !met; ++i) {
        SeenPoint p = seenAt(net, uv);
        met = max(abs(p.place.x), abs(p.place.y)) <= room;
        float turn = cross2(p.u, p.v);
        vec2 stride = vec2(cross2(p.place, p.v), cross2(p.u, p.place)) / (turn == 0.0 ? 1e30 : turn);
        // The last step gains the last digits; one that is long by then would leave the ray: two crossings meet there.
        bool goes = !met || max(abs(stride.x), abs(stride.y)) < 1e-5;
        uv = goes ? clamp(uv - stride, low, high) : uv;
    }
    return met;
}

struct Crossing {
    vec2 uv;
    float t;
    float near; // |t - from|
};

// Of those where the ray meets it the one whose t is nearest to `from`: before as well, or `ahead` only, where a start
// on this very patch, on that side of it, is none.
//
// A ray that leaves the surface meets it again from the other side, if at all. A crossing from this side, and so near,
// is the start.
Crossing nearestCrossing(SpacePatch patch_, Ray ray, float from, bool ahead, float side) {
    NearRay near = recentre(ray.origin, patch_.anchor, ray.direction);
    mat2x3 frame = frameAbout(ray.direction);
    mat4 x = fourTexels(patch_.net), y = fourTexels(patch_.net + 4), z = fourTexels(patch_.net + 8);
    mat4 w = fourTexels(patch_.net + 12);
    vec2 o = near.origin * frame;
    SeenNet net = SeenNet(frame[0].x * x + frame[0].y * y + frame[0].z * z - o.x * w,
        frame[1].x * x + frame[1].y * y + frame[1].z * z - o.y * w);
    float room = 2.4e-7 * max(max(mostOf(net.a), mostOf(net.b)), max(mostOf(-1.0 * net.a), mostOf(-1.0 * net.b)));
    Crossing best = Crossing(vec2(0.5), from, kFar);
    Part part = Part(ivec2(0), ivec2(0), 0u, 0u);
    bool more = true;
    int parts = 0;
    do {
        // All lanes of a SIMD go on to a crossing each, then all together along it.
        int crossings;
        do {
            crossings = crossingsIn(net, part, room);
            more = crossings >= kHalvesOfU || (crossings == kNoCrossing && !isLast(part));
            if (crossings >= kHalvesOfU) part = firstHalf(part, crossings == kHalvesOfV);
            if (crossings == kNoCrossing && more) part = after(part);
        } while (more && ++parts < kMostParts);
        vec2 uv;
        if (crossings == kOneCrossing && findCrossing(net, part, room, uv)) {
            vec4 p = weightedPoint(patch_, uv);
            float t = near.tHigh
                + (near.tLow + dot(p.xyz / p.w - near.origin, ray.direction) / dot(ray.direction, ray.direction));
            SeenPoint seen = seenAt(net, uv);
            bool start = side * cross2(seen.u, seen.v) >= 0.0 && side != 0.0 && t < 0.01 * patch_.ball.w;
            bool counts = !ahead || (t > from && !start);
            float gap = abs(t - from);
            if (counts && gap < best.near) best = Crossing(uv, t, gap);
        }
        more = crossings == kOneCrossing && !isLast(part) && parts < kMostParts;
        if (more) part = after(part);
    } while (more);
    return best;
}

// Where the latest hit lies: surfaceSpacePatch(), which is told t only, is mostly asked about that one.
int latestNet = -1;
Crossing latest;

bool intersectSpacePatch(SpacePatch patch_, Ray ray, float side, inout float t) {
    if (passesBy(ray, patch_.ball)) return false;
    Crossing found = nearestCrossing(patch_, ray, side == 0.0 ? ray.tMin : 0.0, true, side);
    bool meets = found.near < kFar && found.t < t;
    t = meets ? found.t : t;
    latestNet = meets ? patch_.net : latestNet;
    if (meets) latest = found;
    return meets;
}

// The direction in which the surface goes along u, and how far. Its limit, where the edge v = 0 or v = 1 is one point.
vec4 slopeAlongU(mat4 x, mat4 y, mat4 z, mat4 w, vec2 uv, float radius) {
    // Relative to where the nearer edge begins: that is 0 there, where it is one point, and goes up with v.
    bool low = uv.y < 0.5;
    vec4 row = low ? w[0] : w[3];
    vec3 corner = (low ? vec3(x[0].x, y[0].x, z[0].x) : vec3(x[3].x, y[3].x, z[3].x)) / row.x;
    x -= corner.x * w, y -= corner.y * w, z -= corner.z * w;
    vec4 edge = max(max(abs(low ? x[0] : x[3]), abs(low ? y[0] : y[3])), abs(low ? z[0] : z[3]));
    bool point = max(max(edge.x, edge.y), max(edge.z, edge.w)) < 1e-6 * radius * row.x;
    float t = uv.y, s = 1.0 - t;
    vec4 v = bernstein(t), u = bernstein(uv.x), du = bernsteinSlope(uv.x);
    vec4 rest = low ? vec4(0.0, 3.0 * s * s, 3.0 * t * s, t * t) : vec4(s * s, 3.0 * t * s, 3.0 * t * t, 0.0);
    vec4 by = point ? rest : v;
    float weight = dot(u * w, v);
    vec3 at = vec3(dot(u * x, by), dot(u * y, by), dot(u * z, by));
    vec3 slope = (vec3(dot(du * x, by), dot(du * y, by), dot(du * z, by)) - at * (dot(du * w, v) / weight)) / weight;
    float size = length(slope);
    return size > 0.0 ? vec4(slope / size, size * (point ? (low ? t : s) : 1.0)) : vec4(0.0);
}

Surface surfaceSpacePatch(SpacePatch patch_, Ray ray, float t) {
    vec2 uv = latest.uv;
    if (latestNet != patch_.net || latest.t != t) uv = nearestCrossing(patch_, ray, t, false, 0.0).uv;
    mat4 x = fourTexels(patch_.net), y = fourTexels(patch_.net + 4), z = fourTexels(patch_.net + 8);
    mat4 w = fourTexels(patch_.net + 12);
    vec4 p = weightedPoint(patch_, uv);
    vec4 alongU = slopeAlongU(x, y, z, w, uv, patch_.ball.w);
    vec4 alongV = slopeAlongU(transpose(x), transpose(y), transpose(z), transpose(w), uv.yx, patch_.ball.w);
    vec3 normal = cross(alongU.xyz, alongV.xyz);
    float size = length(normal);
    normal = size > 0.0 ? normal / size : -ray.direction;
    Surface surface = bareSurface(patch_.anchor + p.xyz / p.w, normal, 0.0);
#if SPACE_PATCH_IMAGES
    surface.uv = uv;
    surface.uvPerUnit = 1.0 / max(vec2(alongU.w, alongV.w), 1e-6 * patch_.ball.w);
    surface.tangent = alongU.xyz;
#endif
    return surface;
}
