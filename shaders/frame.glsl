// What changes from frame to frame, one uniform block: FrameUniforms in tracer/render/frame_uniforms.h, byte for byte.
//
// eye, right, up, forward  camera; right and up are scaled so that the canvas' edges lie at ±1
// origin         of all coordinates of the shader, in the world: originOf() in tracer/plan/drawn.h
// background     colour where nothing is hit and there is neither image nor gradient
// channels       xyz: which of r, g, b each output channel shows
// zero           0, which no compiler knows: an optimisation barrier (ray/split.glsl)
// canvas         size in pixels
// pixelAngle     that a pixel covers, in radians
// threshold      rays of a smaller throughput are not followed, and lights that add less get no shadow ray
// coneError      of the light fraction, that shadow cones may make
// lightRadius    of all lights; negative: each its own
// depth          of the deepest ray, 1 … 8; the primary ray has 1
// light          whose light fraction the visibility output shows
// encode         1: for a display, 0: as numbers
// shadowSteps    most steps of a march to a light
// marchSteps     most steps of a ray to a distance object
// samples        of a light
// firstSample    of those in their sequence: a picture of many samples is drawn in batches
// repeats        of each answer in the batch passes (intersect, light), 1 unless they are timed
// fieldSteps, fieldEpsilon, fieldRelaxation  of rays through fields (field/march.glsl)
layout(std140) uniform Frame {
    vec4 eye;
    vec4 right;
    vec4 up;
    vec4 forward;
    vec4 origin;
    vec4 background;
    ivec4 channels;
    uvec4 zero;
    vec2 canvas;
    float pixelAngle;
    float threshold;
    float coneError;
    float lightRadius;
    int depth;
    int light;
    int encode;
    int shadowSteps;
    int marchSteps;
    int samples;
    int firstSample;
    int repeats;
    int fieldSteps;
    float fieldEpsilon;
    float fieldRelaxation;
} frame;
