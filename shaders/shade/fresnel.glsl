// Reflectance over the angle: Schlick's approximation, F = f0 + (1 - f0)(1 - cos)^5, per channel.
//
// Error   below 0.03 of the exact Fresnel equations for dielectrics of index <= 1.5
// Source  C. Schlick, An Inexpensive BRDF Model for Physically-based Rendering, 1994
vec3 fresnel(vec3 f0, float cosine) {
    float grazing = 1.0 - clamp(cosine, 0.0, 1.0);
    float square = grazing * grazing;
    return f0 + (1.0 - f0) * (square * square * grazing);
}
