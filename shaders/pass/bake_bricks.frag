// What a brick of samples has in common: the coarsest cells that feet of its samples may lie in, and a start.
//
// outBrick   xy: a bit a cell, the first row's in the lowest of x; zw: bits of the foot of the brick's middle
// Source     no sample is farther from the patch than the middle by more than it is from the middle
#include "field/cells.glsl"
#include "field/foot.glsl"

layout(location = 0) out uvec4 outBrick;

void main() {
    vec3 first = float(bake.counts.y) * vec3(floor(gl_FragCoord.xy), float(slice));
    vec3 low = samplePoint(first);
    vec3 high = samplePoint(min(first + float(bake.counts.y - 1), float(bake.counts.x - 1)));
    vec3 q = 0.5 * (low + high);
    vec3 spread = 0.5 * (high - low) + 1e-6;
    vec2 side = bake.sides.xy / float(kCoarsest);
    vec3 nearest = vec3(0.0, 0.0, 3e38);
    for (int j = 0; j < kCoarsest; ++j)
        for (int i = 0; i < kCoarsest; ++i) {
            vec2 x = (vec2(i, j) + 0.5) * side;
            vec3 d = vec3(x.x, heightAt(x), x.y) - q;
            nearest = dot(d, d) < nearest.z ? vec3(x, dot(d, d)) : nearest;
        }
    vec2 x = nearest.xy;
    float best = 3e38;
    descend(q, x, vec2(0.0), bake.sides.xy, best);
    float reach = sqrt(best) + length(spread);
    uvec2 mask = uvec2(0u);
    for (int j = 0; j < kCoarsest; ++j) {
        uint row = 0u;
        for (int i = 0; i < kCoarsest; ++i) {
            bool convex;
            row |= mayHold(ivec3(i, j, kCoarsest), q, spread, reach * reach, convex) ? 1u << i : 0u;
        }
        if (j < 4)
            mask.x |= row << (8 * j);
        else
            mask.y |= row << (8 * (j - 4));
    }
    outBrick = uvec4(mask, floatBitsToUint(x));
}
