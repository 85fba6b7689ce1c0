// Whitted's ray tree in a loop: where a surface both reflects and refracts, the refracted ray waits on a stack with its
// share and depth, and the loop goes on with the reflected one.
//
// Stack   at most one entry a level: depth - 1 entries never overflow. Separate arrays, written before the count grows:
//         an array of structs with stack[n++].ray = r yields zero rays on Mesa 22.3.
// Pencil  each ray carries the width its pixel has grown to and the angle it still grows by; curved mirrors widen it
// Source  T. Whitted, An Improved Illumination Model for Shaded Display, 1980; pencils after T. Akenine-Möller et al.,
//         Texture Level of Detail Strategies for Real-Time Ray Tracing, Ray Tracing Gems 2019
#if RAY_STACK
const int kMaxRays = 255; // all nodes of a binary tree of the largest depth
// A greater depth may stand in the frame block while the program with the larger stack compiles.
int deepest() { return min(frame.limits.x, kRayStack + 1); }
#else
const int kMaxRays = 8;
int deepest() { return frame.limits.x; }
#endif

struct Path {
    vec3 share;   // of this ray in the pixel
    int depth;    // 1 for the primary ray
    float width;  // of the pencil at the ray's start
    float spread; // of the pencil, radians
};

#if RAY_STACK
vec3 stackOrigin[kRayStack];
vec3 stackDirection[kRayStack];
vec3 stackShare[kRayStack];
uint stackPencil[kRayStack]; // width and spread, the upper half of each: the two digits that a level of detail needs
int stackTag[kRayStack]; // self, depth and side in one: each entry's numbers are registers of every pixel

void pushRay(inout int size, Ray ray, Path path) {
    stackOrigin[size] = ray.origin;
    stackDirection[size] = ray.direction;
    stackShare[size] = path.share;
    stackPencil[size] = (floatBitsToUint(path.width) & 0xFFFF0000u) | (floatBitsToUint(path.spread) >> 16);
    stackTag[size] = (ray.self << 5) | (path.depth << 1) | int(ray.side > 0.0);
    ++size;
}

void popRay(inout int size, out Ray ray, out Path path) {
    --size;
    int tag = stackTag[size];
    ray = rayFrom(stackOrigin[size], stackDirection[size], tag >> 5, (tag & 1) == 1 ? 1.0 : -1.0);
    path = Path(stackShare[size], (tag >> 1) & 15, uintBitsToFloat(stackPencil[size] & 0xFFFF0000u), uintBitsToFloat(stackPencil[size] << 16));
}
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
    Path path = Path(vec3(1.0), 1, 0.0, pixelAngle);
#if RAY_STACK
    int waiting = 0;
#endif
    for (int i = 0; i < kMaxRays; ++i) {
        bool follow = false;
        float t;
        int object = nearestHit(ray, t);
#if GLOWS
        color += path.share * glowAlong(ray, t);
#endif
        if (object < 0) {
            color += path.share * skyColor(ray.direction, path.spread);
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
            vec3 share = path.share;
            float width = path.width;
#if REFLECTION
            if (material.optics != kPlain && path.depth < deepest()) {
                float side = outside ? 1.0 : -1.0;
                float facingRatio = max(-dot(incoming, normal), 0.0);
                vec3 mirror = reflectance(material, facingRatio, uv, reach);
                float bend = 2.0 * path.width * surface.curvature / cosine;
                ++path.depth;
#if REFRACTION
                if (material.optics == kDielectric) {
                    float eta = outside ? 1.0 / material.ior : material.ior;
                    float k = 1.0 - eta * eta * (1.0 - facingRatio * facingRatio);
                    if (k < 0.0) {
                        mirror = vec3(1.0); // total reflection
                    } else {
                        // Schlick's formula wants the angle on the thinner side.
                        if (!outside) mirror = fresnel(material.f0, sqrt(k));
                        vec3 through = share * (1.0 - mirror);
                        if (largest(through) >= frame.options.x) {
                            vec3 bent = normalize(eta * incoming + (eta * facingRatio - sqrt(k)) * normal);
                            Ray refracted = rayFrom(surface.point, bent, object, -side);
                            float lens = abs(1.0 - eta) * path.width * surface.curvature / cosine;
                            pushRay(waiting, refracted, Path(through, path.depth, path.width, path.spread * eta + lens));
                        }
                    }
                }
#endif
                path.share = share * mirror;
                if (largest(path.share) >= frame.options.x) {
                    path.spread += bend;
                    ray = rayFrom(surface.point, mirrored(incoming, normal, facing), object, side);
                    follow = true;
                }
            }
#endif
            // After the next ray, so that what only that ray needs holds no registers while shadow rays run.
            color += share * shade(material, surface, object, facing, normal, -incoming, tint, share, width);
        }
        if (follow) continue;
#if RAY_STACK
        if (waiting == 0) break;
        popRay(waiting, ray, path);
#else
        break;
#endif
    }
    return color;
}
