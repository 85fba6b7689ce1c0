// Reflectance of unpolarised light over the angle: by the Fresnel equations, or by Schlick's approximation of them
// where the scene says so.
//
// fresnelDielectric  of a smooth surface between two clear media: cosine to the normal and refractive index on the
//                    ray's side, index beyond. Total reflection comes out as 1
// fresnelConductor   of a metal, per channel: n and k over the index on the ray's side
// fresnel            Schlick: F = f0 + (1 - f0)(1 - cos)^5, per channel, the cosine that of the thinner side
// Error   exact forms: as of a cosine that is off by at most 4 ulp, and 1e-6 beside that, at cos -> 0, at index -> 1
//         and at total reflection, too (tests/shader/fresnel_test.cpp; measured 2 ulp and 6e-7).
//         Schlick, at most, of a dielectric from its thinner side: 0.317 of index 1.05, 0.113 of 1.2, 0.059 of 1.333,
//         0.036 of 1.5, 0.201 of 4
// Source  A. Fresnel's equations with what cancels in them worked out: by Snell's law the difference of two terms
//         n cos of like size is that of the squared indices over their sum, and p = s cos(a + b) / cos(a - b).
//         Conductors: n' and k' of M. Born and E. Wolf, Principles of Optics, 14.2, the smaller from n k and the
//         larger, all else sums of squares. C. Schlick, An Inexpensive BRDF Model for Physically-based Rendering, 1994
// Limits  indices of dielectrics > 0; n, k >= 0. No surface, index 1, reflects nothing at every angle
#if EXACT_FRESNEL
#if COATS || REFRACTION
float fresnelDielectric(float cosine, float index, float beyond) {
    float c = min(cosine, 1.0);
    float difference = (beyond - index) * (beyond + index);
    float a = index * c;
    float b = sqrt(max(a * a + difference, 0.0)); // beyond, n cos; 0 where nothing gets through
    float tangential = index * index * ((1.0 - c) * (1.0 + c));
    float s = min(abs(difference) / max((a + b) * (a + b), 1e-30), 1.0);
    float p = (a * b - tangential) / max(a * b + tangential, 1e-30); // over s
    return min(0.5 * s * s * (1.0 + p * p), 1.0);
}
#endif

#if METALS
vec3 fresnelConductor(float cosine, vec3 n, vec3 k) {
    float c = min(cosine, 1.0);
    float sine2 = (1.0 - c) * (1.0 + c);
    vec3 nk = n * k;
    // Of the squared index beyond times its cosine's square, by what does not cancel there.
    vec3 real = mix(n * n - sine2, (n - 1.0) * (n + 1.0) + c * c, step(0.5, n)) - k * k;
    vec3 larger = sqrt(0.5 * (sqrt(real * real + 4.0 * nk * nk) + abs(real)));
    vec3 smaller = nk / max(larger, 1e-20);
    vec3 positive = step(0.0, real);
    vec3 a = mix(smaller, larger, positive);
    vec3 b = mix(larger, smaller, positive);
    vec3 across = ((a - c) * (a - c) + b * b) / max((a + c) * (a + c) + b * b, 1e-30);
    vec3 less = a * c - sine2;
    vec3 more = a * c + sine2;
    vec3 along = (less * less + b * b * c * c + 1e-30) / (more * more + b * b * c * c + 1e-30); // over `across`
    return min(0.5 * across * (1.0 + along), 1.0);
}
#endif
#else
vec3 fresnel(vec3 f0, float cosine) {
    float grazing = 1.0 - clamp(cosine, 0.0, 1.0);
    float square = grazing * grazing;
    return f0 + (1.0 - f0) * (square * square * grazing);
}
#endif
