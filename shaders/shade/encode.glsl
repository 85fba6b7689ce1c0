// From the tracer's numbers to a display: the channels chosen by the colour mode, and the sRGB curve where the scene's
// colours are linear light.
//
// Source  IEC 61966-2-1
vec3 chooseChannels(vec3 color) {
    return vec3(color[frame.channels.x], color[frame.channels.y], color[frame.channels.z]);
}

#if LINEAR
vec3 encode(vec3 color) {
    vec3 c = clamp(color, 0.0, 1.0);
    vec3 curve = 1.055 * pow(max(c, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}
#else
vec3 encode(vec3 color) { return clamp(color, 0.0, 1.0); }
#endif
