// HeightPatch: a bicubic Bézier surface over a rectangle, y = size.y height(u, v) over x = (u - 1/2) size.x and
// z = (v - 1/2) size.z, in a box about it that may be rotated. An open surface: what lies above it counts as outside.
//
// ballHeightPatch       about the box
// distanceHeightPatch   gradient and distance, of the baked field; beyond the box from below
// intersectHeightPatch  nearest t in (ray.tMin, t)
// surfaceHeightPatch    the point of the surface at the x and z of the hit; uv = (u, v), so that an image's first row
//                       lies at v = 0
// Error                 band 2^-20 size, ray 2 ulp, point 2 and normal 4 roundings, as docs/numerics.md names them
//                       (tests/shader/height_patch_test.cpp)
// Source                along a ray the height above the surface is a polynomial of degree 6. Its Bernstein
//                       coefficients follow from the part of the net under the ray, by means only, so that nothing
//                       cancels; their hull tells where no root can be (T. Nishita et al., Ray Tracing Trimmed Rational
//                       Surface Patches, 1990)
// Limits                heights from -1/2 to 1/2; the longest side of the box at most 1e4 times the shorter one of the
//                       rectangle
#include "primitive/convex.glsl"
#include "field/height_net.glsl"
#if FIELDS
#include "field/field.glsl"
#endif
#if SURFACE_IN_FIELD
#include "field/march.glsl"
#endif

struct HeightPatch {
    vec3 center;
    vec3 size;
    mat3 axes; // as columns: axes * v rotates v, v * axes rotates it back
    mat4 net;
#if FIELDS
    Field field;
#endif
};

HeightPatch loadHeightPatch(int at) {
    mat3 axes = mat3(sceneTexel(at + 2).xyz, sceneTexel(at + 3).xyz, sceneTexel(at + 4).xyz);
    mat4 net = mat4(sceneTexel(at + 5), sceneTexel(at + 6), sceneTexel(at + 7), sceneTexel(at + 8));
#if FIELDS
    vec3 corner = vec3(sceneTexel(at + 2).w, sceneTexel(at + 3).w, sceneTexel(at + 4).w);
    vec4 size = sceneTexel(at + 1);
    Field field = Field(ivec3(corner), int(sceneTexel(at).w), vec3(size.x, size.w, size.z));
    return HeightPatch(sceneTexel(at).xyz, size.xyz, axes, net, field);
#else
    return HeightPatch(sceneTexel(at).xyz, sceneTexel(at + 1).xyz, axes, net);
#endif
}

vec4 ballHeightPatch(HeightPatch graph) { return vec4(graph.center, 0.5 * length(graph.size)); }

// What a ray sees of it: where it lies in the box, in sizes of it, at s = 0 and along s.
struct GraphRay {
    NearRay near;
    vec3 origin;
    vec3 direction;
};

GraphRay seenBy(HeightPatch graph, Ray ray) {
    NearRay near = recentre(ray.origin, graph.center, ray.direction);
    return GraphRay(near, (near.origin * graph.axes) / graph.size, (ray.direction * graph.axes) / graph.size);
}

#if SURFACE_IN_FIELD
// The height above the surface at a point of the box, and its slope along d, both in sizes of the box.
vec2 heightAlong(mat4 net, vec3 p, vec3 d) {
    vec2 uv = clamp(p.xz + 0.5, 0.0, 1.0);
    vec4 u = bernstein(uv.x) * net, v = bernstein(uv.y);
    float slope = d.x * dot(bernsteinSlope(uv.x) * net, v) + d.z * dot(u, bernsteinSlope(uv.y));
    return vec2(p.y - dot(u, v), d.y - slope);
}

// From where a field has it to where the patch itself is met, by Newton; s as it is where that lies over a voxel away.
// `falls`: the ray comes from the side that it should.
float finished(HeightPatch graph, GraphRay seen, float s, float side, float voxel, out bool falls) {
    float end = s;
    vec2 above;
    for (int i = 0; i < 4; ++i) {
        above = heightAlong(graph.net, seen.origin + end * seen.direction, seen.direction);
        end -= abs(above.y) > 1e-12 ? clamp(above.x / above.y, -voxel, voxel) : 0.0;
    }
    bool stays = abs(end - s) <= voxel;
    falls = !stays || side * above.y < 0.0;
    return stays ? end : s;
}

