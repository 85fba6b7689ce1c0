// Materials as ScenePacker writes them: six texels each.
//
// optics  kPlain, kConductor (reflects), kDielectric (reflects and refracts by ior), kCoat (reflects by ior, keeps its
//         own colour), kMirror
// f0      reflectance at normal incidence, which Schlick's approximation goes out from; of a mirror at every angle
// Metal   complex refractive index n + ik of a conductor, where the Fresnel equations ask for it
// own     light of the surface itself: emitted, and reflected from all around
// paint, normalMap  layers of images, -1 where there is none
const int kPlain = 0;
const int kConductor = 1;
const int kDielectric = 2;
const int kCoat = 3;
#if MIRRORS
const int kMirror = 4;
#endif

struct Material {
    vec3 diffuse, specular, own, f0;
    float shininess, ior;
    int optics;
    int paint, normalMap;
    vec4 paintPlacement, normalPlacement; // uv = surface uv * xy + zw
};

Material loadMaterial(int index) {
    int at = kMaterialBase + index * 6;
    vec4 diffuse = sceneTexel(at);
    vec4 specular = sceneTexel(at + 1);
    vec4 own = sceneTexel(at + 2);
    vec4 f0 = sceneTexel(at + 3);
    int layers = int(f0.a);
    return Material(diffuse.rgb, specular.rgb, own.rgb, f0.rgb, diffuse.a, own.a, int(specular.a), (layers & 255) - 1,
                    (layers >> 8) - 1, sceneTexel(at + 4), sceneTexel(at + 5));
}

#if METALS
struct Metal { vec3 n, k; };

Metal loadMetal(int index) {
    int at = kMetalBase + index * 2;
    return Metal(sceneTexel(at).rgb, sceneTexel(at + 1).rgb);
}
#endif
