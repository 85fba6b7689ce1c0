// Images on surfaces: paints, colour with the mask of a coat as alpha, and normals, each in the layers of one array
// that tracer/layers.h lays out. One sample for each purpose, whichever image a pixel wants: drivers for wide SIMD
// fetch at every place that a function has. The level of detail is explicit, from the width of the ray cone: no
// gradients, which are undefined in loops and differ between drivers.
//
// samplePaint, sampleNormal   `uv` in units of the layer, on which the material places its image's tile
// reach                       how much of uv the ray cone covers
float detailLevel(ivec2 size, vec2 reach) {
    vec2 texels = abs(reach) * vec2(size);
    return log2(max(max(texels.x, texels.y), 1.0));
}

#if PAINTS
uniform sampler2DArray paints;

vec4 samplePaint(int layer, vec2 uv, vec2 reach) {
    return textureLod(paints, vec3(uv, layer), detailLevel(textureSize(paints, 0).xy, reach));
}
#endif

#if NORMAL_MAPS
uniform sampler2DArray normals;

// In the surface's frame, of any length; 128 is flat.
vec3 sampleNormal(int layer, vec2 uv, vec2 reach) {
    vec3 texel = textureLod(normals, vec3(uv, layer), detailLevel(textureSize(normals, 0).xy, reach)).xyz;
    return (texel * 255.0 - 128.0) / 127.0;
}
#endif
