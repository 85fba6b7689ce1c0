// The middle of the box about all triangles of the scene; with CACHED_LOADS cacheLoads() reads it
// (software/cached_loads.glsl).
#if CACHED_LOADS
vec3 cachedMiddleOfTriangles;
vec3 middleOfTriangles() { return cachedMiddleOfTriangles; }
#else
vec3 middleOfTriangles() { return loadMiddleOfTriangles(); }
#endif
