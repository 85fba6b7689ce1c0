// Whitted's ray tree in a loop: where a surface both reflects and refracts, the refracted ray waits on a stack with its
// share and depth, and the loop goes on with the reflected one.
//
// Stack   three entries at every depth: what waits lies in registers of every pixel, and seven keep a GPU from 8 waves. A ray of
//         a deeper tree may lose its entry to another; when its turn comes, the way to it is traced anew from the eye, unseen: one
//         pixel in 600 of `pro` at depth 8 ever needs that. Separate arrays, written apart from their index: an array of structs
//         with stack[n++].ray = r yields zero rays on Mesa 22.3
// Pencil  each ray carries the width its pixel has grown to and the angle it still grows by; curved mirrors widen it
// Source  T. Whitted, An Improved Illumination Model for Shaded Display, 1980; the way back without a stack after S. Laine,
//         Restart Trail for Stackless BVH Traversal, 2010; pencils after T. Akenine-Möller et al., Texture Level of Detail
//         Strategies for Real-Time Ray Tracing, Ray Tracing Gems 2019
#include "ray/primary.glsl"
#if SHADOWS_IN_TREE
#include "ray/shadow_rays.glsl"
#elif LIGHTS
#include "shade/light_fraction.glsl"
#endif

struct Path {
    vec3 share;   // of this ray in the pixel
    int depth;    // 1 for the primary ray
    float width;  // of the pencil at the ray's start
    float spread; // of the pencil, radians
};

Path primaryPath(float pixelAngle) { return Path(vec3(1.0), 1, 0.0, pixelAngle); }

#if REFRACTION
#include "ray/bits.glsl"

const int kMaxTurns = 2041; // all nodes of a binary tree of the largest depth, each traced anew as often as its depth may ask
const uint kRayStack = 3u;
vec3 stackOrigin[kRayStack];
vec3 stackDirection[kRayStack];
uvec2 stackShare[kRayStack]; // 21 bits a channel
uint stackPencil[kRayStack]; // width and spread, the upper half of each
int stackTag[kRayStack]; // self, depth and side in one: each entry's numbers are registers of every pixel

// The way through the tree, in one register: of a surface at depth d bit d says that its refracted ray is still to come, bit
// 8 + d that this ray, not the reflected one, is on the way. From bit 16 on the depth of the surface whose refracted ray is
// traced anew, 0 for none.
uint waitingIn(uint trail) { return trail & 0xFFu; }
int soughtIn(uint trail) { return int(trail >> 16); }

const float kShareSteps = 1048576.0;

// A path as the stack holds it, whether its ray waits or is traced anew: its share to a millionth, of the pencil the two digits
// that a level of detail needs.
float upperHalf(float x) { return uintBitsToFloat(floatBitsToUint(x) & 0xFFFF0000u); }
Path storable(Path path) {
    vec3 share = floor(path.share * kShareSteps + 0.5) / kShareSteps;
    return Path(share, path.depth, upperHalf(path.width), upperHalf(path.spread));
}

uint slotOf(int depth) { return uint(depth) % kRayStack; }

// `path` is that of the ray, one deeper than the surface that it leaves.
void pushRay(inout uint trail, Ray ray, Path path) {
    int depth = path.depth - 1;
    uint slot = slotOf(depth);
    stackOrigin[slot] = ray.origin;
    stackDirection[slot] = ray.direction;
    uvec3 share = uvec3(path.share * kShareSteps);
    stackShare[slot] = uvec2(share.r | share.g << 21, share.g >> 11 | share.b << 10);
    stackPencil[slot] = floatBitsToUint(path.width) | (floatBitsToUint(path.spread) >> 16);
    stackTag[slot] = (ray.self << 5) | (path.depth << 1) | int(ray.side > 0.0);
    trail = (trail | 1u << depth) & ~(256u << depth);
}

// The deepest ray that waits, or the primary ray again where that one has lost its entry.
void popRay(inout uint trail, float pixelAngle, out Ray ray, out Path path) {
    int depth = highestBit(waitingIn(trail));
    uint slot = slotOf(depth);
    int tag = stackTag[slot];
    bool kept = ((tag >> 1) & 15) == depth + 1;
    trail = (trail & 0xFFFFu & ~(1u << depth)) | 256u << depth | (kept ? 0u : uint(depth) << 16);
    ray = primaryRay();
    path = primaryPath(pixelAngle);
    if (kept) {
        uvec2 bits = stackShare[slot];
        vec3 share = vec3(bits.x & 0x1FFFFFu, bits.x >> 21 | (bits.y & 0x3FFu) << 11, bits.y >> 10) / kShareSteps;
        ray = rayFrom(stackOrigin[slot], stackDirection[slot], tag >> 5, (tag & 1) == 1 ? 1.0 : -1.0);
        path = Path(share, depth + 1, uintBitsToFloat(stackPencil[slot] & 0xFFFF0000u), uintBitsToFloat(stackPencil[slot] << 16));
    }
}
#else
const int kMaxTurns = 9; // a ray at each depth, and the last surface's shadow rays
#endif

float largest(vec3 v) { return max(v.r, max(v.g, v.b)); }

#if REFLECTION
// Mirrored on the shading normal, or on the geometric one where that would lead into the surface.
vec3 mirrored(vec3 direction, vec3 normal, vec3 facing) {
    vec3 reflected = reflect(direction, normal);
    return normalize(dot(reflected, facing) > 0.0 ? reflected : reflect(direction, facing));
}

