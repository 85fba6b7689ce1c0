// Ray parameters about a far point, exact to the shape's own size instead of to the distance from the eye.
//
// recentre  moves the ray's origin to its closest approach to the shape's centre. The products that cancel are made of
//           12-bit halves and so are exact: |error of the new origin| <= 4 ulp of the closest distance + 4e-8 of the old
//           origin's own rounding (3.4e-7 against 4.9e-4 units naively at 1e4 units).
// Source    Dekker's splitting; figures in docs/numerics.md
// Limits    some compilers fold d - dh back into d: the zero of the frame block, opaque to them, keeps it apart
struct NearRay {
    vec3 origin;    // closest approach, relative to the centre
    float tHigh;    // t of the new origin is tHigh + tLow; tHigh has 12 bits
    float tLow;
};

float high12(float x) { return uintBitsToFloat(floatBitsToUint(x) & 0xFFFFF000u); }
vec3 high12(vec3 x) { return uintBitsToFloat(floatBitsToUint(x) & uvec3(0xFFFFF000u)); }

NearRay recentre(vec3 toOrigin, vec3 direction) {
    float t = -dot(toOrigin, direction) / dot(direction, direction);
    float tHigh = high12(t);
    float tLow = t - tHigh;
    vec3 high = high12(direction);
    vec3 low = uintBitsToFloat(floatBitsToUint(direction - high) ^ frame.zero.xyz);
    vec3 closest = ((toOrigin + tHigh * high) + tHigh * low) + tLow * direction;
    return NearRay(closest, tHigh, tLow);
}
