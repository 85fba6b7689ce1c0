// Lights. A directional one stands 1e12 units away: for shadow models it is a point (those that take it say so in
// tracer/settings/shadow_models.h).
//
// radius        of the sphere that shines; 0: a point
// falloff       square of the distance at which the light is as strong as its colour; 0: it is so at every distance
// cone          {v, w}: dot(v, direction in which the light leaves) + w is 0 where a spot ends, 1 where it is full
// lightProfile  how strong the light is towards a point whose way to it is `toLight`: the square of a distance, of at
//               least a thousandth of the falloff's, and a smooth step over a spot's edge
struct Light {
    vec3 position;
    float radius;
    vec3 color;
#if LIGHT_PROFILES
    float falloff;
    vec4 cone;
#endif
};

Light loadLight(int index) {
    int at = kLightBase + index * 2;
    vec4 sphere = sceneTexel(at);
#if LIGHT_PROFILES
    vec4 color = sceneTexel(at + 1);
    float radius = frame.lightRadius < 0.0 ? sphere.w : frame.lightRadius;
    return Light(sphere.xyz, radius, color.rgb, color.a, sceneTexel(kProfileBase + index));
#else
    return Light(sphere.xyz, frame.lightRadius < 0.0 ? sphere.w : frame.lightRadius, sceneTexel(at + 1).rgb);
#endif
}

#if LIGHT_PROFILES
float lightProfile(Light light, vec3 toLight) {
    float square = max(dot(toLight, toLight), 1e-30);
    float within = clamp(light.cone.w - dot(light.cone.xyz, toLight) * inversesqrt(square), 0.0, 1.0);
    float distant = light.falloff > 0.0 ? light.falloff / max(square, 1e-6 * light.falloff) : 1.0;
    return distant * within * within * (3.0 - 2.0 * within);
}
#endif
