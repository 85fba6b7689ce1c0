// Marks this pixel as drawn in the coverage mask, where shader variants share a picture. software/tiles.glsl reads the
// mask.
#if COVERAGE_MASK
layout(location = 1) out vec4 outCovered;
#endif

void markCovered() {
#if COVERAGE_MASK
    outCovered = vec4(1.0);
#endif
}
