// Images on surfaces. The level of detail is explicit, from the width of the ray's pencil: no gradients, which are undefined
// in loops and differ between drivers.
//
// sampleImage  slot of the image, uv, and `reach`: how much of uv the pencil covers
#for Slot in IMAGE_SLOTS
uniform sampler2D image$Slot;
#endfor

float detailLevel(vec2 size, vec2 reach) {
    vec2 texels = abs(reach) * size;
    return log2(max(max(texels.x, texels.y), 1.0));
}

vec4 sampleImage(int slot, vec2 uv, vec2 reach) {
#for Slot in IMAGE_SLOTS
    if (slot == $Slot) return textureLod(image$Slot, uv, detailLevel(vec2(textureSize(image$Slot, 0)), reach));
#endfor
    return vec4(1.0);
}
