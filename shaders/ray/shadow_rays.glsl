// Hard shadows of the lights' centres by the tree's own search: the surface that was met last asks its lights, then the tree goes
// on. One search in the shader finds what is in the way and what is nearest: there is a quarter less to compile, and on wide SIMD
// a pixel's shadow rays run beside its neighbours' next rays.
//
// The tree's ray starts where its shadow rays do, on the surface that was met last; one that has waited is fetched only when they
// are done. So they need no place of their own, which would hold registers.
//
// nearestPastShadows  adds the light that arrives, then meets the next ray as nearestHit() does. `ahead` says whether the tree's ray
//                     is to be met; where it is not and none waits, nothing is met and `ahead` stays false
struct ShadowRays {
    Lit lit;
    float side; // of the surface, on which they travel
};

// To the light's centre; t is where it ends.
Ray nextShadowRay(Ray ray, inout ShadowRays shadows, out float t, out vec3 adds) {
#if OUTPUT == WORK
    ++work.z;
#endif
    int index = nextLight(shadows.lit, adds);
#if PRELOADS
    vec3 place = vec3(0.0); // chosen among those that have been read
    for (int i = 0; i < kLightCount; ++i)
        if (i == index) place = loadLight(i).position;
#else
    vec3 place = loadLight(index).position;
#endif
    vec3 toLight = place - ray.origin;
    float distance = length(toLight);
    t = distance - ray.tMin;
    return Ray(ray.origin, toLight / distance, ray.tMin, ray.self, shadows.side);
}

int nearestPastShadows(inout uint trail, inout Ray ray, inout Path path, inout bool ahead, inout ShadowRays shadows,
                       inout vec3 color, out float t) {
    int object = -1;
    // Wide SIMD runs a loop's body as long as a pixel is in it: the end is found at its end. Compilers for GPUs spare registers
    // where they know the number of turns; SwiftShader pays for the count at each end.
#if ITERATIONS_COUNTED
    for (int i = 0; i <= kLightCount; ++i) {
#else
    for (;;) {
#endif
        bool shadow = shadows.lit.counting != 0u;
        if (!shadow && !ahead) {
            popRay(trail, ray, path);
            ahead = true;
        }
        Ray asked = ray;
        vec3 adds = vec3(0.0);
        t = kFar;
        if (shadow) asked = nextShadowRay(ray, shadows, t, adds);
        object = nearestHit(asked, shadow, t);
        if (!shadow) break;
#if FALLBACK
        if (left) break;
#endif
        if (object < 0) color += adds;
        if (shadows.lit.counting == 0u && !ahead && !anyPending(trail)) break;
    }
    return object;
}
