// What is read at fixed addresses, read once before all loops, for llvmpipe: it reads each value for every lane of its
// own, a lane at a time, though it be the same for all, in every iteration of a loop. A read that has been made before
// is not made again (0.8 of the instructions of `pro`). On a GPU such reads are free, and the values would hold
// registers all the way.
//
// preloads  the sum of what it reads: it has to be of use, or compilers leave the reads out
vec4 preload() {
    const int kMostLooped = 4; // of more a compiler keeps the loop: their addresses are fixed no longer
    vec4 sum = vec4(frame.threshold, frame.lightRadius, frame.depth, frame.light) + vec4(frame.zero);
#if GRADIENT
    for (int i = 0; i < 2; ++i) sum += sceneTexel(kGradientBase + i);
#elif !CUBEMAP && !PANORAMA
    sum += frame.background;
#endif
#if DISTANCES
    sum += vec4(frame.coneError, frame.shadowSteps, frame.marchSteps, frame.samples);
    sum.x += float(frame.firstSample);
#endif
#for Shape in SHAPES
#if $SHAPE_SEARCHED
#if $SHAPE_SEARCH == HIERARCHY
    for (int i = 0; i < 2; ++i) sum += sceneTexel(k$ShapeQuantisation + i);
#elif $SHAPE_SEARCH == GRID
    for (int i = 0; i < 2; ++i) sum += sceneTexel(k$ShapeGrid + i);
#else
    for (int i = k$ShapeLoose * k$ShapeTexels; i < k$ShapeCount * k$ShapeTexels; ++i) sum += sceneTexel(k$ShapeBase
        + i);
#endif
#if $SHAPE_LATTICE
    for (int i = 0; i < 2; ++i) sum += sceneTexel(k$ShapeLattice + i);
#endif
#else
    for (int i = 0; i < min(k$ShapeCount, kMostLooped) * k$ShapeTexels; ++i) sum += sceneTexel(k$ShapeBase + i);
#endif
#endfor
#for Shape in UNCOMMON
    for (int i = 0; i < k$ShapeCount * k$ShapeTexels; ++i) sum += sceneTexel(k$ShapeBase + i);
#endfor
#if LIGHTS
    for (int i = 0; i < 2 * kLightCount; ++i) sum += sceneTexel(kLightBase + i);
#endif
#if GLOWS
    for (int i = 0; i < 2 * kGlowCount; ++i) sum += sceneTexel(kGlowBase + i);
#endif
    return sum;
}
