// One pixel: the primary ray through its centre, and the output the settings ask for.
//
// Outputs are written as they are for reading back, or made visible for a window where frame.encode is 1.
#include "frame.glsl"
#include "scene.glsl"
#include "ray/ray.glsl"
#include "ray/split.glsl"
#if OUTPUT == STEPS
#include "sdf/count.glsl"
#endif
#include "ray/primary.glsl"
#include "ray/nearest.glsl"
#if PRELOADS
#include "software/preloads.glsl"
#elif CACHED_LOADS
#include "software/cached_loads.glsl"
#endif
#if OUTPUT == COLOR || OUTPUT == WORK || OUTPUT == STEPS
#if IMAGES
#include "shade/images.glsl"
#endif
#include "shade/material.glsl"
#include "shade/sky.glsl"
#if GLOWS
#include "shade/glow.glsl"
#endif
#if REFLECTION
#include "shade/fresnel.glsl"
#endif
#if LIGHTS
#include "shade/lights.glsl"
#endif
#include "shade/blinn_phong.glsl"
#include "shade/encode.glsl"
#include "ray/tree.glsl"
#elif OUTPUT == VISIBILITY
#if LIGHTS
#include "shade/lights.glsl"
#include "shade/light_fraction.glsl"
#endif
#endif

out vec4 outColor;

#if OUTPUT == COLOR
vec4 pixel(Ray ray) {
    vec3 color = chooseChannels(traceTree(ray));
    return vec4(frame.encode == 1 ? encode(color) : color, 1.0);
}
#elif OUTPUT == WORK
// Boxes, objects and shadow rays that the colour of this pixel takes; shown against 256, 64 and 16 of them.
vec4 pixel(Ray ray) {
    vec3 color = traceTree(ray);
    vec3 counts = vec3(work);
    if (color.r < -1.0) counts.r = 0.0; // the colour is asked for, too: nothing of the work may be left out
    return vec4(frame.encode == 1 ? counts / vec3(256.0, 64.0, 16.0) : counts, 1.0);
}
#elif OUTPUT == STEPS
// Evaluations of distances that the colour of this pixel takes; shown against 256 of them.
vec4 pixel(Ray ray) {
    vec3 color = traceTree(ray);
    vec3 count = vec3(float(evaluations));
    if (color.r < -1.0) count.r = 0.0; // the colour is asked for, too: nothing of the work may be left out
    return vec4(frame.encode == 1 ? count / 256.0 : count, 1.0);
}
#else
// What the primary ray meets. `value` for reading back, `shown` for a window.
vec4 pixel(Ray ray) {
    float t;
    int object = nearestHit(ray, t);
    bool shown = frame.encode == 1;
#if OUTPUT == DISTANCE
    float value = object < 0 ? uintBitsToFloat(0x7F800000u) : t; // infinity where nothing is hit
    return vec4(shown ? vec3(object < 0 ? 0.0 : 1.0 / (1.0 + 0.05 * t)) : vec3(value), 1.0);
#elif OUTPUT == OBJECT
    int index = object < 0 ? -1 : fileIndexOf(object);
    vec3 shade = fract(vec3(0.61803399, 0.75487767, 0.56984029) * float(index + 1));
    return vec4(shown ? (object < 0 ? vec3(0.0) : 0.25 + 0.75 * shade) : vec3(index), 1.0);
#else
    if (object < 0) {
#if OUTPUT == VISIBILITY
        return vec4(1.0);
#else
        return vec4(0.0, 0.0, 0.0, 1.0);
#endif
    }
    Surface surface = surfaceAt(object, ray, t);
#if OUTPUT == POSITION
    // The origin's own fraction, since the sum has no more digits than its place in the world leaves.
    return vec4(shown ? fract(fract(frame.origin.xyz) + surface.point) : frame.origin.xyz + surface.point, 1.0);
#elif OUTPUT == NORMAL
    vec3 normal = dot(surface.normal, ray.direction) <= 0.0 ? surface.normal : -surface.normal;
    return vec4(shown ? 0.5 + 0.5 * normal : normal, 1.0);
#else
    float fraction = 1.0;
#if LIGHTS && SHADOWS
    Light light = loadLight(clamp(frame.light, 0, kLightCount - 1));
    float behind = dot(light.position - surface.point, surface.normal) * dot(ray.direction, surface.normal);
    fraction = behind > 0.0 ? 0.0 : lightFraction(surface, object, light, frame.pixelAngle * t); // lit from behind: the surface itself is in the way
#endif
    return vec4(vec3(fraction), 1.0);
#endif
#endif
}
#endif

void main() {
#if CACHED_LOADS
    cacheLoads();
#endif
#if PRELOADS
    vec4 ahead = preload();
    vec4 color = pixel(primaryRay());
    outColor = frame.zero.x == 0u ? color : ahead;
#else
    outColor = pixel(primaryRay());
#endif
#if FALLBACK
    if (left) discard;
#endif
}
