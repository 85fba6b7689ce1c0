// Blinn–Phong as shaders/shade/blinn_phong.glsl has it, but a shadow ray goes to every light from every surface: where
// the light is behind it, where it has neither colour nor highlight to show, and where it hardly adds to the picture.
#if LIGHTS
#include "shade/light_fraction.glsl"
#endif

vec3 shade(Material material, vec3 point, vec3 facing, vec3 normal, Ray ray, vec3 tint) {
    vec3 color = material.own * tint;
#if LIGHTS
    vec3 albedo = material.diffuse * tint;
    for (int i = 0; i < kLightCount; ++i) {
        Light light = loadLight(i);
        vec3 direction = normalize(light.position - point);
        float cosine = dot(normal, direction);
        bool ahead = cosine > 0.0 && dot(facing, direction) > 0.0;
        float highlight = max(dot(normal, normalize(direction - ray.direction)), 0.0);
        vec3 diffuse = clamp(albedo * cosine, 0.0, 1.0);
        vec3 specular = clamp(material.specular * pow(highlight, material.shininess), 0.0, 1.0);
        float lit = lightFraction(point, facing, light);
        if (ahead) color += lit * light.color * (diffuse + specular);
    }
#endif
    return color;
}
