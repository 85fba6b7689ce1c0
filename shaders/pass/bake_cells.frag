// What is known of one cell of the patch: field/cells.glsl tells what, and where it lies.
//
// Source   the cell's net: its heights lie between its control points, its slopes between 3 n times their differences,
//          all widened by what float32 loses. Curvature is sampled, on 8 × 8 points of the coarse cells and 4 × 4 of
//          the fine ones, for which kConvexShare makes up; where the patch ends that of its border counts, too
#include "field/cells.glsl"

layout(location = 0) out vec4 outHeights;
layout(location = 1) out vec4 outSlopes;

vec2 rangeOf(vec4 a, vec2 range) {
    vec2 pair = min(a.xy, a.zw);
    vec2 other = max(a.xy, a.zw);
    return vec2(min(range.x, min(pair.x, pair.y)), max(range.y, max(other.x, other.y)));
}

vec2 rangeOf(vec3 a, vec2 range) { return rangeOf(a.xyzz, range); }

// Greatest curvatures towards above and below, of the surface and, where the patch ends, of its border.
vec2 curvatures(vec2 x, vec2 border) {
    Jet jet = jetOf(x);
    vec2 p = jet.slope;
    vec3 b = jet.bend;
    float w = 1.0 + dot(p, p);
    float mean = 0.5 * ((1.0 + p.y * p.y) * b.x - 2.0 * p.x * p.y * b.z + (1.0 + p.x * p.x) * b.y);
    float product = (b.x * b.y - b.z * b.z) * w;
    float root = sqrt(max(mean * mean - product, 0.0));
    vec2 k = vec2(mean + root, root - mean) / (w * sqrt(w));
    vec2 curve = border * b.xy / ((1.0 + p * p) * sqrt(1.0 + p * p));
    return max(k, max(vec2(curve.x, -curve.x), vec2(curve.y, -curve.y)));
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int n = kFinest;
    for (int i = 0; i < 3; ++i)
        if (at.y >= n) {
            at.y -= n;
            n /= 2;
        }
    outHeights = vec4(0.0);
    outSlopes = vec4(0.0);
    if (max(at.x, at.y) >= n) return;
    vec2 low = vec2(at) / float(n);
    vec2 high = vec2(at + 1) / float(n);
    mat4 net = partOfNet(bake.net, low, high);
    const vec2 kNothing = vec2(3e38, -3e38);
    vec2 heights = kNothing;
    vec2 alongX = kNothing;
    vec2 alongZ = kNothing;
    for (int j = 0; j < 4; ++j) {
        heights = rangeOf(net[j], heights);
        alongX = rangeOf(net[j].yzw - net[j].xyz, alongX);
    }
    for (int j = 0; j < 3; ++j) alongZ = rangeOf(net[j + 1] - net[j], alongZ);

    vec2 side = bake.sides.xy / float(n);
    vec2 border = vec2(at.y == 0 || at.y == n - 1, at.x == 0 || at.x == n - 1);
    vec2 k = vec2(1e-6);
    int last = n > 16 ? 3 : 7;
    for (int j = 0; j <= last; ++j)
        for (int i = 0; i <= last; ++i)
            k = max(k, curvatures((vec2(at) + vec2(i, j) / float(last)) * side, border));
    vec2 widened = vec2(-bake.bounds.y, bake.bounds.y);
    outHeights = vec4(heights + widened, kConvexShare / (k * k));
    alongX = (alongX + 2.0 * widened) * (3.0 * float(n)) * bake.sides.z;
    alongZ = (alongZ + 2.0 * widened) * (3.0 * float(n)) * bake.sides.w;
    outSlopes = vec4(alongX.x, alongZ.x, alongX.y, alongZ.y);
}
