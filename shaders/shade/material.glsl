// Materials as packScene() writes them: eight texels each.
//
// optics  kPlain, kConductor (reflects by f0), kDielectric (reflects and refracts by ior), kCoat (reflects by f0, keeps its
//         own colour); f0 is the reflectance at normal incidence
// slots   of images: -1 where there is none
const int kPlain = 0;
const int kConductor = 1;
const int kDielectric = 2;
const int kCoat = 3;

struct Material {
    vec3 ambient, diffuse, specular, emission, f0;
    float shininess, ior;
    int optics;
    int texture, normalMap, mask;
    vec4 texturePlacement, normalPlacement; // uv = surface uv * xy + zw
};

Material loadMaterial(int index) {
    int at = kMaterialBase + index * 8;
    vec4 ambient = sceneTexel(at);
    vec4 diffuse = sceneTexel(at + 1);
    vec4 specular = sceneTexel(at + 2);
    vec4 emission = sceneTexel(at + 3);
    vec4 f0 = sceneTexel(at + 4);
    return Material(ambient.rgb, diffuse.rgb, specular.rgb, emission.rgb, f0.rgb, ambient.a, diffuse.a, int(specular.a),
                    int(emission.a), int(f0.a), int(sceneTexel(at + 7).x), sceneTexel(at + 5), sceneTexel(at + 6));
}
