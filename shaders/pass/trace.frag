// One pixel of the linear picture: the primary ray through its centre, and the output that the settings ask for, as
// numbers: pass/resolve.frag makes them visible, or what is read back.
#include "frame.glsl"
#include "scene.glsl"
#include "ray/ray.glsl"
#include "ray/split.glsl"
#if OUTPUT == STEPS
#include "sdf/count.glsl"
#endif
#include "ray/primary.glsl"
#include "pass/linear_output.glsl"
#include "software/coverage_mask.glsl"
#include "ray/nearest.glsl"
#include "software/hooks.glsl"
#if OUTPUT == COLOR || OUTPUT == WORK || OUTPUT == STEPS
#include "integrator/whitted.glsl"
#elif OUTPUT == VISIBILITY
#if LIGHTS
#include "shade/lights.glsl"
#include "shade/light_fraction.glsl"
#endif
#endif

#if OUTPUT == COLOR
vec4 pixel(Ray ray) { return vec4(radiance(ray), 1.0); }
#elif OUTPUT == WORK || OUTPUT == STEPS
// Boxes, objects and shadow rays that the colour of this pixel takes, or evaluations of distances.
vec4 pixel(Ray ray) {
    vec3 color = radiance(ray);
#if OUTPUT == WORK
    vec3 counts = vec3(work);
#else
    vec3 counts = vec3(float(evaluations));
#endif
    if (color.r < -1.0) counts.r = 0.0; // the colour is asked for, too: nothing of the work may be left out
    return vec4(counts, 1.0);
}
#else
// What the primary ray meets; alpha 0 where that is nothing.
vec4 pixel(Ray ray) {
    float t;
    int object = nearestHit(ray, t);
#if OUTPUT == DISTANCE
    float value = object < 0 ? uintBitsToFloat(0x7F800000u) : t; // infinity where nothing is hit
    return vec4(vec3(value), 1.0);
#elif OUTPUT == OBJECT
    return vec4(vec3(object < 0 ? -1 : fileIndexOf(object)), 1.0);
#else
    if (object < 0) {
#if OUTPUT == VISIBILITY
        return vec4(1.0);
#else
        return vec4(0.0);
#endif
    }
    Surface surface = surfaceAt(object, ray, t);
#if OUTPUT == POSITION
    return vec4(surface.point, 1.0); // relative to frame.origin
#elif OUTPUT == NORMAL
    return vec4(dot(surface.normal, ray.direction) <= 0.0 ? surface.normal : -surface.normal, 1.0);
#else
    float fraction = 1.0;
#if LIGHTS && SHADOWS
    Light light = loadLight(clamp(frame.light, 0, kLightCount - 1));
    float behind = dot(light.position - surface.point, surface.normal) * dot(ray.direction, surface.normal);
    // Lit from behind, the surface itself is in the way.
    fraction = behind > 0.0 ? 0.0 : lightFraction(surface, object, light, frame.pixelAngle * t);
#endif
    return vec4(vec3(fraction), 1.0);
#endif
#endif
}
#endif

void main() {
    beforePixel();
    store(afterPixel(pixel(primaryRay())));
    markCovered();
}
