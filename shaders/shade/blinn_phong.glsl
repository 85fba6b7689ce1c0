// Blinn–Phong: ambient + sum over lights of (diffuse N·L + specular (N·H)^shininess), each term clamped to [0, 1].
//
// toEye      unit, towards where the ray came from
// facing     geometric normal on the ray's side: light from behind it does not reach the surface, whatever a normal map says
// normal     shading normal
// tint       the texture's colour at the point: it colours its own surface only
// share      what of this surface reaches the picture: a light that adds less than the threshold needs no shadow ray
vec3 shade(Material material, Surface surface, int self, vec3 facing, vec3 normal, vec3 toEye, vec3 tint, vec3 share) {
    vec3 color = (material.emission + material.ambient) * tint;
#if LIGHTS
    if (all(equal(material.diffuse + material.specular, vec3(0.0)))) return color;
    vec3 albedo = material.diffuse * tint;
    for (int i = 0; i < kLightCount; ++i) {
        Light light = loadLight(i);
        vec3 toLight = light.position - surface.point;
        vec3 direction = toLight * inversesqrt(max(dot(toLight, toLight), 1e-30));
        float cosine = dot(normal, direction);
        if (cosine <= 0.0 || dot(facing, direction) <= 0.0) continue;
        vec3 diffuse = clamp(albedo * cosine, 0.0, 1.0);
        vec3 between = direction + toEye;
        float highlight = max(dot(normal, between) * inversesqrt(max(dot(between, between), 1e-30)), 0.0);
        vec3 specular = highlight > 0.0 ? clamp(material.specular * pow(highlight, material.shininess), 0.0, 1.0) : vec3(0.0);
        vec3 light3 = light.color * (diffuse + specular);
        vec3 seen = light3 * share;
        if (max(seen.r, max(seen.g, seen.b)) < frame.options.x) continue;
        color += light3 * lightFraction(surface, self, light);
    }
#endif
    return color;
}
