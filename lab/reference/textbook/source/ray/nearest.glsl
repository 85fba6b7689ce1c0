// The scene as a whole, as the source document asked it: one loop over all objects of each kind, and at every closer
// hit the whole record of it. The baseline that shaders/ray/nearest.glsl is measured against.
//
// findClosest  the nearest hit along the ray; `shadow`: of what casts shadows, told by the object's number once it is
//              hit
// Limits       every ray asks every object, shadow rays no less than others
#for Shape in SHAPES
#include "primitive/$shape.glsl"
#endfor

struct HitRecord {
    float t;
    int object;
    vec3 point;
    vec3 normal;
};

bool findClosest(Ray ray, bool shadow, out HitRecord closest) {
    closest = HitRecord(kFar, -1, vec3(0.0), vec3(0.0));
#for Shape in SHAPES
    for (int i = 0; i < k$ShapeCount; ++i) {
        $Shape body = load$Shape(k$ShapeBase + i * k$ShapeTexels);
        float t = closest.t;
        if (intersect$Shape(body, ray, 0.0, t) && (!shadow || i < k$ShapeCasters)) {
            Surface surface = surface$Shape(body, ray, t);
            closest = HitRecord(t, k$ShapeFirst + i, surface.point, surface.normal);
        }
    }
#endfor
    return closest.object >= 0;
}

int nearestHit(Ray ray, out float t) {
    HitRecord closest;
    findClosest(ray, false, closest);
    t = closest.t;
    return closest.object;
}

Surface surfaceAt(int object, Ray ray, float t) {
#for Shape in SHAPES
    if (object < k$ShapeEnd)
        return surface$Shape(load$Shape(k$ShapeBase + (object - k$ShapeFirst) * k$ShapeTexels), ray, t);
#endfor
    return bareSurface(vec3(0.0), vec3(0.0), 0.0);
}

int materialOf(int object) { return int(sceneTexel(kObjectBase + object).x); }
int fileIndexOf(int object) { return int(sceneTexel(kObjectBase + object).y); }
