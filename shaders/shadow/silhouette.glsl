// Soft shadow by what the silhouettes of the casters cover of the light's disc. Nothing is marched or sampled where a
// shape is convex: its cover's area is worked out, and covers that overlap are united over a mask (shadow/cover.glsl).
// A shape that is not adds its cover to the union itself (uniteTYPE).
//
// The surface's own solid hides what is below the horizon and, where it is convex, nothing else. A light without a
// radius gets the disc that a pixel covers, so that its shadows have edges one pixel wide.
//
// Error   a single caster: shadow/round_cover.glsl, outline.glsl and ring_cover.glsl; several that overlap: cover.glsl;
//         a solid, which is marched: sdf_cover.glsl; an estimate, which rays are sent through: ray_cover.glsl
//         (tests/shader/silhouette_test.cpp, docs/shadows.md)
// Source  Nishita and Nakamae, 1983, for areas of sources seen past convex polygons; the rest is our own
#include "ray/bits.glsl"
#include "shadow/cover.glsl"
#include "shadow/frame_about.glsl"
#if SEARCHES
#include "accel/cone.glsl"
#endif

LightCone coneTo(ShadowQuery query) {
    mat2x3 frame = frameAbout(query.ray.direction);
    // Turned, so that no row runs along what is upright or level.
    vec3 first = 0.8 * frame[0] + 0.6 * frame[1];
    vec3 second = 0.8 * frame[1] - 0.6 * frame[0];
    float slope = max(discSlope(query.distance, query.lightRadius), max(query.pixelRadius / query.distance, 1e-5));
    return LightCone(query.ray.origin, mat3(first, second, query.ray.direction), slope, query.distance);
}

#if MARCHED_CASTERS
#include "shadow/sdf_cover.glsl"
#endif
#if RAY_COVERED_CASTERS
#include "shadow/sphere_parts.glsl"
#include "shadow/ray_cover.glsl"
#endif
#for Shape in CASTERS
#if $SHAPE_CONVEX
// From inside of a solid: the whole disc, if the light is not in there, too.
void hideAll$Shape(int index, ShadowQuery query, inout Shade shade) {
    float t = query.distance;
    if (meets$Shape(index, query.ray, t)) shade.largest = kPi;
}

void hide$Shape(int index, ShadowQuery query, LightCone cone, inout Shade shade) {
    $Shape shape = load$Shape(k$ShapeBase + index * k$ShapeTexels);
    Cover cover = cover$Shape(shape, cone);
    bool inside = cover.area < 0.0;
    for (int i = 0; i < (inside ? 1 : 0); ++i) hideAll$Shape(index, query, shade);
    for (int i = 0; i < (cover.area > 0.0 ? 1 : 0); ++i) unite(shade, cover);
}
#elif !$SHAPE_SOLID && !$SHAPE_RAY_COVER
void hide$Shape(int index, ShadowQuery query, LightCone cone, inout Shade shade) {
    bool own = query.ray.self == k$ShapeFirst + index;
    $Shape shape = load$Shape(k$ShapeBase + index * k$ShapeTexels);
    if (own && query.ray.side < 0.0) shade.largest = kPi;
    else unite$Shape(shape, cone, query.normal, own, query.ray.tMin, shade);
}
#endif
#if $SHAPE_BOUNDED && $SHAPE_SEARCH == HIERARCHY
const int kMasked$Shape = k$ShapeLoose;
#elif $SHAPE_BOUNDED
const int kMasked$Shape = k$ShapeCasters;
#endif
#if $SHAPE_BOUNDED
// Covers are asked of what the cone does not pass by, and of nothing else. A ray that leaves its own convex solid never
// comes back.
bool counts$Shape(int index, int self, LightCone cone) {
    return index != self && !passesBy(cone, ball$Shape(load$Shape(k$ShapeBase + index * k$ShapeTexels)));
}

// Those of 32 casters.
uint in$Shape(int first, int end, int self, LightCone cone) {
    uint mask = 0u;
    for (int i = 0; i < min(end - first, 32); ++i)
        if (counts$Shape(first + i, self, cone)) mask |= 1u << uint(i);
    return mask;
}
#endif
#endfor

float visibility(ShadowQuery query) {
    LightCone cone = coneTo(query);
    Shade shade = Shade(0.0, 0.0, Points(uvec4(0u), uvec4(0u)), 0.0);
    if (query.ray.self >= 0) {
        vec3 normal = query.normal * cone.axes;
        unite(shade, halfDisc(-cone.slope * normal.xy, normal.z));
    }
#for Shape in CASTERS
#if $SHAPE_CONVEX
    int self$Shape = query.ray.self - k$ShapeFirst;
    bool within$Shape = query.ray.side < 0.0 && self$Shape >= 0 && self$Shape < k$ShapeCasters;
    for (int i = 0; i < (within$Shape ? 1 : 0); ++i) hideAll$Shape(self$Shape, query, shade);
#else
    int self$Shape = -1;
#endif
#if $SHAPE_BOUNDED
#if $SHAPE_SEARCH == HIERARCHY
    int node$Shape = 0;
    for (int i = k$ShapeLoose; i <= k$ShapeCount; ++i) {
        int index = k$ShapeLoose + nextInCone(k$ShapeQuantisation, k$ShapeNodes, cone, node$Shape);
        if (index < k$ShapeLoose) break;
        if (index < k$ShapeCasters && counts$Shape(index, self$Shape, cone)) hide$Shape(index, query, cone, shade);
    }
#endif
#if $SHAPE_LATTICE
    bool passed$Shape = latticePassed(k$ShapeLattice, vec3(k$ShapeLatticeX, k$ShapeLatticeY, k$ShapeLatticeZ), cone);
    int first$Shape = passed$Shape ? k$ShapeLoose : 0;
#else
    const int first$Shape = 0;
#endif
    for (int first = first$Shape; first < kMasked$Shape; first += 32) {
        uint mask = in$Shape(first, kMasked$Shape, self$Shape, cone);
        for (int i = 0; i < 32 && mask != 0u; ++i) {
            int index = lowestBit(mask);
            mask &= mask - 1u;
            hide$Shape(first + index, query, cone, shade);
        }
    }
#else
    for (int i = 0; i < k$ShapeCasters; ++i)
        if (i != self$Shape) hide$Shape(i, query, cone, shade);
#endif
#endfor
    return bareFraction(shade);
}
