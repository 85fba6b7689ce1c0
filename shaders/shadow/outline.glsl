// What a convex outline covers of a light's disc: the exact area of its polygon, and of the arcs over the polygon's
// edges.
//
// A solid's outline is drawn in the cone's space, where the light's disc is z = 1 and |(x, y)| <= z: startOutline()
// where it begins, edgeTo() from corner to corner, closeOutline(). What lies behind the apex or beyond the disc is cut
// off on the way.
//
// coverRims   of a solid between two round rims, joined by two straight edges: what cylinder, capsule and cone are
// Error       polygons: roundings. Arcs: parabolas over steps of 23° or half the disc: .001 of the disc
// Source      area of edge PQ within the circle at P', Q': (angle(P, P') + P' x Q' + angle(Q', Q)) / 2; the angle alone
//             where it passes the circle by
// Limits      convex. A rim that reaches beyond the disc is cut along a chord
#include "shadow/cover.glsl"

const float kNearest = 1e-5; // nearer to the apex than that fraction of the light's distance nothing is seen

struct Outline {
    float area; // signed
    vec3 at;    // the corner drawn last, uncut
    vec2 pen;   // as seen from the apex
    vec2 start;
    bool begun;
    mat4 low;
    mat4 high;
};

Outline startOutline(vec3 corner) { return Outline(0.0, corner, vec2(0.0), vec2(0.0), false, kBeyond, -kBeyond); }

