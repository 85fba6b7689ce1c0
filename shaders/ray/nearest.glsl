// The scene as a whole: which object a ray meets first, whether anything lies in its way, and the surface there.
//
// Objects are numbered by kind, in each kind those first that cast shadows. One loop a kind, over all of its objects or over
// those that its hierarchy comes to; which of the two changes nothing in the answer: of objects at the same distance the one
// with the lowest number is met. nearestHit keeps only t and the number, the surface is worked out once, afterwards.
#for Shape in SHAPES
#include "primitive/$shape.glsl"
#endfor
#if HIERARCHIES
#include "accel/hierarchy.glsl"
#endif

const float kFar = 3e38;

// Object nearest along the ray, -1 where there is none; t is its distance.
int nearestHit(Ray ray, out float t) {
    t = kFar;
    int nearest = -1;
#for Shape in SHAPES
#if $SHAPE_HIERARCHY
    GridRay ray$Shape = gridRay(k$ShapeGrid, ray);
    int node$Shape = 0;
    for (int i = 0; i <= k$ShapeCount; ++i) {
        int leaf = nextLeaf(ray$Shape, k$ShapeGrid + 2, k$ShapeNodes, t, node$Shape);
        if (leaf < 0) break;
        int object = k$ShapeFirst + leaf;
        float limit = uintBitsToFloat(floatBitsToUint(t) + 1u); // a hit at the same distance counts
        bool hit = intersect$Shape(load$Shape(k$ShapeBase + leaf * k$ShapeTexels), ray, startSide(ray, object), limit);
        if (hit && (limit < t || object < nearest)) {
            t = limit;
            nearest = object;
        }
    }
#else
    for (int i = 0; i < k$ShapeCount; ++i) {
        int object = k$ShapeFirst + i;
        if (intersect$Shape(load$Shape(k$ShapeBase + i * k$ShapeTexels), ray, startSide(ray, object), t)) nearest = object;
    }
#endif
#endfor
    return nearest;
}

#if SHADOWS
bool occluded(Ray ray, float distance) {
    float t = distance;
#for Shape in CASTERS
#if $SHAPE_HIERARCHY
    GridRay ray$Shape = gridRay(k$ShapeGrid, ray);
    int node$Shape = 0;
    for (int i = 0; i <= k$ShapeCount; ++i) {
        int leaf = nextLeaf(ray$Shape, k$ShapeGrid + 2, k$ShapeNodes, t, node$Shape);
        if (leaf < 0) break;
        if (leaf < k$ShapeCasters &&
            intersect$Shape(load$Shape(k$ShapeBase + leaf * k$ShapeTexels), ray, startSide(ray, k$ShapeFirst + leaf), t)) return true;
    }
#else
    for (int i = 0; i < k$ShapeCasters; ++i)
        if (intersect$Shape(load$Shape(k$ShapeBase + i * k$ShapeTexels), ray, startSide(ray, k$ShapeFirst + i), t)) return true;
#endif
#endfor
    return false;
}
#endif

Surface surfaceAt(int object, Ray ray, float t) {
#for Shape in SHAPES
    if (object < k$ShapeEnd) return surface$Shape(load$Shape(k$ShapeBase + (object - k$ShapeFirst) * k$ShapeTexels), ray, t);
#endfor
    return bareSurface(vec3(0.0), vec3(0.0), 0.0);
}

int materialOf(int object) { return int(sceneTexel(kObjectBase + object).x); }
int fileIndexOf(int object) { return int(sceneTexel(kObjectBase + object).y); }
