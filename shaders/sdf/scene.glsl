// The scene as one distance: what all that casts shadows leaves free about a point.
//
// sceneDistance  xyz: gradient, unit; w: signed distance of the nearest of all objects that cast shadows, with `from`
//                as the shapes' own distances take it. What is farther than `atMost` is not looked for: where nothing
//                is nearer, w is that
// Error          that of the nearest object's shape. Where solids overlap, w inside is that of the deepest one: a bound
//                from above for the way out of all of them
// Cost           one loop a kind: over every object, or over those that a search comes to (sdf/nearby.glsl)
#for Shape in CASTERS
#include "primitive/$shape.glsl"
#endfor
#if OUTPUT == STEPS
#include "sdf/count.glsl"
#endif
#if SPHERE_LATTICES || NEARBY
#include "sdf/nearby.glsl"
#endif

vec4 nearer(vec4 a, vec4 b) { return b.w < a.w ? b : a; }

#for Shape in CASTERS
vec4 nearer$Shape(vec4 nearest, int index, vec3 p, vec3 from) {
    return nearer(nearest, distance$Shape(load$Shape(k$ShapeBase + index * k$ShapeTexels), p, from));
}
#endfor

vec4 sceneDistance(vec3 p, vec3 from, float atMost) {
#if OUTPUT == STEPS
    ++evaluations;
#endif
    vec4 nearest = vec4(0.0, 1.0, 0.0, atMost);
#for Shape in CASTERS
#if $SHAPE_SPHERE_LATTICE
    nearest = nearer$Shape(nearest,
        nearestCell(k$ShapeLattice, vec3(k$ShapeLatticeX, k$ShapeLatticeY, k$ShapeLatticeZ), p), p, from);
#endif
#if $SHAPE_NEARBY
    QuantisedPoint point$Shape = quantisedPoint(k$ShapeQuantisation, p);
    int node$Shape = 0;
    for (int i = k$ShapeLoose; i <= k$ShapeCount; ++i) {
        int index = k$ShapeLoose + nextNearby(point$Shape, k$ShapeQuantisation + 2, k$ShapeNodes, nearest.w,
            node$Shape);
        if (index < k$ShapeLoose) break;
        if (index < k$ShapeCasters) nearest = nearer$Shape(nearest, index, p, from);
    }
#elif $SHAPE_SPHERE_LATTICE
    for (int i = k$ShapeLoose; i < k$ShapeCasters; ++i) nearest = nearer$Shape(nearest, i, p, from);
#else
    for (int i = 0; i < k$ShapeCasters; ++i) nearest = nearer$Shape(nearest, i, p, from);
#endif
#endfor
    return nearest;
}