// Where the ray meets the surface between `from` and `to`; beyond `to` where it does not.
float metBetween(HeightPatch graph, GraphRay seen, float from, float to, float side) {
    vec3 o = seen.origin * graph.size, d = seen.direction * graph.size;
    float voxel = length(voxelSize(graph.field));
    bool leaves = side != 0.0;
    if (!leaves) side = fieldAt(graph.field, inVoxels(graph.field, o + from * d)) < 0.0 ? -1.0 : 1.0;
    float s = from;
    for (int i = 0; i < 4; ++i) {
        s = marchField(graph.field, o, d, s, to, side, leaves && i == 0);
        if (s > to) return s;
        bool falls;
        float end = finished(graph, seen, s, side, voxel, falls);
        if (falls && !(leaves && end <= from)) return end;
        s += 0.5 * voxel; // the field has the ray's own start a little off, or a sheet that the patch has not
    }
    return to + 1.0;
}
#else
// Bernstein coefficients 0 … 3 and 3 … 6 of a polynomial of degree 6 over [0, 1].
struct Sextic {
    vec4 low;
    vec4 high;
};

// The height above the surface from p to q, both in sizes of the box from its middle.
Sextic heightAbove(mat4 net, vec3 p, vec3 q) {
    mat4 part = partOfNet(net, clamp(p.xz + 0.5, 0.0, 1.0), clamp(q.xz + 0.5, 0.0, 1.0));
    vec4 low = vec4(part[0].x, 0.5 * (part[0].y + part[1].x), 0.2 * (part[0].z + part[2].x) + 0.6 * part[1].y,
        0.05 * (part[0].w + part[3].x) + 0.45 * (part[1].z + part[2].y));
    vec4 high = vec4(low.w, 0.2 * (part[1].w + part[3].y) + 0.6 * part[2].z, 0.5 * (part[2].w + part[3].z), part[3].w);
    return Sextic(mix(vec4(p.y), vec4(q.y), vec4(0.0, 1.0, 2.0, 3.0) / 6.0) - low,
        mix(vec4(p.y), vec4(q.y), vec4(3.0, 4.0, 5.0, 6.0) / 6.0) - high);
}

// The polynomial over [x, 1], by de Casteljau.
Sextic after(Sextic c, float x) {
    vec4 a = c.low, b = c.high;
    Sextic right;
    right.high.w = b.w;
    b.xyz = mix(b.xyz, b.yzw, x), a = mix(a, vec4(a.yzw, c.high.y), x);
    right.high.z = b.z;
    a = mix(a, vec4(a.yzw, b.y), x), b.xy = mix(b.xy, b.yz, x);
    right.high.y = b.y;
    a = mix(a, vec4(a.yzw, b.y), x);
    right.high.x = a.w;
    right.low.w = a.w;
    a.xyz = mix(a.xyz, a.yzw, x);
    right.low.z = a.z;
    a.xy = mix(a.xy, a.yz, x);
    right.low.y = a.y;
    right.low.x = mix(a.x, a.y, x);
    return right;
}

// Over [0, x].
Sextic before(Sextic c, float x) {
    Sextic turned = after(Sextic(c.high.wzyx, c.low.wzyx), 1.0 - x);
    return Sextic(turned.high.wzyx, turned.low.wzyx);
}

// The root of a polynomial whose coefficients fall from above 0 to below.
float onlyRoot(Sextic c) {
    float low = 0.0, high = 1.0;
    float x = clamp(c.low.x / (c.low.x - c.high.w), 0.0, 1.0);
    for (int i = 0; i < 12; ++i) {
        Sextic rest = after(c, x);
        float value = rest.low.x;
        low = value >= 0.0 ? x : low;
        high = value >= 0.0 ? high : x;
        float next = x + value * (1.0 - x) / max(6.0 * (value - rest.low.y), 1e-30);
        next = next >= low && next <= high ? next : 0.5 * (low + high);
        if (abs(next - x) < 1e-7) return next;
        x = next;
    }
    return x;
}

// Where a polynomial that begins at 0 or above first falls below; 2 where it does not in [0, 1].
//
// A window goes along it: where no coefficient is below 0 there is no root, where they fall all the way there is one,
// and else the window halves.
float firstFall(Sextic all) {
    float from = 0.0;
    float width = 1.0;
    Sextic rest = all;
    for (int i = 0; i < 64; ++i) {
        Sextic window = before(rest, min(width / (1.0 - from), 1.0));
        vec4 a = window.low, b = window.high;
        vec4 least = min(a, b);
        if (min(min(least.x, least.y), min(least.z, least.w)) >= 0.0) {
            from += width;
            if (from >= 1.0) return 2.0;
            width = min(2.0 * width, 1.0 - from);
            rest = after(all, from);
        } else {
            vec3 early = a.xyz - a.yzw, late = b.xyz - b.yzw;
            vec3 fall = min(early, late);
            if (a.x >= 0.0 && min(fall.x, min(fall.y, fall.z)) >= 0.0) return from + width * onlyRoot(window);
            width *= 0.5;
            if (width < 1e-7) return from; // it only touches 0, or what rounding makes of that
        }
    }
    return from;
}


