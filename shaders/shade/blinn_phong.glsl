// Blinn–Phong: diffuse N·L + specular (N·H)^shininess, each term clamped to [0, 1].
//
// reflectedLight  of one light with nothing in its way. Light from behind the geometric normal does not reach the
//                 surface, whatever a normal map says
// albedo          diffuse colour, tinted by the surface's image
// toEye           unit, towards where the ray came from
// Source          J. Blinn, Models of Light Reflection for Computer Synthesized Pictures, 1977
vec3 reflectedLight(Light light, ShadingPoint at, vec3 albedo, vec3 toEye) {
    vec3 toLight = light.position - at.surface.point;
    vec3 direction = toLight * inversesqrt(max(dot(toLight, toLight), 1e-30));
    float cosine = dot(at.normal, direction);
    bool reached = cosine > 0.0 && dot(at.facing, direction) > 0.0;
    vec3 diffuse = clamp(albedo * cosine, 0.0, 1.0);
    vec3 between = direction + toEye;
    float highlight = max(dot(at.normal, between) * inversesqrt(max(dot(between, between), 1e-30)), 0.0);
    float power = pow(highlight, at.material.shininess);
    vec3 specular = highlight > 0.0 ? clamp(at.material.specular * power, 0.0, 1.0) : vec3(0.0);
#if LIGHT_PROFILES
    light.color *= lightProfile(light, toLight);
#endif
    return reached ? light.color * (diffuse + specular) : vec3(0.0);
}
