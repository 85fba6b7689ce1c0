// One given ray a pixel, instead of a camera's: what the intersectors answer, as float32, for measuring and testing
// them.
//
// rayOrigins     xyz: origin; w: 1 + i where the ray starts on object i and travels outside of it, -1 - i inside, 0:
//                starts nowhere
// rayDirections  xyz: direction, unit to float32; w: tMin, < 0: as rayFrom() tells it
// outHit         x: t, y: number of the object in the shader's order, -1 where nothing is hit
// frame.repeats  how often each ray is intersected, 1 unless that is to be timed: the surface is worked out once
// outPoint       xyz: the surface point, outNormal  xyz: its normal, outward; 0 where nothing is hit
#include "frame.glsl"
#include "scene.glsl"
#include "ray/ray.glsl"
#include "ray/split.glsl"
#include "ray/nearest.glsl"

uniform sampler2D rayOrigins;
uniform sampler2D rayDirections;

layout(location = 0) out vec4 outHit;
layout(location = 1) out vec4 outPoint;
layout(location = 2) out vec4 outNormal;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 origin = texelFetch(rayOrigins, at, 0);
    vec4 direction = texelFetch(rayDirections, at, 0);
    Ray ray = rayFrom(origin.xyz, direction.xyz, int(abs(origin.w)) - 1, sign(origin.w));
    if (direction.w >= 0.0) ray.tMin = direction.w;
    float t = 0.0;
    int object = -1;
    for (int i = 0; i < frame.repeats; ++i) {
        uvec3 nothing = uvec3(i) & frame.zero.xyz; // opaque to the compiler: no work is shared between the repeats
        ray.origin = uintBitsToFloat(floatBitsToUint(origin.xyz) ^ nothing);
        ray.direction = uintBitsToFloat(floatBitsToUint(direction.xyz) ^ nothing);
        object = nearestHit(ray, t);
    }
    outHit = vec4(t, float(object), 0.0, 0.0);
    outPoint = vec4(0.0);
    outNormal = vec4(0.0);
    if (object < 0) return;
    Surface surface = surfaceAt(object, ray, t);
    outPoint = vec4(surface.point, 0.0);
    outNormal = vec4(surface.normal, 0.0);
}
