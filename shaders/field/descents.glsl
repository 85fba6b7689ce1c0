// The third source's way to a field: descents of a fixed number of steps from several points, the best of their ends.
//
// stepAgainst  of the method: from the gradient, what it has averaged, and its rates to the powers of the steps so far
// Source       S3: D = |x - q|², starts under the sample and on a grid; the gradient is what is left of a short step
//              against it once that is projected into the square, and the step itself is projected, too
// Limits       no bound: descents end where they are after bake.counts.z steps
#include "field/store.glsl"

vec3 towards(vec3 q, vec2 x, float height) { return vec3(x.x, height, x.y) - q; }

float descendFrom(vec3 q, vec2 x) {
    const float kShort = 1e-4;
    vec2 first = vec2(0.0);
    vec2 second = vec2(0.0);
    vec2 powers = vec2(1.0);
    for (int i = 0; i < bake.counts.z; ++i) {
        Jet jet = jetOf(x);
        vec3 d = towards(q, x, jet.height);
        vec2 g = 2.0 * (d.xz + d.y * jet.slope);
        g = clamp(g, (x - bake.sides.xy) / kShort, x / kShort); // (x - projected(x - kShort g)) / kShort
        powers *= bake.rates.yz;
        x = clamp(x - bake.rates.x * stepAgainst(g, first, second, powers), vec2(0.0), bake.sides.xy);
    }
    vec3 d = towards(q, x, heightAt(x));
    return dot(d, d);
}

void main() {
    vec3 q = samplePoint();
    float best = descendFrom(q, q.xz);
    int n = int(ceil(sqrt(float(bake.counts.w - 1))));
    for (int i = 0; i < bake.counts.w - 1; ++i)
        best = min(best, descendFrom(q, (vec2(i % n, i / n) + 0.5) / float(n) * bake.sides.xy));
    storeDistance(q, sqrt(best));
}
