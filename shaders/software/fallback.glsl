// What the usual program leaves to the whole one: a pixel whose rays meet, or may meet, what few pixels do
// (tracer/software/uncommon_features.h). It finds that out on the way, and then goes no further.
//
// left         this pixel is
// leftOut      the object's surface or material is not for this program
// mayMeetUncommon  the ray enters, nearer than t, the ball about an object of a kind that this program cannot ask
#for Shape in UNCOMMON
#include "primitive/$shape.glsl"
#endfor
bool left = false;

bool fallsBack(int object) { return object >= 0 && sceneTexel(kObjectBase + object).z > 0.0; }

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
