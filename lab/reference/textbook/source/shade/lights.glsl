// Point lights as shaders/shade/lights.glsl has them.
struct Light {
    vec3 position;
    vec3 color;
};

Light loadLight(int index) {
    int at = kLightBase + index * 2;
    return Light(sceneTexel(at).xyz, sceneTexel(at + 1).rgb);
}
