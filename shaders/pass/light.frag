// One given surface point and light a pixel: what fraction of the light the shadow model of the settings says is seen.
//
// receivers  xyz: the point; w: what a pixel covers there
// normals    xyz: of the surface, unit; w: number of the object whose surface it is, in the shader's order; -1: none
// lights     xyz: centre; w: radius
// outLight   x: the fraction, y: evaluations of distances
// frame.repeats  how often each is asked for, 1 unless that is to be timed
#include "frame.glsl"
#include "scene.glsl"
#include "ray/ray.glsl"
#include "ray/split.glsl"
#if OUTPUT == STEPS
#include "sdf/count.glsl"
#endif
#include "ray/nearest.glsl"
#include "shade/lights.glsl"
#include "shade/light_fraction.glsl"

uniform sampler2D receivers;
uniform sampler2D normals;
uniform sampler2D lights;

layout(location = 0) out vec4 outLight;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 receiver = texelFetch(receivers, at, 0);
    vec4 normal = texelFetch(normals, at, 0);
    vec4 light = texelFetch(lights, at, 0);
    float fraction = 1.0;
    for (int i = 0; i < frame.repeats; ++i) {
        uvec3 nothing = uvec3(i) & frame.zero.xyz; // opaque to the compiler: no work is shared between the repeats
        vec3 point = uintBitsToFloat(floatBitsToUint(receiver.xyz) ^ nothing);
        Surface surface = bareSurface(point, normal.xyz, 0.0);
        Light asked; // of which shadows know no more
        asked.position = light.xyz;
        asked.radius = light.w;
        fraction = lightFraction(surface, int(normal.w), asked, receiver.w);
    }
#if OUTPUT == STEPS
    outLight = vec4(fraction, float(evaluations), 0.0, 0.0);
#else
    outLight = vec4(fraction, 0.0, 0.0, 0.0);
#endif
}
