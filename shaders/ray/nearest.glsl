// The scene as a whole: which object a ray meets first, whether anything lies in its way, and the surface there.
//
// Objects are numbered by kind, as layoutOf() in tracer/plan/layout.h says, in each kind those first that cast shadows.
// One loop a kind, over all of its objects or over those that a search comes to; which search changes nothing in the
// answer: of objects at the same distance the one with the lowest number is met. nearestHit keeps only t and the
// number, the surface is worked out once, afterwards.
//
// next       with MEDIA: the object that is met next nearest, at nextAt, where that is so near that the two surfaces
//            may be one: coincide() in ray/media.glsl
#if OUTPUT == WORK
// What this pixel has asked so far: boxes, objects, and how many shadow rays.
ivec3 work = ivec3(0);
#endif
#for Shape in SHAPES
#include "primitive/$shape.glsl"
#endfor

#for Shape in SHAPES
$Shape object$Shape(int index) { return load$Shape(k$ShapeBase + index * k$ShapeTexels); }
#endfor

#if SEARCHES
#include "accel/search.glsl"
#endif
#include "software/fallback.glsl"

// Whether the ray meets object `index` of its kind nearer than t, which then is where.
#for Shape in SHAPES
bool meets$Shape(int index, Ray ray, inout float t) {
#if OUTPUT == WORK
    ++work.y;
#endif
    float side = startSide(ray, k$ShapeFirst + index);
    return intersect$Shape(object$Shape(index), ray, side, t);
}
#endfor

#if MEDIA
int next;
float nextAt;

// How far objects count beyond the nearest.
float reachOf(Ray ray, bool shadow, float t) {
    vec3 size = abs(ray.origin);
    return shadow ? t : t + 1e-4 * (t + max(size.x, max(size.y, size.z)));
}

// As meets$Shape does for the nearest object, and for the one after it.
#for Shape in SHAPES
void meet$Shape(int index, Ray ray, bool shadow, inout int nearest, inout float t) {
    float at = reachOf(ray, shadow, t);
    int object = k$ShapeFirst + index;
    if (object == nearest || !meets$Shape(index, ray, at)) return;
    bool nearer = at < t || (at == t && object < nearest);
    int second = nearer ? nearest : object;
    float secondAt = nearer ? t : at;
    bool follows = nearer || secondAt < nextAt || (secondAt == nextAt && second < next);
    next = follows ? second : next;
    nextAt = follows ? secondAt : nextAt;
    t = nearer ? (shadow ? 0.0 : at) : t;
    nearest = nearer ? object : nearest;
}
#endfor
#endif

// Object nearest along the ray and nearer than t, which then is its distance; -1 where there is none. For `shadow` the
// first that is found among those that cast one.
//
// Wide SIMD runs each loop's body at least once, and not every compiler unrolls: loops are tested at their end, and one
// object has none.
int nearestHit(Ray ray, bool shadow, inout float t) {
    int nearest = -1;
#if MEDIA
    next = -1;
    nextAt = kFar;
#endif
#for Shape in SHAPES
#if $SHAPE_SEARCHED
    Search$Shape search$Shape = start$Shape(ray);
    bool more$Shape;
    do {
#if MEDIA
        int index = next$Shape(search$Shape, ray, reachOf(ray, shadow, t));
#else
        int index = next$Shape(search$Shape, ray, t);
#endif
#if MEDIA
        if (index >= 0 && (!shadow || index < k$ShapeCasters)) meet$Shape(index, ray, shadow, nearest, t);
#else
        float limit = uintBitsToFloat(floatBitsToUint(t) + 1u); // a hit at the same distance counts
        bool asked = index >= 0 && (!shadow || index < k$ShapeCasters);
        if (asked && meets$Shape(index, ray, limit) && (limit < t || k$ShapeFirst + index < nearest)) {
            t = shadow ? 0.0 : limit; // what is in the way ends the other searches, too
            nearest = k$ShapeFirst + index;
        }
#endif
        more$Shape = !(ended$Shape(search$Shape) || index < 0 || (shadow && nearest >= 0));
    } while (more$Shape);
#elif $SHAPE_ALONE
#if MEDIA
    if (!shadow || 0 < k$ShapeCasters) meet$Shape(0, ray, shadow, nearest, t);
#else
    if ((!shadow || 0 < k$ShapeCasters) && meets$Shape(0, ray, t)) nearest = k$ShapeFirst;
#endif
#else
    int at$Shape = 0;
    do {
#if MEDIA
        if (!shadow || at$Shape < k$ShapeCasters) meet$Shape(at$Shape, ray, shadow, nearest, t);
#else
        if ((!shadow || at$Shape < k$ShapeCasters) && meets$Shape(at$Shape, ray, t)) nearest = k$ShapeFirst + at$Shape;
#endif
        ++at$Shape;
    } while (at$Shape < k$ShapeCount);
#endif
#endfor
    noteUncommon(ray, shadow, nearest, t);
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
        int index = k$ShapeCount == 1 ? 0 : object - k$ShapeFirst; // the one index is known before any pixel is drawn
#if $SHAPE_ESTIMATED
        ray.side = startSide(ray, object);
#endif
        return surface$Shape(object$Shape(index), ray, t);
    }
#endfor
    return bareSurface(vec3(0.0), vec3(0.0), 0.0);
}

int materialOf(int object) { return int(sceneTexel(kObjectBase + object).x); }
int fileIndexOf(int object) { return int(sceneTexel(kObjectBase + object).y); }
