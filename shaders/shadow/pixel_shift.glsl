// Two numbers in [0, 1) that differ from pixel to pixel, and with `salt`.
// Source  PCG-3D: M. Jarzynski and M. Olano, Hash Functions for GPU Rendering, JCGT 9(3), 2020
vec2 pixelShift(uint salt) {
    uvec3 v = uvec3(uvec2(gl_FragCoord.xy), salt) * 1664525u + 1013904223u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z; v.y += v.z * v.x;
    return vec2(v.xy >> 8u) / 16777216.0;
}
