// The scene as one distance: what all that casts shadows leaves free about a point.
//
// sceneDistance  xyz: gradient, unit; w: signed distance of the nearest of all objects that cast shadows, with `from` as the
//                shapes' own distances take it; beyond all numbers where there is none
// Error          that of the nearest object's shape. Where bodies overlap, w inside is that of the deepest one: a bound from
//                above for the way out of all of them
// Cost           every object once: one loop a kind
#for Shape in CASTERS
#include "primitive/$shape.glsl"
#endfor
#if OUTPUT == STEPS
#include "sdf/count.glsl"
#endif

vec4 sceneDistance(vec3 p, vec3 from) {
#if OUTPUT == STEPS
    ++evaluations;
#endif
    vec4 nearest = vec4(0.0, 1.0, 0.0, 3e38);
#for Shape in CASTERS
    for (int i = 0; i < k$ShapeCasters; ++i) {
        vec4 other = distance$Shape(load$Shape(k$ShapeBase + i * k$ShapeTexels), p, from);
        nearest = other.w < nearest.w ? other : nearest;
    }
#endfor
    return nearest;
}
