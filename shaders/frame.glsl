// What changes from frame to frame: one uniform block, filled by the renderer (FrameBlock in tracer/render/renderer.cpp).
//
// eye, right, up, forward   camera; right and up are scaled so that the canvas' edges lie at +-1
// origin                    of all coordinates of the shader, in the world: originOf() in tracer/scene/scene.h
// cone                      x: angle of one pixel in radians
// background                where nothing is hit and there is no cube map
// options                   x: rays with a smaller share of the picture are not followed, y: error of the light fraction that
//                           shadow cones may make, z: radius of all lights, negative: each its own
// canvas                    xy: size in pixels
// limits                    x: deepest ray 1 … 8, y: light of the visibility output, z: 1 to encode for a display
// budget                    most steps, x: of a march to a light, z: of a ray to a distance object; y: samples of a light, w: the
//                           first of them in their sequence
// channels                  xyz: which of r, g, b each output channel shows
// zero                      0, opaque to the compiler (ray/split.glsl)
layout(std140) uniform Frame {
    vec4 eye;
    vec4 right;
    vec4 up;
    vec4 forward;
    vec4 origin;
    vec4 background;
    vec4 cone;
    vec4 options;
    vec4 canvas;
    ivec4 limits;
    ivec4 budget;
    ivec4 channels;
    uvec4 zero;
} frame;
