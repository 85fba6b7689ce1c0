// AdaMax: the mean gradient over the greatest one of late (D. Kingma, J. Ba, Adam, 2015).
#include "field/patch.glsl"

vec2 stepAgainst(vec2 g, inout vec2 mean, inout vec2 greatest, vec2 powers) {
    mean = mix(g, mean, bake.rates.y);
    greatest = max(max(bake.rates.z * greatest, abs(g)), 1e-4);
    return mean / (greatest * (1.0 - powers.x));
}

#include "field/descents.glsl"
