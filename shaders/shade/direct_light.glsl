// What lights add at a point, light by light: first all that could arrive, then which lights are seen.
//
// directLightAt  what each light adds to the picture where nothing is in its way
// nextLight      the next light that counts, whichever that is: on wide SIMD neighbours wait for each other's shadow
//                rays
// throughput     of this surface to the pixel: a light that adds less than the threshold needs no shadow ray
// Registers      with this known what the material is holds none any more while shadow rays run. Written out light by
//                light: what is indexed lies in memory, and SwiftShader unrolls no loop
#include "ray/bits.glsl"
#include "shade/lights.glsl"
#include "shade/blinn_phong.glsl"

struct DirectLight {
#for Light in LIGHT_NUMBERS
    vec3 added$Light;
#endfor
    uint counting; // the lights that add something, a bit each
};

DirectLight directLightAt(ShadingPoint at, vec3 toEye, vec3 throughput) {
    DirectLight direct;
    direct.counting = 0u;
    vec3 albedo = at.material.diffuse * at.paint.rgb;
    float least = max(frame.threshold, 1e-30);
#for Light in LIGHT_NUMBERS
    direct.added$Light = throughput * reflectedLight(loadLight($Light), at, albedo, toEye);
    direct.counting |= largest(direct.added$Light) >= least ? 1u << $Lightu : 0u;
#endfor
    return direct;
}

int nextLight(inout DirectLight direct, out vec3 added) {
    int next = lowestBit(direct.counting);
    direct.counting &= direct.counting - 1u;
    added = vec3(0.0);
#for Light in LIGHT_NUMBERS
    added = next == $Light ? direct.added$Light : added;
#endfor
    return next;
}
