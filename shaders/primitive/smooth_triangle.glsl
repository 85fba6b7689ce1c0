// SmoothTriangle: a triangle of a mesh, whose corners have normals and image coordinates of their own.
//
// ballSmoothTriangle, distanceSmoothTriangle, intersectSmoothTriangle, coverSmoothTriangle   a triangle's
// surfaceSmoothTriangle  a triangle's, its normal as well; uv, and the normal that it leans to, by the weights of the
//                        corners
// Error                  those of a triangle; the normal leaned to and uv 8 roundings (tests/shader/mesh_test.cpp)
// Limits                 those of a triangle; corner normals are unit and on one side of it
#include "primitive/triangle.glsl"

struct SmoothTriangle {
    Triangle face;
    int at; // of its corners: three normals with u, then the three v
};

SmoothTriangle loadSmoothTriangle(int at) { return SmoothTriangle(loadTriangle(at), at + 3); }

vec4 ballSmoothTriangle(SmoothTriangle triangle) { return ballTriangle(triangle.face); }

#if DISTANCES
vec4 distanceSmoothTriangle(SmoothTriangle triangle, vec3 p, vec3 from) {
    return distanceTriangle(triangle.face, p, from);
}
#endif

bool intersectSmoothTriangle(SmoothTriangle triangle, Ray ray, float side, inout float t) {
    return intersectTriangle(triangle.face, ray, side, t);
}

Surface surfaceSmoothTriangle(SmoothTriangle triangle, Ray ray, float t) {
    NearRay near;
    vec3 weights;
    float scaledS;
    float sum = weigh(triangle.face, ray, near, weights, scaledS);
    weights = sum == 0.0 ? vec3(1.0, 0.0, 0.0) : weights / sum;
    vec3 ab = triangle.face.b - triangle.face.a;
    vec3 ac = triangle.face.c - triangle.face.a;
    vec3 across = cross(ab, ac);
    float twiceArea = length(across);
    Surface surface = bareSurface(triangle.face.a + weights.y * ab + weights.z * ac, across / twiceArea, 0.0);
    vec4 a = sceneTexel(triangle.at);
    vec4 b = sceneTexel(triangle.at + 1);
    vec4 c = sceneTexel(triangle.at + 2);
    surface.lean = normalize(weights.x * a.xyz + weights.y * b.xyz + weights.z * c.xyz) - surface.normal;
#if SMOOTH_TRIANGLE_IMAGES
    vec3 u = vec3(a.w, b.w, c.w);
    vec3 v = sceneTexel(triangle.at + 3).xyz;
    surface.uv = vec2(dot(weights, u), dot(weights, v));
    vec2 du = vec2(u.y - u.x, u.z - u.x);
    vec2 dv = vec2(v.y - v.x, v.z - v.x);
    float turn = du.x * dv.y - du.y * dv.x; // of the image on the triangle, as an area
    surface.uvPerUnit = vec2(sqrt(abs(turn) / twiceArea));
    vec3 along = (turn < 0.0 ? -1.0 : 1.0) * (dv.y * ab - dv.x * ac);
    float size = length(along);
    surface.tangent = size > 0.0 ? along / size : ab / length(ab);
#endif
    return surface;
}

#if COVERS
Cover coverSmoothTriangle(SmoothTriangle triangle, LightCone cone) { return coverTriangle(triangle.face, cone); }
#endif
