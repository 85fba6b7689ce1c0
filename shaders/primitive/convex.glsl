// What the closed convex shapes share: the interval of a ray inside of a solid, and the hit that follows from it.
//
// A span is the s of the two ends of that interval, along the re-centred ray; empty where x > y. A solid that is the
// common part of others has the common part of their spans, a convex union the hull.
//
// slabSpan    between two parallel planes at +-halfWidth of the coordinate p + s d
// roundSpan   within `radius` of the origin: a sphere; a cylinder where point and direction are laid across its axis
// meetConvex  the hit in (ray.tMin, t): where the ray enters or, from inside, where it leaves
// spanEnd     which end of the span the hit is: s, and end = -1 where the ray enters, +1 where it leaves
// Error       s: a few roundings of the shape's own size over the cosine of the angle of incidence
// Limits      a direction component below kParallel counts as 0: it drifts 1e-14 in 1e6 units, and no quotient
//             overflows. A ray that starts inside where rounding says that it passes by leaves where it starts.
const vec2 kNever = vec2(1e30, -1e30);
const vec2 kAlways = vec2(-1e30, 1e30);
const float kParallel = 1e-20;

vec2 commonSpan(vec2 a, vec2 b) {
    vec2 span = vec2(max(a.x, b.x), min(a.y, b.y));
    return span.x <= span.y ? span : kNever;
}

vec2 hullSpan(vec2 a, vec2 b) { return vec2(min(a.x, b.x), max(a.y, b.y)); }

vec2 slabSpan(float p, float d, float halfWidth) {
    vec2 s = (vec2(-halfWidth, halfWidth) - p) / d;
    vec2 ends = vec2(min(s.x, s.y), max(s.x, s.y));
    vec2 alongside = abs(p) <= halfWidth ? kAlways : kNever;
    return abs(d) < kParallel ? alongside : ends;
}

// Roots of a s² + 2 b s + c, given the discriminant b² - a c, which each shape has in a form that does not cancel.
vec2 rootsOf(float a, float b, float c, float discriminant) {
    float q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
    if (q == 0.0) return vec2(0.0);
    vec2 s = vec2(q / a, c / q);
    return vec2(min(s.x, s.y), max(s.x, s.y));
}

vec2 roundSpan(vec3 p, vec3 d, float radius) {
    float a = dot(d, d);
    float b = dot(p, d);
    float radial = length(p);
    if (a < kParallel) return radial <= radius ? kAlways : kNever;
    float l = length(p - (b / a) * d);
    float discriminant = a * (radius - l) * (radius + l);
    if (!(discriminant >= 0.0)) return kNever;
    return rootsOf(a, b, (radial - radius) * (radial + radius), discriminant);
}

bool meetConvex(NearRay near, vec2 span, Ray ray, float side, inout float t) {
    float entry = near.tHigh + (near.tLow + span.x);
    float leave = near.tHigh + (near.tLow + span.y);
    float hit = side < 0.0 ? max(leave, 0.0) : (entry > ray.tMin ? entry : leave);
    // What leaves a convex solid never comes back.
    bool meets = side <= 0.0 && hit < t && (side < 0.0 || (span.x <= span.y && hit > ray.tMin));
    t = meets ? hit : t;
    return meets;
}

float spanEnd(NearRay near, vec2 span, float t, out float end) {
    end = 1.0;
    if (!(span.x <= span.y)) return (t - near.tHigh) - near.tLow;
    float entry = near.tHigh + (near.tLow + span.x);
    float leave = near.tHigh + (near.tLow + span.y);
    if (t - entry <= leave - t) end = -1.0;
    return end < 0.0 ? span.x : span.y;
}

// +1 or -1: the side of a slab where the ray enters or leaves it; a parallel ray is on the side where its p is.
float slabSide(float p, float d, float end) { return (abs(d) < kParallel ? p : end * d) < 0.0 ? -1.0 : 1.0; }
