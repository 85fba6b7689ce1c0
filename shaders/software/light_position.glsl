// Position of a light. With PRELOADS it is chosen among those that have been read already (software/preloads.glsl).
vec3 lightPosition(int index) {
#if PRELOADS
    vec3 position = vec3(0.0);
    for (int i = 0; i < kLightCount; ++i)
        if (i == index) position = loadLight(i).position;
    return position;
#else
    return loadLight(index).position;
#endif
}
