// Hard shadows of the lights' centres by the tree's own search: the surface that was met last asks its lights, then the tree goes
// on. One search in the shader finds what is in the way and what is nearest: there is a quarter less to compile, and on wide SIMD
// a pixel's shadow rays run beside its neighbours' next rays.
//
// nearestPastShadows  adds the light that arrives, then meets the next ray where there is one (`ahead`) as nearestHit() does
struct ShadowRays {
    Lit lit;
    vec3 point;
    int self;
    float side;
};

// To the light's centre; t is where it ends.
Ray nextShadowRay(inout ShadowRays shadows, out float t, out vec3 adds) {
#if OUTPUT == WORK
    ++work.z;
#endif
    Light light = loadLight(nextLight(shadows.lit, adds));
    vec3 toLight = light.position - shadows.point;
    float distance = length(toLight);
    Ray ray = rayFrom(shadows.point, toLight / distance, shadows.self, shadows.side);
    t = distance - ray.tMin;
    return ray;
}

int nearestPastShadows(Ray ray, bool ahead, inout ShadowRays shadows, inout vec3 color, out float t) {
    int object = -1;
    // Wide SIMD runs a loop's body as long as a pixel is in it: the end is found at its end.
    for (int i = 0; i <= kLightCount; ++i) {
        bool shadow = shadows.lit.counting != 0u;
        Ray asked = ray;
        vec3 adds = vec3(0.0);
        t = kFar;
        if (shadow) asked = nextShadowRay(shadows, t, adds);
        object = nearestHit(asked, shadow, t);
        if (!shadow) break;
        if (object < 0) color += adds;
        if (shadows.lit.counting == 0u && !ahead) break;
    }
    return object;
}
