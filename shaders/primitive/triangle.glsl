// Triangle: three vertices; the normal follows their winding (counter-clockwise seen from its tip).
//
// ballTriangle       about the middle of the vertices
// distanceTriangle   gradient and distance, without a sign: a triangle has no inside; on it the normal
// intersectTriangle  t in (ray.tMin, t); watertight: a ray through a shared edge or vertex hits at least one of the
//                    triangles that share it
// surfaceTriangle    the point from its barycentric weights: exact to the vertices' own rounding; uv = weights of b and
//                    c
// Error              no leak through shared edges; band 2^-22 of the extent of all triangles, ray 1.5 ulp times a
//                    sliver's size over its height, point 2 and normal 1 roundings, as docs/numerics.md names them
//                    (tests/shader/intersect_test.cpp); distance 2.5 roundings, gradient 3, times a sliver's size over
//                    its height (tests/shader/distance_test.cpp; measured 2.0 and 2.1)
// Source             S. Woop, C. Benthin, I. Wald, Watertight Ray/Triangle Intersection, JCGT 2(1) 2013; no edge
//                    function is contracted to fused multiply-add, which would tell the two triangles of an edge apart.
//                    The ray is re-centred on the middle of all triangles, one point for all of them: they keep seeing
//                    one and the same ray (docs/numerics.md)
// Limits             not degenerate
struct Triangle {
    vec3 a, b, c;
};

Triangle loadTriangle(int at) {
    return Triangle(sceneTexel(at).xyz, sceneTexel(at + 1).xyz, sceneTexel(at + 2).xyz);
}

vec4 ballTriangle(Triangle triangle) {
    vec3 middle = (triangle.a + triangle.b + triangle.c) / 3.0;
    float reach = max(max(distance(middle, triangle.a), distance(middle, triangle.b)), distance(middle, triangle.c));
    return vec4(middle, reach);
}

#if DISTANCES
#include "sdf/safe_direction.glsl"

vec4 distanceTriangle(Triangle triangle, vec3 p, vec3 from) {
    vec3 ab = triangle.b - triangle.a;
    vec3 bc = triangle.c - triangle.b;
    vec3 ca = triangle.a - triangle.c;
    vec3 height = (dot(ca, ab) / dot(ab, ab)) * ab - ca; // of c over ab: rounding turns a sliver about ab only
    vec3 normal = normalize(cross(ab, height));
    float above = dot(p - triangle.a, normal);
    vec3 offA = (p - triangle.a) - above * normal; // in the plane
    vec3 offB = offA - ab;
    vec3 offC = offA + ca;
    vec3 beside = vec3(dot(cross(normal, ab), offA), dot(cross(normal, bc), offB), dot(cross(normal, ca), offC));
    bool over = all(greaterThanEqual(beside, vec3(0.0)));
    // What is nearest follows from signs and parts of edges: squares of lengths would drown the triangle from far away.
    vec3 part = vec3(dot(offA, ab) / dot(ab, ab), dot(offB, bc) / dot(bc, bc), dot(offC, ca) / dot(ca, ca));
    vec3 facing = vec3(lessThan(beside, vec3(0.0))) * vec3(greaterThan(part, vec3(0.0)))
        * vec3(lessThan(part, vec3(1.0)));
    vec3 offVertex = part.x < 0.5 ? (part.z < 0.5 ? offC : offA) : (part.y < 0.5 ? offB : offC);
    vec3 offEdge = facing.x > 0.0 ? offA - part.x * ab : (facing.y > 0.0 ? offB - part.y * bc : offC - part.z * ca);
    vec3 offRim = facing == vec3(0.0) ? offVertex : offEdge;
    vec3 offset = above * normal + (over ? vec3(0.0) : offRim);
    float least = length(offset);
    return vec4(safeDirection(offset, least, normal), least);
}
#endif

// Rays meet the scene's own triangles; those in solids are told by their distance only.
#if TRIANGLES || SMOOTH

// Of the box about all triangles of the scene: their texels carry it along.
vec3 middleOfTriangles() {
#if TRIANGLES
    return vec3(sceneTexel(kTriangleBase).w, sceneTexel(kTriangleBase + 1).w, sceneTexel(kTriangleBase + 2).w);
#else
    const int at = kSmoothTriangleBase;
    return vec3(sceneTexel(at).w, sceneTexel(at + 1).w, sceneTexel(at + 2).w);
#endif
}

