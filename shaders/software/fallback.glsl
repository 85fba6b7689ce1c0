// What the base variant falls back from: a pixel whose rays meet, or may meet, uncommon features
// (tracer/software/uncommon_features.h). It finds that out on the way, goes no further and is discarded; the full
// variant draws it.
//
// fallsBack      whether this pixel does; with an object: or the surface or material of that object is not in this
//                variant
// noteUncommon   after a search for the nearest object: the ray may enter, nearer than t, the ball about an object of a
//                kind that this variant cannot ask
#if FALLBACK
#for Shape in UNCOMMON
#include "primitive/$shape.glsl"
#endfor
bool discarded = false;

bool fallsBack() { return discarded; }

bool fallsBack(int object) {
    discarded = discarded || (object >= 0 && sceneTexel(kObjectBase + object).z > 0.0);
    return discarded;
}

bool mayMeetUncommon(Ray ray, bool shadow, float t) {
    bool may = false;
#for Shape in UNCOMMON
    for (int i = 0; i < k$ShapeCount; ++i) {
        vec4 ball = ball$Shape(load$Shape(k$ShapeBase + i * k$ShapeTexels));
        vec3 toBall = ball.xyz - ray.origin;
        float along = dot(toBall, ray.direction);
        float room = 1.001 * ball.w + 1e-5 * (abs(toBall.x) + abs(toBall.y) + abs(toBall.z));
        bool ahead = along > -room && along < t + room;
        if (ahead && (!shadow || i < k$ShapeCasters) && !passesBy(ray, ball)) may = true;
    }
#endfor
    return may;
}

void noteUncommon(Ray ray, bool shadow, int nearest, float t) {
    discarded = discarded || (!(shadow && nearest >= 0) && mayMeetUncommon(ray, shadow, t));
}
#else
bool fallsBack() { return false; }
bool fallsBack(int object) { return false; }
void noteUncommon(Ray ray, bool shadow, int nearest, float t) {}
#endif
