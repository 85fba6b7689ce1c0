// What a texel of a field holds.
//
// storeDistance  in the world's units, positive above the patch, negative below
// Limits         the box of samples lies over the patch's rectangle: beside it there is no side to be on
#include "field/patch.glsl"

layout(location = 0) out vec4 outDistance;

void storeDistance(vec3 q, float distance) {
    outDistance = vec4((q.y < heightAt(q.xz) ? -distance : distance) * bake.rates.w);
}
