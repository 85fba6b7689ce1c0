// What a ring, the points at most `minor` from a circle of radius 1, covers of a light's disc: 64 rays, one amid each
// four points of the mask, are tested against the circle.
//
// Ring        its apex is the cone's, from the ring's middle; all its lengths and the cone's distance are in units of
//             the circle's radius
// ringPasses  where a ray passes the circle before and after it is nearest to the axis: on either side of one interval
//             about the axis the squared distance along the ray is convex (primitive/torus.glsl). Laguerre's steps,
//             which where the ray all but touches the circle and three roots meet still take two thirds of the way,
//             come to its least from without
// uniteRing   adds the cover. horizon: the surface's normal; own: it is the ring's
// Error       of the disc: 0.01, RMSE 0.0013; from points nearer to the ring than 1/50 of its tube's radius 0.015
//             (tests/shader/ring_cover_test.cpp)
// Why         a cell of the disc is hidden as far as a straight strip, the tube where the ray passes it, reaches into
//             it. That is right to second order and knows neither holes, nor folds of the outline, nor where the apex
//             stands. The cells that the ring hides of its own surface's sky and those below the horizon are nested,
//             not strewn
#include "shadow/cover.glsl"

struct Ring {
    vec3 apex;
    vec3 axis;
    float minor;
    float z;         // of the apex along the axis
    vec3 across;     // and across it
    float uncertain; // the square of a tangent from the apex, by as much
};

// Four points of the mask: two columns of two rows.
struct Cells {
    vec4 x;
    vec4 y;
    vec4 width;
    vec4 height;
};

// About `middle`, past an edge whose level rises by `facing` a unit: how far it rises over each, and within each.
vec4 riseTo(Cells cells, vec2 middle, vec2 facing) {
    return (cells.x - middle.x) * facing.x + (cells.y - middle.y) * facing.y;
}
vec4 riseWithin(Cells cells, vec2 facing) {
    vec4 rise = cells.width * cells.width * (facing.x * facing.x) + cells.height * cells.height * (facing.y * facing.y);
    return sqrt(rise) + 1e-6;
}

vec2 ringPasses(Ring ring, vec3 d) {
    const int kSteps = 4;
    vec3 step = d - dot(d, ring.axis) * ring.axis;
    float square = max(dot(step, step), 1e-12);
    float middle = -dot(ring.across, step) / square;
    vec3 least = ring.across + middle * step;
    float off2 = dot(least, least);
    float nearest = -dot(ring.apex, d); // to the ring's middle
    float reach = sqrt(square);
    vec2 s = vec2(min(nearest - reach, middle), max(nearest + reach, middle));
    for (int i = 0; i < kSteps; ++i) {
        vec2 off = s - middle;
        vec2 inverse = inversesqrt(square * off * off + off2 + 1e-20);
        vec2 rise = s - nearest - square * off * inverse; // of half the squared distance
        vec2 bent = square * off2 * inverse * inverse * inverse;
        vec2 slope = 1.0 - bent;
        vec2 bend = 3.0 * square * off * bent * inverse * inverse;
        s -= 4.0 * rise / max(slope + sqrt(max(9.0 * slope * slope - 12.0 * rise * bend, 0.0)), 1e-3);
        s = vec2(min(s.x, middle), max(s.y, middle));
    }
    return s;
}

// What the tube hides where the ray amid the cells, `secant` long for each unit along the cone's axis, passes the
// circle at s.
vec4 tubeOver(Ring ring, LightCone cone, vec3 d, float secant, vec2 middle, float s, Cells cells) {
    vec3 across = ring.across + s * (d - dot(d, ring.axis) * ring.axis);
    float fromAxis = length(across);
    vec3 outward = across / max(fromAxis, 1e-20);
    vec3 off = (fromAxis - 1.0) * outward + (ring.z + s * dot(d, ring.axis)) * ring.axis;
    float gap = length(off);
    vec3 beside = cross(cross(ring.axis, outward), d);
    beside *= dot(off, beside) < 0.0 ? -1.0 : 1.0;
    vec3 normal = gap < 0.05 * ring.minor ? beside / max(length(beside), 1e-20) : off / gap;
    vec2 facing = vec2(dot(normal, cone.axes[0]), dot(normal, cone.axes[1]));
    // Sines of the angles from the ray to either side of the ball about the circle's point, also where the ray recedes.
    float square = s * s + gap * gap;
    float tangent = sqrt(max(square - ring.minor * ring.minor, 0.0) + ring.uncertain);
    vec2 inside = (ring.minor * s + vec2(-tangent, tangent) * gap) * (secant / (cone.slope * max(square, 1e-20)));
    vec4 rise = riseTo(cells, middle, facing);
    vec4 wide = riseWithin(cells, facing);
    vec4 hidden = clamp(0.5 + (inside.x - rise) / wide, 0.0, 1.0) + clamp(0.5 + (inside.y + rise) / wide, 0.0, 1.0)
        - 1.0;
    float entry = s - sqrt(max(ring.minor * ring.minor - gap * gap, 0.0));
    return entry < cone.distance * secant ? max(hidden, 0.0) : vec4(0.0);
}