float turned(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// A rotation (cosine, sine) in a unit that no product overflows; none where both are 0.
vec2 unitRotation(vec2 rotation) {
    return rotation == vec2(0.0) ? vec2(1.0, 0.0) : rotation / max(abs(rotation.x), abs(rotation.y));
}

// atan(v.y, v.x), 0 of nothing. SwiftShader's own is off by pi for some angles of about half a circle.
float angleOf(vec2 v) {
    float fromAxis = 2.0 * atan(v.y / max(length(v) + abs(v.x), 1e-30));
    return v.x >= 0.0 ? fromAxis : (v.y >= 0.0 ? kPi : -kPi) - fromAxis;
}

// An edge as it is seen; `bulge` is what the arc over it adds to its area. Worked out from its end that is nearer to
// the disc: the other may be far out.
void draw(inout Outline outline, vec2 from, vec2 to, float bulge) {
    bool swapped = dot(to, to) < dot(from, from);
    vec2 p = swapped ? to : from;
    vec2 q = swapped ? from : to;
    vec2 d = q - p;
    float square = max(dot(d, d), 1e-24);
    float off = turned(p, d);
    float foot = -dot(p, d) / square;
    float root = sqrt(max(square - off * off, 0.0)) / square;
    bool meets = square > off * off;
    float in0 = meets ? clamp(foot - root, 0.0, 1.0) : 0.0;
    float in1 = meets ? clamp(foot + root, 0.0, 1.0) : 0.0;
    // Not turned(p, a) and so on: far out fused multiply-adds leave that of equal points a whole unit.
    vec2 a = unitRotation(vec2(dot(p, p + in0 * d), in0 * off));
    vec2 b = unitRotation(vec2(dot(p + in1 * d, q), (1.0 - in1) * off));
    vec2 rotation = vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
    float signedArea = 0.5 * (angleOf(rotation) + (in1 - in0) * off);
    outline.area += (swapped ? -signedArea : signedArea) +
        bulge * (in1 * in1 * (3.0 - 2.0 * in1) - in0 * in0 * (3.0 - 2.0 * in0));
    float rise = abs(d.y) < 1e-12 ? 1e-12 : d.y;
    for (int i = 0; i < 4; ++i) {
        vec4 part = (kRows[i] - p.y) / rise;
        vec4 x = p.x + part * d.x;
        vec4 past = vec4(lessThan(part, vec4(0.0))) + vec4(greaterThan(part, vec4(1.0)));
        outline.low[i] = min(outline.low[i], x + 1e9 * past);
        outline.high[i] = max(outline.high[i], x - 1e9 * past);
    }
}

void edgeTo(inout Outline outline, vec3 to, float bulge) {
    vec3 from = outline.at;
    float dz = to.z - from.z;
    float perDz = 1.0 / (abs(dz) < 1e-12 ? 1e-12 : dz);
    vec2 cuts = (vec2(kNearest, 1.0) - from.z) * perDz;
    float enter = max(min(cuts.x, cuts.y), 0.0);
    float leave = min(max(cuts.x, cuts.y), 1.0);
    outline.at = to;
    vec3 a = mix(from, to, clamp(enter, 0.0, 1.0));
    vec3 b = mix(from, to, clamp(leave, 0.0, 1.0));
    vec2 p = a.xy / max(a.z, kNearest);
    vec2 q = b.xy / max(b.z, kNearest);
    bool seen = enter <= leave;
    bool cut = enter > 0.0 || leave < 1.0;
    if (seen && !outline.begun) outline.start = p;
    // Along the plane of the cut first, where the last edge ended there.
    bool back = enter > 0.0 && outline.begun;
    int edges = seen ? (back ? 2 : 1) : 0;
    for (int i = 0; i < edges; ++i) {
        bool along = back && i == 0;
        draw(outline, along ? outline.pen : p, along ? p : q, along || cut ? 0.0 : bulge);
    }
    if (seen) {
        outline.pen = q;
        outline.begun = true;
    }
}

void closeOutline(inout Outline outline) {
    bool open = outline.begun && distance(outline.pen, outline.start) > 1e-6;
    for (int i = 0; i < (open ? 1 : 0); ++i) draw(outline, outline.pen, outline.start, 0.0);
}

Cover coverOf(Outline outline) { return Cover(min(abs(outline.area), kPi), outline.low, outline.high); }

// Points center + cos(phi) first + sin(phi) second in the cone's space, phi from `from` to from + sweep.
struct Rim {
    vec3 center;
    vec3 first;
    vec3 second;
    float from;
    float sweep;
};

vec3 onRim(Rim rim, float phi) { return rim.center + cos(phi) * rim.first + sin(phi) * rim.second; }

// From rim to rim and back; a rim without sweep is a point. `alone`: nothing but the first.
Cover coverRims(Rim one, Rim other, bool alone) {
    const int kMostSteps = 64;
    const float kWidest = 0.4;
    vec3 back = onRim(one, one.from);
    vec3 over = onRim(other, other.from);
    Outline outline = startOutline(back);
    float done = 0.0;
    int part = 0; // 0: first rim, 1: over to the second, 2: second rim, 3: back
    for (int i = 0; i < kMostSteps && part < 4; ++i) {
        Rim rim = one;
        if (part == 2) rim = other;
        bool straight = part == 1 || part == 3;
        vec3 at = outline.at;
        float phi = rim.from + sign(rim.sweep) * done;
        float left = abs(rim.sweep) - done;
        vec3 along = cos(phi) * rim.second - sin(phi) * rim.first;
        float room = max(0.7 * (length(at.xy) - at.z), 0.5 * abs(at.z)); // the disc is no nearer, or half a disc
        float step = min(clamp(room / max(length(along), 1e-12), 0.004, kWidest), left);
        vec3 to = onRim(rim, phi + sign(rim.sweep) * step);
        vec3 middle = onRim(rim, phi + 0.5 * sign(rim.sweep) * step);
        if (straight) to = part == 1 ? over : back;
        vec2 p = at.xy / max(at.z, kNearest);
        vec2 chord = to.xy / max(to.z, kNearest) - p;
        vec2 toMiddle = middle.xy / max(middle.z, kNearest) - p;
        edgeTo(outline, to, straight ? 0.0 : turned(toMiddle, chord) * (2.0 / 3.0));
        done += step;
        if (straight || done >= abs(rim.sweep) - 1e-5) {
            part = alone ? 4 : (part == 1 && other.sweep == 0.0 ? 3 : part + 1);
            done = 0.0;
        }
    }
    closeOutline(outline);
    return coverOf(outline);
}
