// Whether a light is seen; shadow rays start a fixed step off the surface, at every scale.
#if SHADOWS
#include "shadow/hard.glsl"
#endif

float lightFraction(vec3 point, vec3 normal, Light light) {
#if SHADOWS
    vec3 start = point + 1e-3 * normal;
    vec3 toLight = light.position - start;
    return visibility(rayFrom(start, normalize(toLight), -1, 0.0), length(toLight));
#else
    return 1.0;
#endif
}

float lightFraction(Surface surface, int self, Light light, float width) {
    bool front = dot(light.position - surface.point, surface.normal) >= 0.0;
    return lightFraction(surface.point, front ? surface.normal : -surface.normal, light);
}