vec4 ringOver(Ring ring, LightCone cone, Cells cells) {
    vec2 middle = vec2(dot(cells.x, vec4(0.25)), dot(cells.y, vec4(0.25)));
    vec3 along = vec3(cone.slope * middle, 1.0);
    float secant = length(along);
    vec3 d = cone.axes * along / secant;
    vec2 s = ringPasses(ring, d);
    return max(tubeOver(ring, cone, d, secant, middle, s.x, cells),
        tubeOver(ring, cone, d, secant, middle, s.y, cells));
}

vec4 belowHorizon(LightCone cone, vec3 horizon, Cells cells) {
    vec3 normal = horizon * cone.axes;
    vec2 facing = cone.slope * normal.xy;
    return clamp(0.5 - (riseTo(cells, vec2(0.0), facing) + normal.z) / riseWithin(cells, facing), 0.0, 1.0);
}

// Between which x, or y, of the disc the ring's ball is seen: `off` and `ahead` lead to its middle.
vec2 ballSpan(float off, float ahead, float radius, float slope) {
    float square = off * off + ahead * ahead - radius * radius;
    if (ahead <= 1.01 * radius || square <= 0.0) return vec2(-2.0, 2.0);
    return (off * ahead + vec2(-radius, radius) * sqrt(square)) / ((ahead * ahead - radius * radius) * slope);
}

void uniteRing(Ring ring, LightCone cone, vec3 horizon, bool own, inout Shade shade) {
    const uvec4 kColumns = uvec4(0u, 1u, 0u, 1u);
    Points points = Points(uvec4(0u), uvec4(0u));
    vec2 counts = vec2(0.0); // all points, those that were bare
    vec3 center = -ring.apex * cone.axes;
    vec2 xs = ballSpan(center.x, center.z, 1.0 + ring.minor, cone.slope);
    vec2 ys = ballSpan(center.y, center.z, 1.0 + ring.minor, cone.slope);
    for (int i = 0; i < 8; ++i) { // two rows at once
        bool odd = (i & 1) == 1;
        uint half16 = (i & 2) == 2 ? 16u : 0u;
        vec2 y = odd ? kRows[i >> 1].zw : kRows[i >> 1].xy;
        vec2 halfWidth = odd ? kHalfWidths[i >> 1].zw : kHalfWidths[i >> 1].xy;
        vec2 shift = odd ? kShifts[i >> 1].zw : kShifts[i >> 1].xy;
        uvec4 four = (i < 4 ? shade.hidden.lower : shade.hidden.upper) >> half16;
        uvec4 before = odd ? four.zzww : four.xxyy;
        Cells cells = Cells(vec4(0.0), y.xxyy, halfWidth.xxyy * 0.125, (kPi / 32.0) / halfWidth.xxyy);
        uvec4 found = uvec4(0u);
        // A cell reaches half its height, and the square about one that is as wide, beyond its point.
        bool reached = y.x - cells.height.x < ys.y && y.y + cells.height.z > ys.x;
        float narrow = 4.0 / min(halfWidth.x, halfWidth.y);
        float wide = 4.0 / max(halfWidth.x, halfWidth.y);
        int from = int(clamp(floor(2.0 + (xs.x > 0.0 ? wide : narrow) * xs.x), 0.0, 8.0));
        int to = reached ? int(clamp(ceil(6.0 + (xs.y > 0.0 ? narrow : wide) * xs.y), 0.0, 8.0)) : 0;
        for (int j = from; j < to; ++j) { // two columns
            uvec4 column = 2u * uint(j) + kColumns;
            cells.x = cells.width * (vec4(column) - 7.5 + shift.xxyy);
            vec4 hidden = ringOver(ring, cone, cells);
            vec4 below = own ? belowHorizon(cone, horizon, cells) : vec4(0.0);
            vec4 bare = mix(vec4(1u - ((before >> column) & 1u)), vec4(1.0), vec4(greaterThan(below, vec4(0.5))));
            counts += vec2(dot(hidden, vec4(1.0)), dot(max(hidden - below, 0.0), bare));
            found |= uvec4(greaterThan(hidden, vec4(0.5))) << column;
        }
        uvec2 rows = (found.xz | found.yw) << half16;
        uvec4 set = odd ? uvec4(0u, 0u, rows) : uvec4(rows, 0u, 0u);
        points.lower |= i < 4 ? set : uvec4(0u);
        points.upper |= i < 4 ? uvec4(0u) : set;
    }
    counts *= kPi / 256.0;
    shade.area += counts.y;
    shade.largest = max(shade.largest, counts.x);
    shade.hidden = together(shade.hidden, points);
    shade.count = countOf(shade.hidden);
}
