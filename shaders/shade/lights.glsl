// Lights, and how much of one reaches a surface point.
//
// radius     of the sphere that shines; 0: a point
// lightFraction  the share of the light's disc that is seen from the surface, in [0, 1]: no cosine, no material. `width` is
//                what a pixel covers of the surface there, in scene units
struct Light {
    vec3 position;
    float radius;
    vec3 color;
};

Light loadLight(int index) {
    int at = kLightBase + index * 2;
    vec4 place = sceneTexel(at);
    return Light(place.xyz, frame.options.z < 0.0 ? place.w : frame.options.z, sceneTexel(at + 1).rgb);
}

#if SHADOWS
#include "shadow/beam.glsl"
#for Model in SHADOW_MODEL
#include "shadow/$model.glsl"
#endfor
#endif

float lightFraction(Surface surface, int self, Light light, float width) {
#if SHADOWS
    Beam beam = beamTo(surface, self, light, width);
    return beam.distance > 0.0 ? visibility(beam) : 1.0;
#else
    return 1.0;
#endif
}
