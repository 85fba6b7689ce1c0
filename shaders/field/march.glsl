// Rays through a field, to where the distance changes its sign.
//
// marchField     the s in [from, to] at which side * distance falls through 0 first; beyond `to` where it does not.
//                o + s d in units of the scene from the middle of the box, d unit. `leaves`: the ray starts on the
//                surface, which then is no hit
// voxel          by the exact root of the cubic that the ray sees in each voxel, with steps as long as the samples say
//                that nothing is near
// sphere         by sphere tracing, to frame.fieldEpsilon voxels
// relaxed        the same with longer steps that are taken back where they were too long
// Source         the cubic: H. Hansson-Söderlund et al., Ray Tracing of Signed Distance Function Grids, JCGT 2022;
//                relaxed: B. Keinert et al., Enhanced Sphere Tracing, 2014
// Limits         frame.fieldSteps: a ray that needs more meets nothing
#include "field/field.glsl"

#if FIELD_MARCH == FIELD_MARCH_VOXEL
// c0 + c1 t + c2 t² + c3 t³ of what the samples make of o + t d, with o from the voxel's lowest corner.
vec4 cubicAlong(Voxel voxel, vec3 o, vec3 d) {
    vec4 z0 = mix(voxel.near, voxel.far, o.z), z1 = (voxel.far - voxel.near) * d.z;
    vec2 y0 = mix(z0.xy, z0.zw, o.y), y1 = mix(z1.xy, z1.zw, o.y) + (z0.zw - z0.xy) * d.y, y2 = (z1.zw - z1.xy) * d.y;
    return vec4(mix(y0.x, y0.y, o.x), mix(y1.x, y1.y, o.x) + (y0.y - y0.x) * d.x,
        mix(y2.x, y2.y, o.x) + (y1.y - y1.x) * d.x, (y2.y - y2.x) * d.x);
}

float cubicAt(vec4 c, float t) { return c.x + t * (c.y + t * (c.z + t * c.w)); }

// The first t in [0, end] where the cubic falls through 0; beyond `end` where it does not.
float firstFallOf(vec4 c, float end) {
    // Between its extrema it is monotonous.
    float a = 3.0 * c.w, square = c.z * c.z - a * c.y;
    float q = -(c.z + (c.z < 0.0 ? -1.0 : 1.0) * sqrt(max(square, 0.0)));
    vec2 turns = square > 0.0 && q != 0.0 ? vec2(a == 0.0 ? end : q / a, c.y / q) : vec2(end);
    turns = clamp(vec2(min(turns.x, turns.y), max(turns.x, turns.y)), 0.0, end);
    vec4 at = vec4(0.0, turns, end);
    vec4 value = vec4(c.x, cubicAt(c, at.y), cubicAt(c, at.z), cubicAt(c, at.w));
    vec2 range = value.x >= 0.0 && value.y < 0.0 ? at.xy : value.y >= 0.0 && value.z < 0.0 ? at.yz : at.zw;
    if (!(cubicAt(c, range.x) >= 0.0 && cubicAt(c, range.y) < 0.0)) return 2.0 * end + 1.0;
    float t = 0.5 * (range.x + range.y);
    for (int i = 0; i < 8; ++i) {
        float off = cubicAt(c, t);
        range = off >= 0.0 ? vec2(t, range.y) : vec2(range.x, t);
        float next = t - off / min(c.y + t * (2.0 * c.z + t * a), -1e-30);
        t = next > range.x && next < range.y ? next : 0.5 * (range.x + range.y);
    }
    return t;
}

float marchField(Field field, vec3 o, vec3 d, float from, float to, float side, bool leaves) {
    vec3 size = voxelSize(field);
    vec3 start = inVoxels(field, o), step = d / size;
    vec3 ahead = vec3(greaterThan(step, vec3(0.0)));
    ivec3 way = ivec3(sign(step));
    vec3 slow = 1.0 / mix(vec3(1e-20), step, greaterThan(abs(step), vec3(1e-20)));
    float diagonal = length(size);
    float s = from;
    ivec3 cell = cellAt(field, start + s * step);
    for (int i = 0; i < frame.fieldSteps && s < to; ++i) {
        vec3 ends = (vec3(cell) + ahead - start) * slow;
        ends = mix(vec3(1e30), ends, notEqual(way, ivec3(0)));
        float end = min(ends.x, min(ends.y, ends.z));
        float free = side * fieldAt(field, start + s * step);
        if (free > 2.0 * diagonal) {
            s = max(end, s + free - diagonal);
            cell = cellAt(field, start + s * step);
        } else {
            Voxel voxel = voxelAt(field, cell);
            voxel = Voxel(side * voxel.near, side * voxel.far);
            float stop = max(min(end, to) - s, 0.0);
            float fall = firstFallOf(cubicAlong(voxel, start + s * step - vec3(cell), step), stop);
            if (fall <= stop) return s + fall;
            s = max(s, end);
            cell += way * ivec3(lessThanEqual(ends, vec3(end)));
        }
        if (any(lessThan(cell, ivec3(0))) || any(greaterThan(cell, ivec3(field.samples - 2)))) return to + 1.0;
    }
    return to + 1.0;
}
#else
float marchField(Field field, vec3 o, vec3 d, float from, float to, float side, bool leaves) {
    vec3 size = voxelSize(field);
    float voxel = min(size.x, min(size.y, size.z));
    float least = frame.fieldEpsilon * voxel;
    float s = from;
    bool clear = !leaves;
#if FIELD_MARCH == FIELD_MARCH_RELAXED
    float relaxation = frame.fieldRelaxation;
    float taken = 0.0, known = 0.0;
#endif
    bool ends = false;
    for (int i = 0; i < frame.fieldSteps; ++i) {
        float free = side * fieldAt(field, inVoxels(field, o + s * d));
#if FIELD_MARCH == FIELD_MARCH_RELAXED
        if (relaxation > 1.0 && taken > 0.0 && free + known < taken) { // something may lie between
            s += known - taken;
            relaxation = 1.0;
            taken = 0.0;
            ends = false;
            continue;
        }
        known = free;
#endif
        if (clear && free < least) return s;
        if (ends) break;
        clear = clear || free > voxel;
        float step = clear ? free : max(abs(free), 0.25 * voxel);
#if FIELD_MARCH == FIELD_MARCH_RELAXED
        step *= clear ? relaxation : 1.0;
#endif
        ends = s + step >= to; // there once more: a step that was too long is taken back
#if FIELD_MARCH == FIELD_MARCH_RELAXED
        taken = min(step, to - s);
#endif
        s = min(s + step, to);
    }
    return to + 1.0;
}
#endif
