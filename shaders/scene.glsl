// The scene's numbers: sceneTexel(i) is the i-th vec4 that packScene() in tracer/render/scene_data.cpp wrote.
//
// Where the scene fits, they lie in a uniform block, else in a float texture 256 texels wide. Offsets are the constants
// kSphereBase, kMaterialBase, … at the top of the specialised shader.
#if DATA_BLOCK
layout(std140) uniform SceneBlock { vec4 texels[kSceneTexels]; } scene;

vec4 sceneTexel(int index) { return scene.texels[index]; }
#else
uniform sampler2D sceneData;

vec4 sceneTexel(int index) { return texelFetch(sceneData, ivec2(index & 255, index >> 8), 0); }
#endif
