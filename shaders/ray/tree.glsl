// Whitted's ray tree in a loop: where a surface both reflects and refracts, the loop goes on with the reflected ray, and the
// refracted one waits (ray/waiting.glsl).
//
// Source  T. Whitted, An Improved Illumination Model for Shaded Display, 1980
#include "ray/primary.glsl"
#include "ray/ray_stack.glsl"
#if SHADOWS_IN_TREE
#include "ray/shadow_rays.glsl"
#elif LIGHTS
#include "shade/light_fraction.glsl"
#endif

#if REFRACTION
const int kMaxTurns = 2041; // all nodes of a binary tree of the largest depth, each traced anew as often as its depth may ask
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
#endif

vec3 traceTree(Ray ray) {
    vec3 color = vec3(0.0);
    Path path = primaryPath();
    uint trail = 0u;
#if SHADOWS_IN_TREE
    ShadowRays shadows;
    shadows.lit.counting = 0u;
    bool ahead = true; // a ray of the tree is to be met
#endif
    for (int i = 0; i < kMaxTurns; ++i) {
        float t;
#if SHADOWS_IN_TREE
        int object = nearestPastShadows(trail, ray, path, ahead, shadows, color, t);
        if (!ahead) break;
#else
        int object = nearestHit(ray, t);
#endif
#if FALLBACK
        left = left || fallsBack(object);
        if (left) break;
#endif
        bool follow = false;
        vec3 share = path.share;
#if REFRACTION
        bool again = path.depth <= restartDepthIn(trail); // what it sees has been added
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
            vec4 paint = vec4(1.0);
            path.width += path.spread * t;
            float cosine = max(-dot(ray.direction, facing), 1e-3);
#if PAINTS
            if (material.paint >= 0) {
                vec2 at = surface.uv * material.paintPlacement.xy + material.paintPlacement.zw;
                vec2 over = path.width * inversesqrt(cosine) * surface.uvPerUnit * material.paintPlacement.xy;
                paint = samplePaint(material.paint, at, over);
            }
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
            float side = outside ? 1.0 : -1.0;
            vec3 direction = incoming; // of the ray that follows, and the side it travels on
            float onwardSide = side;
#if REFLECTION
            if (material.optics != kPlain && path.depth < frame.depth) {
                float facingRatio = max(-dot(incoming, normal), 0.0);
                vec3 mirror = fresnel(material.f0, facingRatio) * paint.a; // what is reflected of what arrives
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
                        if (largest(through) >= frame.threshold) {
                            vec3 bent = normalize(eta * incoming + (eta * facingRatio - sqrt(k)) * normal);
                            float lens = abs(1.0 - eta) * path.width * surface.curvature / cosine;
                            Path onward = storable(Path(through, path.depth + 1, path.width, path.spread * eta + lens));
                            if (!again) {
                                pushRay(trail, rayFrom(surface.point, bent, object, -side), onward);
                            } else if ((trail & 256u << path.depth) != 0u) {
                                path = onward;
                                direction = bent;
                                onwardSide = -side;
                                follow = true;
                            }
                        }
                    }
                }
#endif
                vec3 mirrorShare = path.share * mirror;
                if (!follow && largest(mirrorShare) >= frame.threshold) {
                    path = Path(mirrorShare, path.depth + 1, path.width, path.spread + bend);
                    direction = mirrored(incoming, normal, facing);
                    follow = true;
                }
            }
#endif
            ray = rayFrom(surface.point, direction, object, onwardSide);
            color += share * material.own * paint.rgb;
#if LIGHTS
            // After the next ray, so that what only that ray needs holds no registers while shadow rays run.
            Lit lit = litBy(material, surface.point, facing, normal, -incoming, paint.rgb, share);
#if SHADOWS_IN_TREE
            shadows = ShadowRays(lit, side);
#else
            while (lit.counting != 0u) {
                vec3 adds;
                Light light = loadLight(nextLight(lit, adds));
                color += adds * lightFraction(surface, object, light, width);
            }
#endif
#endif
        }
#if SHADOWS_IN_TREE
        ahead = follow;
        if (!ahead && shadows.lit.counting == 0u && !anyPending(trail)) break;
#else
        if (follow) continue;
        if (!anyPending(trail)) break;
        popRay(trail, ray, path);
#endif
    }
    return color;
}
