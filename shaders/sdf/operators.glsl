// What distance fields can be made into. A field at a point is {gradient, signed distance}.
//
// unite, intersect, subtract  the least, the greatest, the greatest of one and the negative of the other
// melt                        union that bends within `blend` of a seam (quadratic); never more than the union
// unplaced, placed            a point taken into a solid's own frame, and the field there brought back: scaled, turned
//                             by the unit quaternion, then moved. `placement` is {translation, scale}
// inCopy                      a point in the frame of a copy: of a window of so many along each axis, those nearest to
//                             the point, the one that is `at` in it
// Source  I. Quilez, Smooth Minimum, 2013 (the quadratic one); J. Hart, Sphere Tracing, 1996
const vec4 kNothing = vec4(0.0, 1.0, 0.0, 1e30);

vec4 unite(vec4 a, vec4 b) { return a.w <= b.w ? a : b; }
vec4 intersect(vec4 a, vec4 b) { return a.w >= b.w ? a : b; }
vec4 subtract(vec4 a, vec4 b) { return intersect(a, -b); }

vec4 melt(vec4 a, vec4 b, float blend) {
    float overlap = max(blend - abs(a.w - b.w), 0.0) / blend;
    vec4 near = unite(a, b);
    vec4 far = a.w <= b.w ? b : a;
    return vec4(mix(near.xyz, far.xyz, 0.5 * overlap), near.w - 0.25 * overlap * overlap * blend);
}

vec3 turned(vec3 v, vec4 q) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
vec3 unplaced(vec3 p, vec4 q, vec4 placement) { return turned(p - placement.xyz, vec4(-q.xyz, q.w)) / placement.w; }
vec4 placed(vec4 field, vec4 q, float scale) { return vec4(turned(field.xyz, q), field.w * scale); }

vec3 inCopy(vec3 p, vec3 period, vec3 count, vec3 window, vec3 at) {
    vec3 first = ceil(p / max(period, vec3(1e-20)) - 0.5 * window);
    return p - period * (clamp(first, vec3(0.0), count - window) + at);
}
