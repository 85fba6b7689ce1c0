// The scene's numbers: sceneTexel(i) is the i-th vec4 that packScene() in tracer/render/scene_data.cpp wrote.
//
// On a GPU where the scene fits they lie in a uniform block, else in a float texture 256 texels wide. Offsets are the
// constants kSphereBase, kMaterialBase, … at the top of the specialised shader. The texture has one level and no filter, and a
// texel's centre is its place to 2^-9 of a texel; texelFetch has llvmpipe work out the size of the level for each lane anew
// (63 instructions instead of 151).
#if DATA_BLOCK
layout(std140) uniform SceneBlock { vec4 texels[kSceneTexels]; } scene;

vec4 sceneTexel(int index) { return scene.texels[index]; }
#else
uniform sampler2D sceneData;

vec4 sceneTexel(int index) {
    const vec2 kPerTexel = 1.0 / vec2(256.0, float((kSceneTexels + 255) / 256));
    return textureLod(sceneData, (vec2(index & 255, index >> 8) + 0.5) * kPerTexel, 0.0);
}
#endif
