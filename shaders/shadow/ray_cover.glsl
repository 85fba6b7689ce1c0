// What a shape covers of a light's disc whose outline is not known: a solid that only estimates its distance, or a
// patch. By rays, one to a point of each of the disc's seven parts that varies from pixel to pixel. Where two opposite
// ones agree the others are taken to do so, too.
//
// Error   a Mandelbulb: .03 of the disc on average (RMSE), as noise (docs/shadows.md); a part the two miss is missed
// Why     an estimate tells the way past a solid too short, and a march along a cone that grazes one takes many steps
//         for an answer that is wrong; rays through the solid's ball need few
#include "shadow/pixel_shift.glsl"

// Two opposite parts first.
int partInTurn(int i) { return i < 2 ? 1 + 3 * i : (i == 2 ? 0 : (i < 5 ? i - 1 : i)); }

#for Shape in CASTERS
#if $SHAPE_RAY_COVER
bool hides$Shape(int index, ShadowQuery query, LightCone cone, vec2 q) {
    vec3 along = vec3(cone.slope * q, 1.0);
    float secant = length(along);
    Ray ray = query.ray;
    ray.direction = cone.axes * along / secant;
    if (ray.self >= 0 && dot(ray.direction, query.normal) <= 0.0) return false; // the horizon hides it already
    float t = cone.distance * secant;
    return meets$Shape(index, ray, t);
}

void hide$Shape(int index, ShadowQuery query, LightCone cone, inout Shade shade) {
    vec2 shift = pixelShift(floatBitsToUint(query.ray.direction.y));
    float phi = 2.0 * kPi * shift.x;
    vec2 off = 0.9 * kPartSlope * sqrt(shift.y) * vec2(cos(phi), sin(phi));
    Points points = Points(uvec4(0u), uvec4(0u));
    float hidden = 0.0;
    int asked = 0;
    for (int i = 0; i < 7; ++i) {
        if (i == 2 && hidden != 1.0) break;
        int part = partInTurn(i);
        vec2 q = partMiddle(part) + off;
        if (hides$Shape(index, query, cone, q / max(length(q), 1.0))) {
            hidden += 1.0;
            points = together(points, kParts[part]);
        }
        ++asked;
    }
    if (asked > 2) unite(shade, hidden / 7.0 * kPi, points);
    else if (hidden > 0.0) unite(shade, coverAll());
}
#endif
#endfor
