// What a surface makes of a ray that meets it: the reflected and the refracted ray, each with its throughput and its
// ray cone.
//
// scatterAt         the fractions of what arrives; none is refracted where the material is no dielectric or reflects
//                   totally
// reflectedPath, reflectedDirection    of the ray that is mirrored on the shading normal, or on the geometric one where
//                                      that would lead into the surface
// refractedPath, refractedDirection    of the ray that Snell's law bends
// Source            T. Whitted, An Improved Illumination Model for Shaded Display, 1980
#include "ray/path.glsl"
#include "shade/fresnel.glsl"

struct Scatter {
    vec3 reflected;    // of what arrives
    float facingRatio; // cosine of the ray to the shading normal
#if REFRACTION
    float eta;         // index of refraction where the ray comes from, over that beyond
    float beyond;      // squared cosine of the refracted ray; negative where there is none
#endif
};

#if EXACT_FRESNEL
// Of a clear layer, seen from without whichever side the ray comes from, of a dielectric or of a conductor.
vec3 reflectanceOf(ShadingPoint at, float cosine) {
    vec3 reflectance = vec3(0.0);
#if MEDIA
    float around = mediumOf(inside).w; // index of what the ray is in
#endif
#if COATS || REFRACTION
    vec2 indices = vec2(1.0, at.material.ior); // on the ray's side, beyond
#if MEDIA
    indices.x = around;
    indices = at.material.optics == kDielectric ? vec2(at.eta, 1.0) : indices; // their ratio is all that counts
#elif REFRACTION
    indices = at.material.optics == kDielectric && at.side < 0.0 ? indices.yx : indices;
#endif
    reflectance = vec3(fresnelDielectric(cosine, indices.x, indices.y));
#endif
#if METALS
#if MEDIA
    vec3 metal = fresnelConductor(cosine, at.metal.n / around, at.metal.k / around);
#else
    vec3 metal = fresnelConductor(cosine, at.metal.n, at.metal.k);
#endif
    reflectance = at.material.optics == kConductor ? metal : reflectance;
#endif
    return reflectance;
}
#endif

Scatter scatterAt(ShadingPoint at, vec3 incoming) {
    Scatter scatter;
    scatter.facingRatio = max(-dot(incoming, at.normal), 0.0);
    float cosine = scatter.facingRatio;
    float coat = at.paint.a;
#if REFRACTION
    bool dielectric = at.material.optics == kDielectric;
#if MEDIA
    scatter.eta = at.eta;
#else
    scatter.eta = at.side > 0.0 ? 1.0 / at.material.ior : at.material.ior;
#endif
    float squared = 1.0 - scatter.eta * scatter.eta * (1.0 - cosine * cosine);
    scatter.beyond = dielectric ? squared : -1.0;
    bool leaving = scatter.beyond >= 0.0 && at.side < 0.0; // Schlick's formula wants the angle on the thinner side
#if MEDIA && !EXACT_FRESNEL
    bool thinner = scatter.beyond >= 0.0 && scatter.eta > 1.0;
    cosine = thinner ? sqrt(scatter.beyond) : cosine;
#elif !EXACT_FRESNEL
    cosine = leaving ? sqrt(scatter.beyond) : cosine;
#endif
    coat = leaving ? 1.0 : coat;
#endif
#if EXACT_FRESNEL
    scatter.reflected = reflectanceOf(at, cosine) * coat;
#else
#if MEDIA
    float atNormal = (scatter.eta - 1.0) / (scatter.eta + 1.0);
    if (dielectric) at.material.f0 = vec3(atNormal * atNormal);
#endif
    scatter.reflected = fresnel(at.material.f0, cosine) * coat;
#endif
#if MIRRORS
    scatter.reflected = at.material.optics == kMirror ? at.material.f0 : scatter.reflected;
#endif
#if REFRACTION
    scatter.reflected = dielectric && scatter.beyond < 0.0 ? vec3(1.0) : scatter.reflected;
#endif
    return scatter;
}

Path reflectedPath(Path path, ShadingPoint at, Scatter scatter) {
    float bend = 2.0 * path.width * at.surface.curvature / at.cosine;
    return Path(path.throughput * scatter.reflected, path.depth + 1, path.width, path.spread + bend);
}

vec3 reflectedDirection(ShadingPoint at, vec3 incoming) {
    vec3 reflected = reflect(incoming, at.normal);
    return normalize(dot(reflected, at.facing) > 0.0 ? reflected : reflect(incoming, at.facing));
}

#if REFRACTION
Path refractedPath(Path path, ShadingPoint at, Scatter scatter) {
    float lens = abs(1.0 - scatter.eta) * path.width * at.surface.curvature / at.cosine;
    vec3 throughput = path.throughput * (1.0 - scatter.reflected);
    return Path(throughput, path.depth + 1, path.width, path.spread * scatter.eta + lens);
}

vec3 refractedDirection(ShadingPoint at, Scatter scatter, vec3 incoming) {
    return normalize(scatter.eta * incoming + (scatter.eta * scatter.facingRatio - sqrt(scatter.beyond)) * at.normal);
}
#endif
