// Whitted's ray tree as the source document walked it: a loop with a stack of structs, on which the refracted ray waits
// while the loop continues with the reflected one. The baseline that shaders/integrator/whitted.glsl is measured
// against.
//
// Stack   eight entries at every depth. Written before the count grows: stack[n++].ray = r loses data on Mesa 22.3
// Waste   no ray is left out for the little that it adds, and every surface is shaded, the sky's planes and the sun as
//         well. Texture coordinates are worked out once a ray, as in the document; point and normal at every closer hit
// Limits  of light inside of glass only what leaves it is followed, unless reflection is total. Images show the detail
//         that neighbouring pixels ask for, whatever those see: there are no ray cones.
//         The document asked its torus by secondary rays only; here every ray asks it, as all else
#if IMAGES
#include "shade/images.glsl"
#endif
#include "shade/material.glsl"
#include "shade/sky.glsl"
#if GLOWS
#include "shade/glow.glsl"
#endif
#if REFLECTION
#include "shade/fresnel.glsl"
#endif
#if LIGHTS
#include "shade/lights.glsl"
#endif
#include "shade/blinn_phong.glsl"

const int kStackSize = 8;
const float kEpsilon = 1e-3; // how far off a surface rays start, at every scale

struct StackEntry {
    vec3 origin;
    vec3 direction;
    vec3 throughput;
    int depth;
};

// What a material's images say of a point.
struct Coating {
    vec3 tint;
    vec3 bump; // the shading normal beside tangent, bitangent and normal
    float mask;
};

#if IMAGES
// Every image is sampled in one place, by tests for whether the material has it.
Coating coatingAt(Material material, vec2 uv) {
    Coating coating = Coating(vec3(1.0), vec3(0.0, 0.0, 1.0), 1.0);
    vec2 at = uv * material.paintPlacement.xy + material.paintPlacement.zw;
    vec2 normalAt = uv * material.normalPlacement.xy + material.normalPlacement.zw;
#for Layer in PAINT_LAYERS
    if (material.paint == $Layer) {
        vec4 texel = texture(paints, vec3(at, $Layer.0));
        coating.tint = texel.rgb;
        coating.mask = texel.a;
    }
#endfor
#for Layer in NORMAL_LAYERS
    if (material.normalMap == $Layer)
        coating.bump = (texture(normals, vec3(normalAt, $Layer.0)).rgb * 255.0 - 128.0) / 127.0;
#endfor
    return coating;
}
#endif

// The shading normal that a normal map asks for, on the side of `facing`.
vec3 bumped(Surface surface, vec3 bump, vec3 facing) {
    vec3 bitangent = cross(surface.normal, surface.tangent);
    vec3 normal = normalize(mat3(surface.tangent, bitangent, surface.normal) * bump);
    return facing == surface.normal ? normal : -normal;
}

// A ray that leaves a surface at `point`, away from it along `off`.
Ray leaving(Ray ray, vec3 point, vec3 off, vec3 direction) {
    ray.origin = point + kEpsilon * off;
    ray.direction = normalize(direction);
    return ray;
}

vec3 radiance(Ray ray) {
    vec3 color = vec3(0.0);
    vec3 throughput = vec3(1.0);
    StackEntry stack[kStackSize];
    int pending = 0;
    int depth = 1;
    bool follow = true;
    while (follow) {
        follow = false;
        HitRecord hit;
        bool met = findClosest(ray, false, hit);
#if GLOWS
        color += throughput * glowAlong(ray, hit.t);
#endif
        if (met) {
            bool outside = dot(ray.direction, hit.normal) <= 0.0;
            vec3 facing = outside ? hit.normal : -hit.normal;
            vec3 normal = facing;
            Material material = loadMaterial(materialOf(hit.object));
            Coating coating = Coating(vec3(1.0), vec3(0.0, 0.0, 1.0), 1.0);
#if IMAGES
            Surface surface = surfaceAt(hit.object, ray, hit.t);
            coating = coatingAt(material, surface.uv);
            if (material.normalMap >= 0) normal = bumped(surface, coating.bump, facing);
#endif
            color += throughput * shade(material, hit.point, facing, normal, ray, coating.tint);
            ++depth;
#if REFLECTION
            if (material.optics != kPlain && coating.mask > 0.0 && depth <= frame.depth) {
                vec3 mirror = fresnel(material.f0, -dot(ray.direction, normal)) * coating.mask;
                follow = true;
#if REFRACTION
                if (material.optics == kDielectric) {
                    vec3 bent = refract(ray.direction, normal, outside ? 1.0 / material.ior : material.ior);
                    if (dot(bent, bent) < kEpsilon) {
                        mirror = vec3(1.0); // total reflection
                    } else {
                        // Schlick's formula wants the angle on the thinner side.
                        vec3 back = outside ? mirror : fresnel(material.f0, -dot(bent, normal));
                        Ray refracted = leaving(ray, hit.point, -facing, bent);
                        stack[pending].origin = refracted.origin;
                        stack[pending].direction = refracted.direction;
                        stack[pending].throughput = throughput * (1.0 - back);
                        stack[pending].depth = depth;
                        ++pending;
                        follow = outside;
                    }
                }
#endif
                throughput *= mirror;
                ray = leaving(ray, hit.point, facing, reflect(ray.direction, normal));
            }
#endif
        } else {
            color += throughput * skyColor(ray.direction, 0.0);
        }
        if (!follow && pending > 0) {
            --pending;
            ray.origin = stack[pending].origin;
            ray.direction = stack[pending].direction;
            throughput = stack[pending].throughput;
            depth = stack[pending].depth;
            follow = true;
        }
    }
    return color;
}
