// The light's disc in seven parts of nearly one size: its middle and six about it.
//
// kPartSlope  radius of a disc as large as a part
// kParts      which points of Shade's mask (shadow/cover.glsl) are nearest to each part's middle
const float kPartSlope = 0.377964473; // 1 / sqrt(7)
const Points kParts[7] = Points[7](
    Points(uvec4(0x01800000u, 0x07C00000u, 0x07E00000u, 0x07E00000u),
        uvec4(0x000003E0u, 0x000007E0u, 0x000003C0u, 0x00000180u)),
    Points(uvec4(0xE0000000u, 0xF0000000u, 0xF8000000u, 0xF8008000u),
        uvec4(0x8000FC00u, 0x0000F800u, 0x0000F000u, 0x0000E000u)),
    Points(uvec4(0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u),
        uvec4(0x7F000000u, 0xFF000000u, 0xFF000C00u, 0xFF001E00u)),
    Points(uvec4(0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u),
        uvec4(0x00FE0000u, 0x00FF0000u, 0x00FF0020u, 0x00FF0078u)),
    Points(uvec4(0x00070000u, 0x001F0000u, 0x001F0000u, 0x001F0001u),
        uvec4(0x0001001Fu, 0x0000001Fu, 0x0000001Fu, 0x00000007u)),
    Points(uvec4(0x007800FFu, 0x002000FFu, 0x000000FFu, 0x000000FEu),
        uvec4(0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u)),
    Points(uvec4(0x1E00FF00u, 0x0800FF00u, 0x0000FF00u, 0x00007F00u),
        uvec4(0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u)));

vec2 partMiddle(int part) {
    float phi = float(part - 1) * (kPi / 3.0);
    return part == 0 ? vec2(0.0) : 0.7 * vec2(cos(phi), sin(phi));
}
