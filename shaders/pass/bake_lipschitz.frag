// How far a sample lies above the patch over a Lipschitz constant of that: no more than its distance, mostly far less.
//
// Limits   bake.bounds.x >= √(1 + greatest slope²)
#include "field/store.glsl"

void main() {
    vec3 q = samplePoint();
    outDistance = vec4((q.y - heightAt(q.xz)) / bake.bounds.x * bake.rates.w);
}
