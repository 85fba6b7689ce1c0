// The point where a ray ends, as shading takes it: surface, material, what its images say, and the normal that they
// bend.
//
// shadingPointAt  of object `object` at t along the ray; `width` is that of the ray cone there
#include "shade/material.glsl"
#if IMAGES
#include "shade/images.glsl"
#endif
#if CHECKERS
#include "shade/checker.glsl"
#endif

struct ShadingPoint {
    Surface surface;
    Material material;
#if METALS
    Metal metal;
#endif
    vec3 facing;  // geometric normal on the ray's side
    vec3 normal;  // shading normal
    vec4 paint;   // rgb tints the surface, alpha masks its coat
    float side;   // +1 where the ray comes from outside, -1 from inside
    float cosine; // of the ray to the geometric normal, at least 1e-3
#if MEDIA
    float eta;    // index where the ray is over that behind the surface, 0: no interface; the integrator knows it
#endif
};

ShadingPoint shadingPointAt(int object, Ray ray, float t, float width) {
    ShadingPoint at;
    at.surface = surfaceAt(object, ray, t);
    at.material = loadMaterial(materialOf(object));
#if METALS
    at.metal = loadMetal(materialOf(object));
#endif
    bool outside = dot(ray.direction, at.surface.normal) <= 0.0;
    at.side = outside ? 1.0 : -1.0;
    at.facing = outside ? at.surface.normal : -at.surface.normal;
#if SMOOTH
    vec3 smoothNormal = normalize(at.surface.normal + at.surface.lean);
    at.normal = at.side * smoothNormal;
#else
    at.normal = at.facing;
#endif
    at.paint = vec4(1.0);
    at.cosine = max(-dot(ray.direction, at.facing), 1e-3);
#if IMAGES
    vec2 reach = width * inversesqrt(at.cosine) * at.surface.uvPerUnit;
#endif
#if PAINTS
    if (at.material.paint >= 0) {
        vec4 placement = at.material.paintPlacement;
        at.paint = samplePaint(at.material.paint, at.surface.uv * placement.xy + placement.zw, reach * placement.xy);
    }
#endif
#if CHECKERS
    at.paint.rgb *= checkerAt(materialOf(object), at.surface, ray.direction, at.cosine, width);
#endif
#if NORMAL_MAPS
    if (at.material.normalMap >= 0) {
        vec4 placement = at.material.normalPlacement;
        vec3 bump = sampleNormal(at.material.normalMap, at.surface.uv * placement.xy + placement.zw,
            reach * placement.xy);
#if SMOOTH
        vec3 bitangent = cross(smoothNormal, at.surface.tangent);
        at.normal = at.side * normalize(bump.x * at.surface.tangent + bump.y * bitangent + bump.z * smoothNormal);
#else
        vec3 bitangent = cross(at.surface.normal, at.surface.tangent);
        at.normal = at.side * normalize(bump.x * at.surface.tangent + bump.y * bitangent + bump.z * at.surface.normal);
#endif
    }
#endif
    return at;
}
