// The scene's numbers: sceneTexel(i) is the i-th vec4 that packScene() in tracer/plan/scene_packer.cpp wrote.
//
// On a GPU where the scene fits they lie in a uniform block, else in a float texture 2048 texels wide. Offsets are the
// constants kSphereBase, kMaterialBase, … at the top of the specialised shader. The texture has one level and no
// filter, and a texel's centre is its position to 2^-9 of a texel; texelFetch has llvmpipe work out the size of the
// level for each lane anew (63 instructions instead of 151).
#if DATA_BLOCK
layout(std140) uniform SceneBlock { vec4 texels[kSceneTexels]; } scene;

vec4 sceneTexel(int index) { return scene.texels[index]; }
#else
uniform sampler2D sceneData;

vec4 sceneTexel(int index) {
    const int kRows = (kSceneTexels + 2047) / 2048;
    int column = kRows == 1 ? index : index & 2047;
    float row = kRows == 1 ? 0.5 : (float(index >> 11) + 0.5) / float(kRows);
    return textureLod(sceneData, vec2((float(column) + 0.5) / 2048.0, row), 0.0);
}
#endif
