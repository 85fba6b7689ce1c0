// What a ray sees that hits nothing: a cube map far away, an image all around, a gradient, or one colour.
//
// spread  angle in radians that the ray cone covers: chooses the level of detail
#if CUBEMAP
uniform samplerCube sky;

vec3 skyColor(vec3 direction, float spread) {
    const float kFaceAngle = 1.5707963;
    float texels = float(textureSize(sky, 0).x) * min(spread, kFaceAngle) / kFaceAngle;
    return textureLod(sky, direction, log2(max(texels, 1.0))).rgb;
}
#elif PANORAMA
// Columns are longitude, the middle one towards -z, +x on its right; rows are latitude, the first straight up.
uniform sampler2D panorama;

// atan(v.y, v.x), 0 of nothing. SwiftShader's own is off by pi for some angles of about half a circle.
float bearing(vec2 v) {
    const float kPi = 3.14159265;
    float fromAxis = 2.0 * atan(v.y / max(length(v) + abs(v.x), 1e-30));
    return v.x >= 0.0 ? fromAxis : (v.y >= 0.0 ? kPi : -kPi) - fromAxis;
}

// A row shortens towards the poles: there the cone covers more of its columns than of the rows, and takes samples
// beside one another instead of a level that would mix in rows it does not see.
vec3 skyColor(vec3 direction, float spread) {
    const float kPi = 3.14159265;
    const int kMostSamples = 8;
    float equator = length(direction.xz);
    vec2 uv = vec2(0.5 + bearing(vec2(-direction.z, direction.x)) / (2.0 * kPi),
        bearing(vec2(direction.y, equator)) / kPi);
    vec2 size = vec2(textureSize(panorama, 0));
    float rows = max(size.y * min(spread / kPi, 1.0), 1.0);
    float turn = min(spread / (2.0 * kPi * max(equator, 1e-6)), 1.0);
    int samples = int(clamp(ceil(size.x * turn / rows), 1.0, float(kMostSamples)));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kMostSamples; ++i) {
        if (i >= samples) break;
        float beside = turn * ((float(i) + 0.5) / float(samples) - 0.5);
        sum += textureLod(panorama, uv + vec2(beside, 0.0), log2(rows)).rgb;
    }
    return sum / float(samples);
}
#elif GRADIENT
vec3 skyColor(vec3 direction, float spread) {
    vec3 bottom = sceneTexel(kGradientBase).rgb;
    vec3 top = sceneTexel(kGradientBase + 1).rgb;
    return mix(bottom, top, 0.5 + 0.5 * direction.y);
}
#else
vec3 skyColor(vec3 direction, float spread) { return frame.background.rgb; }
#endif
