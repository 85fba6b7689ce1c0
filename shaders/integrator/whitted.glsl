// Whitted's ray tree in a loop: where a surface both reflects and refracts, the loop continues with the reflected ray,
// and the refracted one is pushed on the ray stack.
//
// radiance  along the primary ray: what every integrator, one file of this folder each, gives to pass/trace.frag
// Source    T. Whitted, An Improved Illumination Model for Shaded Display, 1980
#include "ray/primary.glsl"
#include "ray/path.glsl"
#if MEDIA
#include "ray/media.glsl"
#endif
#include "integrator/ray_stack.glsl"
#include "shade/shading_point.glsl"
#include "shade/sky.glsl"
#if GLOWS
#include "shade/glow.glsl"
#endif

float largest(vec3 v) { return max(v.r, max(v.g, v.b)); }

#if REFLECTION
#include "shade/scatter.glsl"
#endif
#if LIGHTS
#include "shade/direct_light.glsl"
#if SHADOWS_IN_TREE
#include "integrator/shadow_rays.glsl"
#else
#include "shade/light_fraction.glsl"
#endif
#endif

#if PASSES_ON
// Surfaces of dielectrics that a ray of the largest depth passes before it is taken to see the background: glass that
// is dust, as a Mandelbulb's, would hold it up for long.
const int kMostStraight = 16;
#endif

#if MEDIA
const int kMostPassed = 256; // surfaces that are no interface, by all rays of a pixel; what follows takes depth
#endif

#if REFRACTION
// All nodes of a binary tree of the largest depth, each traced anew as often as its depth may ask.
#if MEDIA || PASSES_ON
const int kMaxIterations = 8192; // and what lets rays go straight on
#else
const int kMaxIterations = 2041;
#endif
#else
const int kMaxIterations = 9; // a ray at each depth, and the last surface's shadow rays
#endif

#if REFLECTION
// Whether a ray leaves the point, on which the loop continues: the reflected one, or on a retrace what leads to the ray
// that lost its entry. The refracted one is pushed.
bool scatterRay(ShadingPoint at, int object, bool again, inout uint trail, inout Path path, inout vec3 direction,
                inout float side) {
    vec3 incoming = direction;
    Scatter scatter = scatterAt(at, incoming);
    bool follow = false;
    Path reflected = reflectedPath(path, at, scatter);
#if REFRACTION
    Path refracted = refractedPath(path, at, scatter);
    if (scatter.beyond >= 0.0 && largest(refracted.throughput) >= frame.threshold) {
        vec3 bent = refractedDirection(at, scatter, incoming);
        refracted = storable(refracted);
        if (!again) {
            pushRay(trail, rayFrom(at.surface.point, bent, object, -side), refracted);
        } else if (onRetrace(trail, path.depth)) {
            path = refracted;
            direction = bent;
            side = -side;
            follow = true;
#if MEDIA
            inside = beyond;
#endif
        }
    }
#endif
    if (!follow && largest(reflected.throughput) >= frame.threshold) {
        path = reflected;
        direction = reflectedDirection(at, incoming);
        follow = true;
    }
    return follow;
}
#endif

vec3 radiance(Ray ray) {
    vec3 color = vec3(0.0);
    Path path = primaryPath();
    uint trail = 0u;
#if MEDIA
    resetMedia();
    int passed = 0;
#endif
#if SHADOWS_IN_TREE
    ShadowRays shadows;
    shadows.direct.counting = 0u;
    bool ahead = true; // a ray of the tree is to be met
#endif
    for (int i = 0; i < kMaxIterations; ++i) {
        float t;
#if SHADOWS_IN_TREE
        int object = nearestPastShadows(trail, ray, path, ahead, shadows, color, t);
        if (!ahead) break;
#else
        int object = nearestHit(ray, t);
#endif
        if (fallsBack(object)) break;
#if MEDIA
        if (object >= 0 && rankOf(object) != 0.0 && next >= 0 && rankOf(next) == 0.0 && coincide(ray, t, nextAt, 1.0)) {
            object = next; // what water or glass lies on is seen through it
            t = nextAt;
            next = -1;
        }
#endif
#if ABSORPTION
        path.throughput *= absorbed(t);
#endif
        bool follow = false;
        bool again = retraced(trail, path.depth);
        vec3 throughput = again ? vec3(0.0) : path.throughput;
#if GLOWS
        color += throughput * glowAlong(ray, t);
#endif
        if (object < 0) {
            color += throughput * skyColor(ray.direction, path.spread);
        } else {
            path.width += path.spread * t;
            ShadingPoint at = shadingPointAt(object, ray, t, path.width);
            vec3 incoming = ray.direction;
#if MEDIA
            at.eta = crossMedia(object, at.side, coincide(ray, t, nextAt, at.cosine) ? next : -1);
            if (at.material.optics == kDielectric && at.eta == 0.0 && ++passed <= kMostPassed) {
                inside = beyond;
                ray = rayFrom(at.surface.point, incoming, object, -at.side);
                continue;
            }
            at.eta = at.eta == 0.0 ? 1.0 : at.eta;
#endif
            vec3 direction = incoming; // of the ray that follows, and the side it travels on
            float side = at.side;
            float width = path.width;
#if REFLECTION
#if PASSES_ON
            if (at.material.optics == kDielectric && path.depth >= frame.depth) {
                ++path.depth;
                follow = path.depth <= frame.depth + kMostStraight; // unbent: what bends no more ends no light either
                if (!follow) color += throughput * skyColor(incoming, path.spread);
                side = -side;
#if MEDIA
                inside = beyond;
#endif
            }
#endif
            if (at.material.optics != kPlain && path.depth < frame.depth)
                follow = scatterRay(at, object, again, trail, path, direction, side);
#endif
            ray = rayFrom(at.surface.point, direction, object, side);
            color += throughput * at.material.own * at.paint.rgb;
#if LIGHTS
            // After the next ray, so that what only that ray needs holds no registers while shadow rays run.
            DirectLight direct = directLightAt(at, -incoming, throughput);
#if SHADOWS_IN_TREE
            shadows = ShadowRays(direct, at.side);
#else
            while (direct.counting != 0u) {
                vec3 added;
                Light light = loadLight(nextLight(direct, added));
                color += added * lightFraction(at.surface, object, light, width);
            }
#endif
#endif
        }
#if SHADOWS_IN_TREE
        ahead = follow;
        if (!ahead && shadows.direct.counting == 0u && !anyPending(trail)) break;
#else
        if (follow) continue;
        if (!anyPending(trail)) break;
        popRay(trail, ray, path);
#endif
    }
    return color;
}
