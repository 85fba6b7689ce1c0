// The scene as a whole: which object a ray meets first, whether anything lies in its way, and the surface there.
//
// Objects are numbered by kind, as layoutOf() in tracer/plan/layout.h says, in each kind those first that cast shadows. One
// loop a kind, over all of its objects or over those that a search comes to; which search changes nothing in the answer: of
// objects at the same distance the one with the lowest number is met. nearestHit keeps only t and the number, the surface is
// worked out once, afterwards.
#if OUTPUT == WORK
// What this pixel has asked so far: boxes, objects, and how many shadow rays.
ivec3 work = ivec3(0);
#endif
#for Shape in SHAPES
#include "primitive/$shape.glsl"
#endfor
#if CACHED_LOADS
#include "software/cached_loads.glsl"
#endif
#if SEARCHES
#include "accel/search.glsl"
#endif
#if FALLBACK
#include "software/fallback.glsl"
#endif

// Whether the ray meets object `index` of its kind nearer than t, which then is where.
#for Shape in SHAPES
bool meets$Shape(int index, Ray ray, inout float t) {
#if OUTPUT == WORK
    ++work.y;
#endif
    float side = startSide(ray, k$ShapeFirst + index);
#if CACHED_LOADS && $SHAPE_ALONE
    return intersect$Shape(cached$Shape, ray, side, t);
#else
    return intersect$Shape(load$Shape(k$ShapeBase + index * k$ShapeTexels), ray, side, t);
#endif
}
#endfor

// Object nearest along the ray and nearer than t, which then is its distance; -1 where there is none. For `shadow` the first
// that is found among those that cast one.
//
// Software GL runs each loop's body at least once, and SwiftShader unrolls none: they are tested at their end, and one object has
// none.
int nearestHit(Ray ray, bool shadow, inout float t) {
    int nearest = -1;
#for Shape in SHAPES
#if $SHAPE_SEARCHED
    Search$Shape search$Shape = start$Shape(ray);
    bool more$Shape;
    do {
        int index = next$Shape(search$Shape, ray, t);
        float limit = uintBitsToFloat(floatBitsToUint(t) + 1u); // a hit at the same distance counts
        bool asked = index >= 0 && (!shadow || index < k$ShapeCasters);
        if (asked && meets$Shape(index, ray, limit) && (limit < t || k$ShapeFirst + index < nearest)) {
            t = shadow ? 0.0 : limit; // what is in the way ends the other searches, too
            nearest = k$ShapeFirst + index;
        }
        more$Shape = !(ended$Shape(search$Shape) || index < 0 || (shadow && nearest >= 0));
    } while (more$Shape);
#elif $SHAPE_ALONE
    if ((!shadow || 0 < k$ShapeCasters) && meets$Shape(0, ray, t)) nearest = k$ShapeFirst;
#else
    int at$Shape = 0;
    do {
        if ((!shadow || at$Shape < k$ShapeCasters) && meets$Shape(at$Shape, ray, t)) nearest = k$ShapeFirst + at$Shape;
        ++at$Shape;
    } while (at$Shape < k$ShapeCount);
#endif
#endfor
#if FALLBACK
    left = left || (!(shadow && nearest >= 0) && mayMeetUncommon(ray, shadow, t));
#endif
    return nearest;
}

int nearestHit(Ray ray, out float t) {
    t = kFar;
    return nearestHit(ray, false, t);
}

#if SHADOW_RAYS
bool occluded(Ray ray, float distance) {
#if OUTPUT == WORK
    ++work.z;
#endif
    return nearestHit(ray, true, distance) >= 0;
}
#endif

Surface surfaceAt(int object, Ray ray, float t) {
#for Shape in SHAPES
    if (object < k$ShapeEnd) {
#if CACHED_LOADS && $SHAPE_ALONE
        return surface$Shape(cached$Shape, ray, t);
#else
        int index = k$ShapeCount == 1 ? 0 : object - k$ShapeFirst; // the one place is known before any pixel is drawn
        return surface$Shape(load$Shape(k$ShapeBase + index * k$ShapeTexels), ray, t);
#endif
    }
#endfor
    return bareSurface(vec3(0.0), vec3(0.0), 0.0);
}

int materialOf(int object) { return int(sceneTexel(kObjectBase + object).x); }
int fileIndexOf(int object) { return int(sceneTexel(kObjectBase + object).y); }
