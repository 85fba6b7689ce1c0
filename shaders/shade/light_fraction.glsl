// The fraction of a light's disc that is seen from a surface, in [0, 1]: no cosine, no material. `width` is what a
// pixel covers of the surface there, in scene units.
#if SHADOWS
#include "shadow/query.glsl"
#for Model in SHADOW_MODEL
#include "shadow/$model.glsl"
#endfor
#endif

float lightFraction(Surface surface, int self, Light light, float width) {
#if SHADOWS
    ShadowQuery query = shadowQueryTo(surface, self, light, width);
    return query.distance > 0.0 ? visibility(query) : 1.0;
#else
    return 1.0;
#endif
}
