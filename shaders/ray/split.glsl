// Ray parameters about a far point, exact to the shape's own size instead of to the distance from the eye.
//
// recentre  moves the ray's origin to its closest approach to `center`. Every product and every sum on the way is
//           exact: the factors are halves of 12 bits, rounded to nearest, so that each partial sum is a multiple of its
//           own last place; what the difference of origin and center loses is added at the end, where nothing cancels
//           any more. |error of the new origin| <= 1 ulp of the closest distance, from any distance (4.9e-4 naively at
//           1e4 units)
// passesBy  whether the ray's line passes a ball by, {centre, radius}, with the room that rounding from far away needs:
//           searches and shapes that are expensive to meet dismiss most objects by this alone. `paddedSquare`, of the
//           ray, is the same for all balls: not every compiler sees that
// Source    Dekker's splitting and Knuth's exact difference; figures in docs/numerics.md
// Limits    any direction but 0. Some compilers fold d - dh back into d, or (a - b) - a into -b: the zero of the frame
//           block, an optimisation barrier, keeps them apart
struct NearRay {
    vec3 origin;    // closest approach, relative to the centre
    float tHigh;    // t of the new origin is tHigh + tLow; tHigh has 12 bits
    float tLow;
};

float high12(float x) { return uintBitsToFloat((floatBitsToUint(x) + 0x800u) & 0xFFFFF000u); }
vec3 high12(vec3 x) { return uintBitsToFloat((floatBitsToUint(x) + uvec3(0x800u)) & uvec3(0xFFFFF000u)); }
vec3 optimisationBarrier(vec3 x) { return uintBitsToFloat(floatBitsToUint(x) ^ frame.zero.xyz); }

// What rounding took from difference = a - b.
vec3 lostBy(vec3 difference, vec3 a, vec3 b) {
    vec3 minusB = optimisationBarrier(difference - a);
    return (a - (difference - minusB)) - (b + minusB);
}

NearRay recentre(vec3 origin, vec3 center, vec3 direction) {
    vec3 toOrigin = optimisationBarrier(origin - center);
    float t = -dot(toOrigin, direction) / dot(direction, direction);
    float tHigh = high12(t);
    float tLow = t - tHigh;
    vec3 high = high12(direction);
    vec3 low = optimisationBarrier(direction - high);
    vec3 closest = ((toOrigin + tHigh * high) + tHigh * low) + tLow * high;
    return NearRay(closest + (tLow * low + lostBy(toOrigin, origin, center)), tHigh, tLow);
}

float paddedSquaredLength(Ray ray) { return 1.00001 * dot(ray.direction, ray.direction); }

bool passesBy(Ray ray, float paddedSquare, vec4 ball) {
    vec3 toOrigin = ray.origin - ball.xyz;
    vec3 moment = cross(toOrigin, ray.direction);
    float room = ball.w + 1e-6 * (abs(toOrigin.x) + abs(toOrigin.y) + abs(toOrigin.z));
    return dot(moment, moment) > room * room * paddedSquare;
}

bool passesBy(Ray ray, vec4 ball) { return passesBy(ray, paddedSquaredLength(ray), ball); }
