// One pixel whose ray from the eye meets nothing: tracer/software/screen_partition.h says which do. As the tree would draw it.
#include "frame.glsl"
#include "scene.glsl"
#include "ray/ray.glsl"
#include "ray/primary.glsl"
#include "shade/sky.glsl"
#if GLOWS
#include "shade/glow.glsl"
#endif
#include "shade/encode.glsl"

out vec4 outColor;

void main() {
    Ray ray = primaryRay();
    vec3 color = skyColor(ray.direction, frame.pixelAngle);
#if GLOWS
    color = glowAlong(ray, kFar) + color;
#endif
    color = chooseChannels(color);
    outColor = vec4(frame.encode == 1 ? encode(color) : color, 1.0);
}
