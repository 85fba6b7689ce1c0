// Adam: the mean gradient over the root of its mean square (D. Kingma, J. Ba, Adam, 2015).
#include "field/patch.glsl"

vec2 stepAgainst(vec2 g, inout vec2 mean, inout vec2 square, vec2 powers) {
    mean = mix(g, mean, bake.rates.y);
    square = mix(g * g, square, bake.rates.z);
    return mean / ((1.0 - powers.x) * (sqrt(square / (1.0 - powers.y)) + 1e-8));
}

#include "field/descents.glsl"
