// Checker: two colours in turn on squares of a surface's texture coordinates, 1 / scale wide; the square from uv = 0 on
// has the first.
//
// checkerAt  colour of material `index` there, averaged over the box about what the ray cone, `width` wide, covers of
//            the surface; white where the material has no checker
// Error      within a square 2e-4; its edges are at least a thousandth of a square wide
//            (tests/shader/light_kinds_test.cpp)
// Source     I. Quilez, Filtering the checkerboard pattern; the box encloses the ellipse in which the surface cuts the
//            ray cone

// The integral of the wave of period 2 that is 1 up to 1 and then -1.
vec2 squareWaveIntegral(vec2 x) { return 1.0 - abs(2.0 * fract(0.5 * x) - 1.0); }

vec3 checkerAt(int index, Surface surface, vec3 direction, float cosine, float width) {
    int at = kCheckerBase + index * 2;
    vec4 first = sceneTexel(at);
    vec4 second = sceneTexel(at + 1);
    vec2 scale = vec2(first.a, second.a);
    vec2 slant = vec2(dot(direction, surface.tangent), dot(direction, cross(surface.normal, surface.tangent))) / cosine;
    vec2 box = max(width * surface.uvPerUnit * abs(scale) * sqrt(1.0 + slant * slant), vec2(1e-3));
    vec2 low = 2.0 * fract(0.5 * surface.uv * scale) - 0.5 * box;
    vec2 mean = (squareWaveIntegral(low + box) - squareWaveIntegral(low)) / box;
    return second.rgb + (first.rgb - second.rgb) * (0.5 + 0.5 * mean.x * mean.y);
}