// Where the ray meets the surface between `from` and `to`; beyond `to` where it does not.
float metBetween(HeightPatch graph, GraphRay seen, float from, float to, float side) {
    Sextic above = heightAbove(graph.net, seen.origin + from * seen.direction, seen.origin + to * seen.direction);
    float way = side == 0.0 ? (above.low.x < 0.0 ? -1.0 : 1.0) : side;
    above = Sextic(way * above.low, way * above.high);
    if (side != 0.0) { // it starts on the surface, and leaves it
        above.low.x = 0.0;
        above.low.y = max(above.low.y, 0.0);
    }
    float x = firstFall(above);
    return x > 1.0 ? to + 1.0 : mix(from, to, x);
}
#endif

bool intersectHeightPatch(HeightPatch graph, Ray ray, float side, inout float t) {
    if (passesBy(ray, ballHeightPatch(graph))) return false;
    GraphRay seen = seenBy(graph, ray);
    vec2 span = commonSpan(slabSpan(seen.origin.x, seen.direction.x, 0.5),
        commonSpan(slabSpan(seen.origin.y, seen.direction.y, 0.50001), slabSpan(seen.origin.z, seen.direction.z, 0.5)));
    float start = (0.0 - seen.near.tHigh) - seen.near.tLow;
    float from = side == 0.0 ? max(span.x, start + ray.tMin) : start;
    if (!(from < span.y)) return false;
    float s = metBetween(graph, seen, from, span.y, side);
    float hit = seen.near.tHigh + (seen.near.tLow + s);
    bool meets = s <= span.y && hit < t && (side != 0.0 || hit > ray.tMin);
    t = meets ? hit : t;
    return meets;
}

Surface surfaceHeightPatch(HeightPatch graph, Ray ray, float t) {
    GraphRay seen = seenBy(graph, ray);
    vec3 p = seen.origin + ((t - seen.near.tHigh) - seen.near.tLow) * seen.direction;
    vec2 uv = clamp(p.xz + 0.5, 0.0, 1.0);
    vec4 u = bernstein(uv.x) * graph.net, v = bernstein(uv.y);
    vec4 slopeU = bernsteinSlope(uv.x) * graph.net, slopeV = bernsteinSlope(uv.y);
    vec2 scale = graph.size.y / graph.size.xz;
    vec2 slope = scale * vec2(dot(slopeU, v), dot(u, slopeV));
    p = graph.size * vec3(uv.x - 0.5, dot(u, v), uv.y - 0.5);
    vec3 normal = vec3(-slope.x, 1.0, -slope.y);
    float steep = length(normal);
    vec3 bend = vec3(dot(bernsteinBend(uv.x) * graph.net, v), dot(slopeU, slopeV), dot(u, bernsteinBend(uv.y)))
        * scale.xxy / graph.size.xzz;
    vec2 squares = 1.0 + slope * slope;
    float mean = dot(bend, vec3(squares.y, -2.0 * slope.x * slope.y, squares.x)) / (2.0 * steep * steep * steep);
    Surface surface = bareSurface(graph.center + graph.axes * p, graph.axes * (normal / steep), -mean);
#if HEIGHT_PATCH_IMAGES
    surface.uv = uv;
    surface.uvPerUnit = inversesqrt(squares) / graph.size.xz;
    surface.tangent = graph.axes * vec3(1.0, slope.x, 0.0) * inversesqrt(squares.x);
#endif
    return surface;
}

#if DISTANCES && FIELDS
#include "sdf/safe_direction.glsl"

// Beyond the box: no point of the surface is nearer than sqrt(gap² + d²), d the distance where the box is nearest.
vec4 distanceHeightPatch(HeightPatch graph, vec3 p, vec3 from) {
    vec3 local = (p - graph.center) * graph.axes;
    vec3 half_ = 0.5 * graph.field.size;
    vec3 inside = clamp(local, -half_, half_);
    vec3 gap = local - inside;
    vec3 g = inVoxels(graph.field, inside);
    ivec3 cell = cellAt(graph.field, g);
    Voxel voxel = voxelAt(graph.field, cell);
    float away = trilinear(voxel, g - vec3(cell));
    vec3 slope = trilinearSlope(voxel, g - vec3(cell)) / voxelSize(graph.field);
    slope = (away < 0.0 ? -1.0 : 1.0) * safeDirection(slope, length(slope), vec3(0.0, 1.0, 0.0));
    away = abs(away);
    float least = length(vec4(gap, away));
    return vec4(graph.axes * safeDirection(gap + away * slope, least, slope), least);
}
#endif
