// What a ray sees that hits nothing: a cube map far away, or one colour.
//
// spread  angle in radians that the ray cone covers: chooses the level of detail
#if CUBEMAP
uniform samplerCube sky;

vec3 skyColor(vec3 direction, float spread) {
    const float kFaceAngle = 1.5707963;
    float texels = float(textureSize(sky, 0).x) * min(spread, kFaceAngle) / kFaceAngle;
    return textureLod(sky, direction, log2(max(texels, 1.0))).rgb;
}
#else
vec3 skyColor(vec3 direction, float spread) { return frame.background.rgb; }
#endif
