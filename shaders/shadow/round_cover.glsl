// What a sphere covers of a light's disc, in closed form.
//
// coverRound  m: its centre from the apex in the cone's axes, radius: its own, both over the distance to the light;
//             tangent: squared length of its tangents from the apex, |m|² - radius². Any common factor of m and radius
//             is allowed where `light`, the distance to the light, is given in the same unit: a huge sphere takes its
//             radius for 1.
//
// The disc and the sphere are symmetric about the line through the disc's centre towards m. Along it, at x, the
// silhouette has the half width sqrt(g(x)) with g quadratic: an ellipse, or a branch of a hyperbola where the
// silhouette has no end. Seen from the apex all tangents are equally long. Where they end before the light's disc, g is
// that of the tangent cone, else that of the circle in which the sphere cuts the disc's plane. Either meets the unit
// circle at one x: beyond it the silhouette is the wider one, before it the disc.
// Error       1e-5 of the disc for slopes from .003 (tests/shader/silhouette_test.cpp)
// Limits      where the tangents end within the light's disc one of the two silhouettes stands for both
#include "shadow/cover.glsl"

// Area of |y| < sqrt(g(x)) from its left end to `end`, g(x) = (x - left) * (2 rise + bend * (x - left)).
float conicArea(float left, float end, float rise, float bend) {
    float semi = rise / max(-bend, 1e-20); // half its width, where bend < 0
    end = bend < 0.0 ? min(end, left + 2.0 * semi) : end;
    float wide = end - left;
    if (!(wide > 0.0)) return 0.0;
    if (bend < 0.0 && semi < 4.0) {
        float x = clamp(wide / semi - 1.0, -1.0, 1.0);
        return semi * semi * sqrt(-bend) * segmentArea(-x);
    }
    // Nearly a parabola: Gauss' rule for five points, after x = left + wide t² has taken the root's own root away.
    const vec4 kAt = vec4(0.046910077, 0.230765345, 0.769234655, 0.953089923);
    const vec4 kWeight = vec4(0.118463443, 0.239314335, 0.239314335, 0.118463443);
    vec4 height = sqrt(max(2.0 * rise + bend * wide * kAt * kAt, 0.0));
    float middle = sqrt(max(2.0 * rise + 0.25 * bend * wide, 0.0));
    return 4.0 * wide * sqrt(wide) * (dot(kWeight * kAt * kAt, height) + 0.284444444 * 0.25 * middle);
}

// q.x between the roots of p x² + 2 h x + c >= 0, p < 0; or on that side of them where along * x + offset > 0.
void rowsOf(vec4 p, vec4 h, vec4 c, float along, vec4 offset, out vec4 low, out vec4 high) {
    vec4 square = h * h - p * c;
    vec4 root = sqrt(max(square, 0.0));
    vec4 sum = -(h + mix(root, -root, vec4(lessThan(h, vec4(0.0)))));
    sum = mix(sum, vec4(1e-20), vec4(equal(sum, vec4(0.0))));
    vec4 one = sum / p;
    vec4 other = c / sum;
    vec4 least = min(one, other);
    vec4 most = max(one, other);
    vec4 open = vec4(greaterThan(p, vec4(0.0)));
    vec4 middle = 0.5 * (least + most);
    vec4 empty = vec4(lessThanEqual(square, vec4(0.0))) + vec4(lessThanEqual(along * middle + offset, vec4(0.0)));
    vec4 none = (1.0 - open) * min(empty, 1.0);
    low = mix(least, along > 0.0 ? most : vec4(-1e9), open);
    high = mix(most, along > 0.0 ? vec4(1e9) : least, open);
    low = mix(low, vec4(2.0), none);
    high = mix(high, vec4(-2.0), none);
}

Cover coverRound(vec3 m, float radius, float tangent, float light, float slope) {
    if (!(tangent > 0.0)) return coverFromInside();
    float a = max(length(m.xy), 1e-9 * (abs(m.z) + radius));
    bool whole = tangent < light * light * (1.0 + 0.5 * slope * slope); // tangents end before the disc
    float inAxis = whole ? (radius - a) * (radius + a) : radius * radius - (m.z - light) * (m.z - light) - a * a;
    float scale = whole ? tangent : light * light;
    // g(x) = bend x² + 2 lean x + level
    float bend = whole ? a * a / tangent - 1.0 : -1.0;
    float lean = whole ? a * m.z / (tangent * slope) : a / (light * slope);
    float level = inAxis / (scale * slope * slope);
    float rise2 = whole ? radius * radius / (tangent * slope * slope) : lean * lean + level;
    float rise = sqrt(max(rise2, 0.0));
    if (!(lean + rise > 0.0 && rise2 > 0.0)) return coverNothing(); // behind the apex, or off the disc's plane
    float left = -level / (lean + rise);
    float meet = whole ? (sqrt(tangent * (1.0 + slope * slope)) - m.z) / (slope * a)
                       : 0.5 * (1.0 - level) / lean;
    if (left >= 1.0) return coverNothing();
    Cover cover;
    cover.area = segmentArea(meet) + (meet > -1.0 ? conicArea(left, min(meet, 1.0), rise, bend) : 0.0);
    for (int i = 0; i < 4; ++i) {
        vec4 offset = whole ? m.z + slope * m.y * kRows[i] : vec4(1.0);
        float along = whole ? slope * m.x : 0.0;
        float least = whole ? tangent * slope * slope : 1.0;
        vec4 p = vec4(along * along - least);
        p = mix(p, vec4(-1e-12), vec4(equal(p, vec4(0.0))));
        vec4 h = whole ? along * offset : vec4(m.x / (light * slope));
        vec4 c = whole ? offset * offset - tangent * (1.0 + slope * slope * kRows[i] * kRows[i])
                       : 2.0 * m.y / (light * slope) * kRows[i] - kRows[i] * kRows[i] + (level);
        rowsOf(p, h, c, along, offset, cover.low[i], cover.high[i]);
    }
    return cover;
}
