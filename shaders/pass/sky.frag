// One pixel of the linear picture whose ray from the eye meets nothing: tracer/software/screen_partition.h says which
// do. As the tree would draw it.
#include "frame.glsl"
#include "scene.glsl"
#include "ray/ray.glsl"
#include "ray/primary.glsl"
#include "pass/linear_output.glsl"
#include "software/coverage_mask.glsl"
#include "shade/sky.glsl"
#if GLOWS
#include "shade/glow.glsl"
#endif

void main() {
    Ray ray = primaryRay();
    vec3 color = skyColor(ray.direction, frame.pixelAngle);
#if GLOWS
    color = glowAlong(ray, kFar) + color;
#endif
    store(vec4(color, 1.0));
    markCovered();
}
