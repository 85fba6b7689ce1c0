// Blinn–Phong: ambient + sum over lights of (diffuse N·L + specular (N·H)^shininess), each term clamped to [0, 1].
//
// toEye      unit, towards where the ray came from
// facing     geometric normal on the ray's side: light from behind it does not reach the surface, whatever a normal map says
// normal     shading normal
// tint       the texture's colour at the point: it colours its own surface only
// width      of what a pixel covers of the surface
// share      what of this surface reaches the picture: a light that adds less than the threshold needs no shadow ray
#if LIGHTS
#include "ray/bits.glsl"

// What one light adds where nothing is in its way.
vec3 reflectedLight(Light light, Material material, vec3 albedo, vec3 point, vec3 facing, vec3 normal, vec3 toEye) {
    vec3 toLight = light.position - point;
    vec3 direction = toLight * inversesqrt(max(dot(toLight, toLight), 1e-30));
    float cosine = dot(normal, direction);
    if (cosine <= 0.0 || dot(facing, direction) <= 0.0) return vec3(0.0);
    vec3 diffuse = clamp(albedo * cosine, 0.0, 1.0);
    vec3 between = direction + toEye;
    float highlight = max(dot(normal, between) * inversesqrt(max(dot(between, between), 1e-30)), 0.0);
    vec3 specular = highlight > 0.0 ? clamp(material.specular * pow(highlight, material.shininess), 0.0, 1.0) : vec3(0.0);
    return light.color * (diffuse + specular);
}
#endif

vec3 shade(Material material, Surface surface, int self, vec3 facing, vec3 normal, vec3 toEye, vec3 tint, vec3 share, float width) {
    vec3 color = material.own * tint;
#if LIGHTS
    vec3 albedo = material.diffuse * tint;
    vec3 added[kLightCount];
    uint counting = 0u; // the lights that do, a bit each
    for (int i = 0; i < kLightCount; ++i) {
        added[i] = reflectedLight(loadLight(i), material, albedo, surface.point, facing, normal, toEye);
        vec3 seen = added[i] * share;
        if (max(seen.r, max(seen.g, seen.b)) >= max(frame.options.x, 1e-30)) counting |= 1u << uint(i);
    }
    // What the material is holds no registers any more while shadow rays run. On wide SIMD neighbours wait for each other's
    // rays, so each round takes the next light that counts, whichever that is.
    while (counting != 0u) {
        int next = lowestBit(counting);
        counting &= counting - 1u;
        float fraction = lightFraction(surface, self, loadLight(next), width);
        for (int i = 0; i < kLightCount; ++i)
            if (i == next) color += added[i] * fraction;
    }
#endif
    return color;
}