// How points are seen along a ray: along the axis where its direction is largest, and across it.
struct Shear {
    vec3 axis;  // 1 along it
    vec2 slope; // of the direction, across
    float unit; // the direction along it
};

Shear shearAlong(vec3 d) {
    vec3 size = abs(d);
    bool alongX = size.x > size.y && size.x > size.z;
    bool alongY = size.y > size.z;
    vec3 axis = alongX ? vec3(1.0, 0.0, 0.0) : (alongY ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0));
    float unit = dot(d, axis);
    return Shear(axis, vec2(dot(d, axis.zxy), dot(d, axis.yzx)) / unit, unit);
}

// A point relative to the ray's origin.
vec3 sheared(vec3 p, Shear shear) {
    float along = dot(p, shear.axis);
    return vec3(vec2(dot(p, shear.axis.zxy), dot(p, shear.axis.yzx)) - along * shear.slope, along / shear.unit);
}

// Weights of a, b, c times the returned sum, and the s of the re-centred ray times it; the sum is 0 where the ray
// misses.
float weigh(Triangle triangle, Ray ray, out NearRay near, out vec3 weights, out float scaledS) {
    vec3 middle = middleOfTriangles();
    near = recentre(ray.origin, middle, ray.direction);
    Shear shear = shearAlong(ray.direction);
    vec3 a = sheared((triangle.a - middle) - near.origin, shear);
    vec3 b = sheared((triangle.b - middle) - near.origin, shear);
    vec3 c = sheared((triangle.c - middle) - near.origin, shear);
    // Twice the signed areas of the origin with each edge. Opaque products are rounded before they are subtracted: the
    // area is exactly negated where the vertices of an edge change places.
    weights = optimisationBarrier(vec3(c.x, a.x, b.x) * vec3(b.y, c.y, a.y))
        - optimisationBarrier(vec3(c.y, a.y, b.y) * vec3(b.x, c.x, a.x));
    scaledS = dot(weights, vec3(a.z, b.z, c.z));
    bool inside = all(greaterThanEqual(weights, vec3(0.0))) || all(lessThanEqual(weights, vec3(0.0)));
    return inside ? weights.x + weights.y + weights.z : 0.0;
}

bool intersectTriangle(Triangle triangle, Ray ray, float side, inout float t) {
    if (side != 0.0) return false;
    NearRay near;
    vec3 weights;
    float scaledS;
    float sum = weigh(triangle, ray, near, weights, scaledS);
    float hit = near.tHigh + (near.tLow + scaledS / sum);
    bool meets = sum != 0.0 && hit > ray.tMin && hit < t;
    t = meets ? hit : t;
    return meets;
}

Surface surfaceTriangle(Triangle triangle, Ray ray, float t) {
    NearRay near;
    vec3 weights;
    float scaledS;
    float sum = weigh(triangle, ray, near, weights, scaledS);
    vec2 bc = sum == 0.0 ? vec2(0.0) : weights.yz / sum;
    vec3 ab = triangle.b - triangle.a;
    vec3 ac = triangle.c - triangle.a;
    Surface surface = bareSurface(triangle.a + bc.x * ab + bc.y * ac, normalize(cross(ab, ac)), 0.0);
#if TRIANGLE_IMAGES
    surface.uv = bc;
    surface.uvPerUnit = vec2(inversesqrt(dot(ab, ab)), inversesqrt(dot(ac, ac)));
    surface.tangent = normalize(ab);
#endif
    return surface;
}

#endif

#if COVERS
#include "shadow/outline.glsl"

Cover coverTriangle(Triangle triangle, LightCone cone) {
    vec3 a = across(cone, triangle.a - cone.apex);
    vec3 b = across(cone, triangle.b - cone.apex);
    vec3 c = across(cone, triangle.c - cone.apex);
    Outline outline = startOutline(a);
    for (int i = 0; i < 3; ++i) edgeTo(outline, i == 0 ? b : (i == 1 ? c : a), 0.0);
    closeOutline(outline);
    return coverOf(outline);
}
#endif
