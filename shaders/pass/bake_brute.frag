// The nearest of n × n points of the patch, those at the ends on its borders.
//
// Error   none but roundings beside those points; beside the patch about the square of how far they lie apart
#include "field/store.glsl"

void main() {
    vec3 q = samplePoint();
    float best = 3e38;
    float last = float(bake.counts.w - 1);
    for (int j = 0; j < bake.counts.w; ++j) {
        float v = float(j) / last;
        vec4 across = bake.net * bernstein(v);
        for (int i = 0; i < bake.counts.w; ++i) {
            float u = float(i) / last;
            vec3 d = vec3(bake.sides.x * u, dot(bernstein(u), across), bake.sides.y * v) - q;
            best = min(best, dot(d, d));
        }
    }
    storeDistance(q, sqrt(best));
}
