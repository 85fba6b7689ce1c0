// The fraction of a light that is seen at `samples` points of its disc: (phi, sqrt(u)) of Halton's sequence in bases 2
// and 3, shifted at random from pixel to pixel, so that too few samples show as noise and not as bands. A model says
// beforehand
//
// hidden  whether anything stands before the one point of the disc that the query goes to, as to a light without size
//
// Error  falls about as 1 / samples^(3/4)
// Limits llvmpipe ends all loops of a pixel after 65 536 iterations in all: what is read back takes many samples in
//        several draws (Renderer; how many in one is said in the model's row), a window draws all at once
// Source J. Halton, On the efficiency of certain quasi-random sequences, 1960; R. Cranley and T. Patterson, 1976,
//        for the shift
#include "shadow/frame_about.glsl"
#include "shadow/pixel_shift.glsl"

// The digits of `index` mirrored at the point: 32 of base 2, 20 of base 3.
float mirrored2(uint index) {
    index = (index << 16u) | (index >> 16u);
    index = ((index & 0x00FF00FFu) << 8u) | ((index & 0xFF00FF00u) >> 8u);
    index = ((index & 0x0F0F0F0Fu) << 4u) | ((index & 0xF0F0F0F0u) >> 4u);
    index = ((index & 0x33333333u) << 2u) | ((index & 0xCCCCCCCCu) >> 2u);
    index = ((index & 0x55555555u) << 1u) | ((index & 0xAAAAAAAAu) >> 1u);
    return float(index >> 8u) / 16777216.0;
}

float mirrored3(uint index) {
    float sum = 0.0;
    float weight = 1.0 / 3.0;
    for (int i = 0; i < 20 && index > 0u; ++i) {
        sum += weight * float(index % 3u);
        index /= 3u;
        weight /= 3.0;
    }
    return sum;
}

float visibility(ShadowQuery query) {
    mat2x3 across = frameAbout(query.ray.direction);
    float slope = discSlope(query.distance, query.lightRadius);
    vec2 shift = pixelShift(floatBitsToUint(query.ray.direction.x));
    int seen = 0;
    for (int i = 0; i < frame.samples; ++i) {
        uint index = uint(frame.firstSample + i + 1);
        vec2 u = fract(vec2(mirrored2(index), mirrored3(index)) + shift);
        float phi = 6.28318530717959 * u.x;
        vec3 toDisc = query.ray.direction + slope * sqrt(u.y) * (across * vec2(cos(phi), sin(phi)));
        float secant = length(toDisc);
        ShadowQuery toPoint = query;
        toPoint.ray.direction = toDisc / secant;
        toPoint.distance = query.distance * secant;
        toPoint.lightRadius = 0.0;
        // Below the horizon: the solid itself.
        if (dot(toPoint.ray.direction, query.normal) <= 0.0 && query.ray.self >= 0) continue;
        if (!hidden(toPoint)) ++seen;
    }
    return float(seen) / float(max(frame.samples, 1));
}
