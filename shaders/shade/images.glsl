// Images on surfaces. The level of detail is explicit, from the width of the ray's pencil: no gradients, which are undefined
// in loops and differ between drivers.
//
// sampleColor, sampleNormal, sampleMask   an image by its slot, among those that serve so: drivers for wide SIMD fetch from
//                                         every image that a function names, whichever a pixel wants
// reach                                   how much of uv the pencil covers
#for Slot in IMAGE_SLOTS
uniform sampler2D image$Slot;
#endfor

float detailLevel(vec2 size, vec2 reach) {
    vec2 texels = abs(reach) * size;
    return log2(max(max(texels.x, texels.y), 1.0));
}

#if TEXTURES
vec3 sampleColor(int slot, vec2 uv, vec2 reach) {
#for Slot in COLOR_SLOTS
    if (slot == $Slot) return textureLod(image$Slot, uv, detailLevel(vec2(textureSize(image$Slot, 0)), reach)).rgb;
#endfor
    return vec3(1.0);
}
#endif

#if NORMAL_MAPS
// In the surface's frame, of any length; 128 is flat.
vec3 sampleNormal(int slot, vec2 uv, vec2 reach) {
    vec3 texel = vec3(0.5, 0.5, 1.0);
#for Slot in NORMAL_SLOTS
    if (slot == $Slot) texel = textureLod(image$Slot, uv, detailLevel(vec2(textureSize(image$Slot, 0)), reach)).xyz;
#endfor
    return (texel * 255.0 - 128.0) / 127.0;
}
#endif

#if COAT_MASKS
float sampleMask(int slot, vec2 uv, vec2 reach) {
#for Slot in MASK_SLOTS
    if (slot == $Slot) return textureLod(image$Slot, uv, detailLevel(vec2(textureSize(image$Slot, 0)), reach)).r;
#endfor
    return 1.0;
}
#endif
