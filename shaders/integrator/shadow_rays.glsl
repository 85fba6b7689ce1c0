// Hard shadows of the lights' centres by the tree's own search: the surface that was met last asks its lights, then the
// tree continues. One search in the shader finds what is in the way and what is nearest: there is a quarter less to
// compile, and on wide SIMD a pixel's shadow rays run beside its neighbours' next rays.
//
// The tree's ray starts where its shadow rays do, on the surface that was met last; a pending one is popped only when
// they are done. So they need no origin of their own, which would hold registers.
//
// nearestPastShadows  adds the light that arrives, then meets the next ray as nearestHit() does. `ahead` says whether
//                     the tree's ray is to be met; where it is not and none is pending, nothing is met and `ahead`
//                     stays false
#include "software/light_position.glsl"

struct ShadowRays {
    DirectLight direct;
    float side; // of the surface, on which they travel
};

// To the light's centre; t is where it ends.
Ray nextShadowRay(Ray ray, inout ShadowRays shadows, out float t, out vec3 added) {
#if OUTPUT == WORK
    ++work.z;
#endif
    int index = nextLight(shadows.direct, added);
    vec3 toLight = lightPosition(index) - ray.origin;
    float distance = length(toLight);
    t = distance - ray.tMin;
    return Ray(ray.origin, toLight / distance, ray.tMin, ray.self, shadows.side);
}

int nearestPastShadows(inout uint trail, inout Ray ray, inout Path path, inout bool ahead, inout ShadowRays shadows,
                       inout vec3 color, out float t) {
    int object = -1;
    // Wide SIMD runs a loop's body as long as a pixel is in it: the end is found at its end. Compilers for GPUs spare
    // registers where they know the number of iterations; SwiftShader pays for the count at each end.
#if ITERATIONS_COUNTED
    for (int i = 0; i <= kLightCount; ++i) {
#else
    for (;;) {
#endif
        bool shadow = shadows.direct.counting != 0u;
        if (!shadow && !ahead) {
            popRay(trail, ray, path);
            ahead = true;
        }
        Ray asked = ray;
        vec3 added = vec3(0.0);
        t = kFar;
        if (shadow) asked = nextShadowRay(ray, shadows, t, added);
        object = nearestHit(asked, shadow, t);
        if (!shadow) break;
        if (fallsBack()) break;
        if (object < 0) color += added;
        if (shadows.direct.counting == 0u && !ahead && !anyPending(trail)) break;
    }
    return object;
}
