// Lights.
//
// radius  of the sphere that shines; 0: a point
struct Light {
    vec3 position;
    float radius;
    vec3 color;
};

Light loadLight(int index) {
    int at = kLightBase + index * 2;
    vec4 sphere = sceneTexel(at);
    return Light(sphere.xyz, frame.lightRadius < 0.0 ? sphere.w : frame.lightRadius, sceneTexel(at + 1).rgb);
}
