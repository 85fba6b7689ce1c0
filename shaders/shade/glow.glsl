// Light around a point that lies in the way of a ray: color * clamp(strength / (softness + d²), 0, 1), where d is the
// distance of the centre from the ray's line, or from its end where something stops it before: a solid in front of the
// sun is not glazed by the glow behind it.
vec3 glowAlong(Ray ray, float t) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kGlowCount; ++i) {
        vec4 center = sceneTexel(kGlowBase + i * 2);
        vec4 color = sceneTexel(kGlowBase + i * 2 + 1);
        vec3 toCenter = center.xyz - ray.origin;
        float nearest = clamp(dot(toCenter, ray.direction), 0.0, t);
        vec3 gap = toCenter - nearest * ray.direction;
        sum += color.rgb * clamp(center.w / (color.a + dot(gap, gap)), 0.0, 1.0);
    }
    return sum;
}
