// One pixel of the linear picture as it is shown, or as it is read back: the last of the full-screen passes.
//
// frame.encode   1: shown, each output made visible in [0, 1]; 0: its values as docs/outputs.md tells them
#include "frame.glsl"
#include "pass/linear_input.glsl"
#include "shade/encode.glsl"

layout(location = 0) out vec4 outColor;

vec3 valueOf(vec4 linear) {
#if OUTPUT == COLOR
    return chooseChannels(linear.rgb);
#elif OUTPUT == POSITION
    return linear.a == 0.0 ? vec3(0.0) : frame.origin.xyz + linear.rgb;
#else
    return linear.rgb;
#endif
}

#if OUTPUT == COLOR
vec3 shown(vec4 linear) { return encode(valueOf(linear)); }
#elif OUTPUT == WORK
vec3 shown(vec4 linear) { return linear.rgb / vec3(256.0, 64.0, 16.0); }
#elif OUTPUT == STEPS
vec3 shown(vec4 linear) { return linear.rgb / 256.0; }
#elif OUTPUT == DISTANCE
vec3 shown(vec4 linear) { return 1.0 / (1.0 + 0.05 * linear.rgb); }
#elif OUTPUT == OBJECT
vec3 shown(vec4 linear) {
    vec3 shade = fract(vec3(0.61803399, 0.75487767, 0.56984029) * (linear.r + 1.0));
    return linear.r < 0.0 ? vec3(0.0) : 0.25 + 0.75 * shade;
}
#elif OUTPUT == POSITION
// The origin's own fraction, since the sum has no more digits than its position in the world leaves.
vec3 shown(vec4 linear) { return linear.a == 0.0 ? vec3(0.0) : fract(fract(frame.origin.xyz) + linear.rgb); }
#elif OUTPUT == NORMAL
vec3 shown(vec4 linear) { return linear.a == 0.0 ? vec3(0.0) : 0.5 + 0.5 * linear.rgb; }
#else
vec3 shown(vec4 linear) { return linear.rgb; }
#endif

void main() {
    vec4 linear = loadLinear(gl_FragCoord.xy);
    outColor = vec4(frame.encode == 1 ? shown(linear) : valueOf(linear), 1.0);
}
