// Blinn–Phong: ambient + sum over lights of (diffuse N·L + specular (N·H)^shininess), each term clamped to [0, 1].
//
// toEye      unit, towards where the ray came from
// facing     geometric normal on the ray's side: light from behind it does not reach the surface, whatever a normal map says
// normal     shading normal
// tint       the texture's colour at the point: it colours its own surface only
// share      what of this surface reaches the picture: a light that adds less than the threshold needs no shadow ray
#if LIGHTS
#include "ray/bits.glsl"

// What one light adds where nothing is in its way.
vec3 reflectedLight(Light light, Material material, vec3 albedo, vec3 point, vec3 facing, vec3 normal, vec3 toEye) {
    vec3 toLight = light.position - point;
    vec3 direction = toLight * inversesqrt(max(dot(toLight, toLight), 1e-30));
    float cosine = dot(normal, direction);
    bool reached = cosine > 0.0 && dot(facing, direction) > 0.0;
    vec3 diffuse = clamp(albedo * cosine, 0.0, 1.0);
    vec3 between = direction + toEye;
    float highlight = max(dot(normal, between) * inversesqrt(max(dot(between, between), 1e-30)), 0.0);
    vec3 specular = highlight > 0.0 ? clamp(material.specular * pow(highlight, material.shininess), 0.0, 1.0) : vec3(0.0);
    return reached ? light.color * (diffuse + specular) : vec3(0.0);
}

// What all lights add to the picture where nothing is in their way. With this known what the material is holds no registers any
// more while shadow rays run. Written out light by light: what is indexed lies in memory, and SwiftShader unrolls no loop.
struct Lit {
#for Light in LIGHT_NUMBERS
    vec3 added$Light;
#endfor
    uint counting; // the lights that do, a bit each
};

Lit litBy(Material material, vec3 point, vec3 facing, vec3 normal, vec3 toEye, vec3 tint, vec3 share) {
    Lit lit;
    lit.counting = 0u;
    vec3 albedo = material.diffuse * tint;
    float least = max(frame.threshold, 1e-30);
#for Light in LIGHT_NUMBERS
    lit.added$Light = share * reflectedLight(loadLight($Light), material, albedo, point, facing, normal, toEye);
    lit.counting |= max(lit.added$Light.r, max(lit.added$Light.g, lit.added$Light.b)) >= least ? 1u << $Lightu : 0u;
#endfor
    return lit;
}

// The next light that counts, whichever that is: on wide SIMD neighbours wait for each other's shadow rays.
int nextLight(inout Lit lit, out vec3 adds) {
    int next = lowestBit(lit.counting);
    lit.counting &= lit.counting - 1u;
    adds = vec3(0.0);
#for Light in LIGHT_NUMBERS
    adds = next == $Light ? lit.added$Light : adds;
#endfor
    return next;
}
#endif
