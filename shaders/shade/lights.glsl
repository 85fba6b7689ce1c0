// Point lights, and how much of one reaches a surface point.
struct Light {
    vec3 position;
    vec3 color;
};

Light loadLight(int index) {
    int at = kLightBase + index * 2;
    return Light(sceneTexel(at).xyz, sceneTexel(at + 1).rgb);
}

// The ray from a surface towards a light starts outside of the body where the light stands on the normal's side.
float lightFraction(Surface surface, int self, Light light) {
#if SHADOWS
    vec3 toLight = light.position - surface.point;
    float distance = length(toLight);
    if (distance == 0.0) return 1.0;
    vec3 direction = toLight / distance;
    float side = dot(direction, surface.normal) >= 0.0 ? 1.0 : -1.0;
    Ray ray = rayFrom(surface.point, direction, self, side);
    return visibility(ray, distance - ray.tMin);
#else
    return 1.0;
#endif
}
