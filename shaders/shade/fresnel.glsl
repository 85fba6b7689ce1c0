// Reflectance over the angle: Schlick's approximation, F = f0 + (1 - f0)(1 - cos)^5, per channel.
//
// Error   at most, against the Fresnel equations of a dielectric: 0.317 of index 1.05, 0.113 of 1.2, 0.059 of 1.333,
//         0.036 of 1.5, 0.201 of 4
// Source  C. Schlick, An Inexpensive BRDF Model for Physically-based Rendering, 1994
vec3 fresnel(vec3 f0, float cosine) {
    float grazing = 1.0 - clamp(cosine, 0.0, 1.0);
    float square = grazing * grazing;
    return f0 + (1.0 - f0) * (square * square * grazing);
}
