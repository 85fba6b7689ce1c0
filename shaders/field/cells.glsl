// The cells of a height patch: quarters of quarters of it, 8 to 64 along a side, and what is known of each.
//
// cellHeights   xy: least and greatest height; z, w: squared distance, from above and from below, up to which a foot
//               in the cell is a strict minimum
// cellSlopes    xy: least slopes along x and z, zw: greatest
// mayHold       no: nearer than the root of `best` no foot of a point within `spread` of q lies in the cell. `convex`:
//               such feet are strict minima each
// Source        interval arithmetic on what a foot is: the offset x - q along x and z, the height r over q and the
//               slopes p fulfil x - q = -r p, but for borders. Each of them narrows the others, and the box they leave
//               is as near as it is; where none is left there is no foot
// A cell is (x, z, cells along a side); its texel's row begins after those of all finer ones
#include "field/patch.glsl"

const int kCoarsest = 8;
const int kFinest = 64;

uniform highp sampler2D cellHeights;
uniform highp sampler2D cellSlopes;

// A foot is a strict minimum where the distance is less than the radius of curvature on its side; this much of its
// square is asked for, since curvature is sampled.
const float kConvexShare = 0.5;

bool mayHold(ivec3 cell, vec3 q, vec3 spread, float best, out bool convex) {
    ivec2 at = ivec2(cell.x, cell.y + 2 * (kFinest - cell.z));
    vec4 heights = texelFetch(cellHeights, at, 0);
    vec4 slopes = texelFetch(cellSlopes, at, 0);
    vec2 side = bake.sides.xy / float(cell.z);
    vec2 low = vec2(cell.xy) * side - q.xz;
    vec2 high = low + side + spread.xz;
    low -= spread.xz;
    vec2 r = heights.xy - q.y + vec2(-spread.y, spread.y);

    // Along an axis a foot has x - q = -r p, or it lies on the border with x - q beyond that.
    vec2 a = r.x * slopes.xy;
    vec2 b = r.x * slopes.zw;
    vec2 c = r.y * slopes.xy;
    vec2 d = r.y * slopes.zw;
    bvec2 first = equal(cell.xy, ivec2(0));
    bvec2 last = equal(cell.xy, ivec2(cell.z - 1));
    vec2 onFirst = low + 2.0 * spread.xz;
    vec2 onLast = high - 2.0 * spread.xz;
    low = max(low, -max(max(a, b), max(c, d)));
    high = min(high, -min(min(a, b), min(c, d)));
    low = mix(low, min(low, onLast), last);
    high = mix(high, max(high, onFirst), first);

    // The same for r, where the slope has one sign: there is one division if that is turned positive.
    vec2 gentle = max(min(abs(slopes.xy), abs(slopes.zw)), 1e-30);
    vec2 steep = max(max(abs(slopes.xy), abs(slopes.zw)), 1e-30);
    bvec2 up = greaterThan(slopes.xy, vec2(0.0));
    vec2 from = mix(low, -high, up);
    vec2 to = mix(high, -low, up);
    from /= mix(gentle, steep, greaterThan(from, vec2(0.0)));
    to /= mix(steep, gentle, greaterThan(to, vec2(0.0)));
    vec2 unknown = vec2(lessThanEqual(slopes.xy * slopes.zw, vec2(0.0)));
    vec2 below = mix(vec2(first), vec2(last), up) + unknown;
    vec2 above = mix(vec2(last), vec2(first), up) + unknown;
    from = mix(from, vec2(-3e38), greaterThan(below, vec2(0.0)));
    to = mix(to, vec2(3e38), greaterThan(above, vec2(0.0)));
    r = vec2(max(r.x, max(from.x, from.y)), min(r.y, min(to.x, to.y)));
    vec3 gap = max(max(vec3(low.x, r.x, low.y), -vec3(high.x, r.y, high.y)), 0.0);

    float limit = r.y < 0.0 ? heights.z : r.x > 0.0 ? heights.w : min(heights.z, heights.w);
    convex = best < limit;
    return dot(gap, gap) < best && all(lessThanEqual(vec3(low, r.x), vec3(high, r.y)));
}
