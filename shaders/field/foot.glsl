// The foot of a point on a height patch: projected Newton on half the squared distance.
//
// descend    from `x` within [low, high]; `best` becomes the least squared distance that is met, `x` where it ends
// Source     Newton's method, each step to the least of the quadratic between the bounds. Half the squared distance is
//            a bent valley on steep patches: steps may lead up four times, then only down, else back to a quarter
// Error      of the minimum that it ends in: its squared distance is that of a step of 3e-4 beside it
// Limits     finds one minimum of several, or a saddle that it begins on
#include "field/patch.glsl"

// What the quadratic of gradient g and Hessian h (xx, zz, xz) changes by.
float change(vec2 s, vec2 g, vec3 h) { return dot(s, g + 0.5 * (h.xy * s + h.z * s.yx)); }

// The step to the least of that quadratic, made convex, between the bounds. Where it lies beyond, one coordinate is put
// onto its bound and the other solved again: of both ways the better one.
vec2 newtonStep(vec2 g, vec3 h, vec2 low, vec2 high) {
    float least = 0.5 * (h.x + h.y) - length(vec2(0.5 * (h.x - h.y), h.z));
    vec2 c = h.xy + max(0.05 - least, 0.0);
    vec2 whole = (h.z * g.yx - c.yx * g) / (c.x * c.y - h.z * h.z);
    vec2 s = clamp(whole, low, high);
    vec2 other = clamp(-(g + h.z * s.yx) / max(abs(h.xy), 0.05), low, high);
    vec2 first = vec2(s.x, other.y);
    vec2 second = vec2(other.x, s.y);
    return s == whole ? s : change(first, g, h) < change(second, g, h) ? first : second;
}

void descend(vec3 q, inout vec2 x, vec2 low, vec2 high, inout float best) {
    vec2 from = x;
    vec2 s = vec2(1.0);
    float least = 3e38;
    for (int i = 0; i < 17; ++i) {
        Jet jet = jetOf(x);
        vec3 d = vec3(x.x, jet.height, x.y) - q;
        float square = dot(d, d);
        best = min(best, square);
        if (dot(s, s) < 1e-7) break;
        bool back = i > 4 && square > least;
        vec2 g = d.xz + d.y * jet.slope;
        vec3 h = vec3(1.0, 1.0, 0.0) + jet.slope.xyx * jet.slope.xyy + d.y * jet.bend;
        vec2 next = newtonStep(g, h, low - x, high - x);
        from = back ? from : x;
        least = back ? least : square;
        s = back ? 0.25 * s : next;
        x = clamp(from + s, low, high);
    }
}
