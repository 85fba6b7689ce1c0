// The scene as a whole: which object a ray meets first, whether anything lies in its way, and the surface there.
//
// Objects are numbered by kind, in each kind those first that cast shadows. One loop a kind; nearestHit keeps only t and
// the number, the surface is worked out once, afterwards.
#for Shape in SHAPES
#include "primitive/$shape.glsl"
#endfor

const float kFar = 3e38;

// Object nearest along the ray, -1 where there is none; t is its distance.
int nearestHit(Ray ray, out float t) {
    t = kFar;
    int nearest = -1;
#for Shape in SHAPES
    for (int i = 0; i < k$ShapeCount; ++i) {
        int object = k$ShapeFirst + i;
        if (intersect$Shape(load$Shape(k$ShapeBase + i * k$ShapeTexels), ray, startSide(ray, object), t)) nearest = object;
    }
#endfor
    return nearest;
}

#if SHADOWS
bool occluded(Ray ray, float distance) {
    float t = distance;
#for Shape in CASTERS
    for (int i = 0; i < k$ShapeCasters; ++i)
        if (intersect$Shape(load$Shape(k$ShapeBase + i * k$ShapeTexels), ray, startSide(ray, k$ShapeFirst + i), t)) return true;
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