// How much of what arrives is reflected; `cosine` against the shading normal.
vec3 reflectance(Material material, float cosine, vec2 uv, vec2 reach) {
    vec3 share = fresnel(material.f0, cosine);
#if COAT_MASKS
    if (material.mask >= 0) share *= sampleMask(material.mask, uv, reach);
#endif
    return share;
}
#endif

vec3 traceTree(Ray ray, float pixelAngle) {
    vec3 color = vec3(0.0);
    Path path = primaryPath(pixelAngle);
#if REFRACTION
    uint trail = 0u;
#endif
#if SHADOWS_IN_TREE
    ShadowRays shadows;
    shadows.lit.counting = 0u;
    bool ahead = true; // a ray of the tree is to be met
#endif
    for (int i = 0; i < kMaxTurns; ++i) {
        float t;
#if SHADOWS_IN_TREE
        int object = nearestPastShadows(ray, ahead, shadows, color, t);
        if (!ahead) break;
#else
        int object = nearestHit(ray, t);
#endif
        bool follow = false;
        vec3 share = path.share;
#if REFRACTION
        bool again = path.depth <= soughtIn(trail); // what it sees has been added
        if (again) share = vec3(0.0);
#endif
#if GLOWS
        color += share * glowAlong(ray, t);
#endif
        if (object < 0) {
            color += share * skyColor(ray.direction, path.spread);
        } else {
            Surface surface = surfaceAt(object, ray, t);
            Material material = loadMaterial(materialOf(object));
            bool outside = dot(ray.direction, surface.normal) <= 0.0;
            vec3 facing = outside ? surface.normal : -surface.normal;
            vec3 normal = facing;
            vec3 tint = vec3(1.0);
            vec2 uv = surface.uv;
            vec2 reach = vec2(0.0);
            path.width += path.spread * t;
            float cosine = max(-dot(ray.direction, facing), 1e-3);
#if TEXTURES
            uv = surface.uv * material.texturePlacement.xy + material.texturePlacement.zw;
            reach = path.width * inversesqrt(cosine) * surface.uvPerUnit * material.texturePlacement.xy;
            if (material.texture >= 0) tint = sampleColor(material.texture, uv, reach);
#endif
#if NORMAL_MAPS
            if (material.normalMap >= 0) {
                vec2 at = surface.uv * material.normalPlacement.xy + material.normalPlacement.zw;
                vec2 over = path.width * inversesqrt(cosine) * surface.uvPerUnit * material.normalPlacement.xy;
                vec3 bump = sampleNormal(material.normalMap, at, over);
                vec3 bitangent = cross(surface.normal, surface.tangent);
                normal = normalize(bump.x * surface.tangent + bump.y * bitangent + bump.z * surface.normal);
                normal = outside ? normal : -normal;
            }
#endif
            vec3 incoming = ray.direction;
            float width = path.width;
#if REFLECTION
            if (material.optics != kPlain && path.depth < frame.limits.x) {
                float side = outside ? 1.0 : -1.0;
                float facingRatio = max(-dot(incoming, normal), 0.0);
                vec3 mirror = reflectance(material, facingRatio, uv, reach);
                float bend = 2.0 * path.width * surface.curvature / cosine;
#if REFRACTION
                if (material.optics == kDielectric) {
                    float eta = outside ? 1.0 / material.ior : material.ior;
                    float k = 1.0 - eta * eta * (1.0 - facingRatio * facingRatio);
                    if (k < 0.0) {
                        mirror = vec3(1.0); // total reflection
                    } else {
                        // Schlick's formula wants the angle on the thinner side.
                        if (!outside) mirror = fresnel(material.f0, sqrt(k));
                        vec3 through = path.share * (1.0 - mirror);
                        if (largest(through) >= frame.options.x) {
                            vec3 bent = normalize(eta * incoming + (eta * facingRatio - sqrt(k)) * normal);
                            float lens = abs(1.0 - eta) * path.width * surface.curvature / cosine;
                            Ray refracted = rayFrom(surface.point, bent, object, -side);
                            Path onward = storable(Path(through, path.depth + 1, path.width, path.spread * eta + lens));
                            if (!again) {
                                pushRay(trail, refracted, onward);
                            } else if ((trail & 256u << path.depth) != 0u) {
                                ray = refracted;
                                path = onward;
                                follow = true;
                            }
                        }
                    }
                }
#endif
                vec3 mirrorShare = path.share * mirror;
                if (!follow && largest(mirrorShare) >= frame.options.x) {
                    path = Path(mirrorShare, path.depth + 1, path.width, path.spread + bend);
                    ray = rayFrom(surface.point, mirrored(incoming, normal, facing), object, side);
                    follow = true;
                }
            }
#endif
            color += share * material.own * tint;
#if LIGHTS
            // After the next ray, so that what only that ray needs holds no registers while shadow rays run.
            Lit lit = litBy(material, surface.point, facing, normal, -incoming, tint, share);
#if SHADOWS_IN_TREE
            shadows = ShadowRays(lit, surface.point, object, outside ? 1.0 : -1.0);
#else
            while (lit.counting != 0u) {
                vec3 adds;
                Light light = loadLight(nextLight(lit, adds));
                color += adds * lightFraction(surface, object, light, width);
            }
#endif
#endif
        }
        if (follow) continue;
#if REFRACTION
        bool more = waitingIn(trail) != 0u;
        if (more) popRay(trail, pixelAngle, ray, path);
#else
        bool more = false;
#endif
#if SHADOWS_IN_TREE
        ahead = more;
        if (!more && shadows.lit.counting == 0u) break;
#else
        if (!more) break;
#endif
    }
    return color;
}
