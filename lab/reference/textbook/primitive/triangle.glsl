// Triangle as textbooks have it: the baseline that shaders/primitive/triangle.glsl is measured against.
//
// Source  T. Möller, B. Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997: Cramer's rule on
//         o + t d = (1 - u - v) a + u b + v c
// Limits  two triangles that share an edge round differently: about 1 in 10 rays exactly through an edge leaks.
//         An epsilon keeps rays off their own start; side is ignored. No texture coordinates
struct Triangle {
    vec3 a, b, c;
};

Triangle loadTriangle(int at) {
    return Triangle(sceneTexel(at).xyz, sceneTexel(at + 1).xyz, sceneTexel(at + 2).xyz);
}

// As ours: a fan of many triangles is searched alike, and only the intersectors differ.
vec4 ballTriangle(Triangle triangle) {
    vec3 middle = (triangle.a + triangle.b + triangle.c) / 3.0;
    return vec4(middle, max(max(distance(middle, triangle.a), distance(middle, triangle.b)),
        distance(middle, triangle.c)));
}

bool intersectTriangle(Triangle triangle, Ray ray, float side, inout float t) {
    vec3 ab = triangle.b - triangle.a;
    vec3 ac = triangle.c - triangle.a;
    vec3 across = cross(ray.direction, ac);
    float determinant = dot(ab, across);
    if (abs(determinant) < 1e-12) return false;
    float inverse = 1.0 / determinant;
    vec3 fromA = ray.origin - triangle.a;
    float u = dot(fromA, across) * inverse;
    if (u < 0.0 || u > 1.0) return false;
    vec3 turned = cross(fromA, ab);
    float v = dot(ray.direction, turned) * inverse;
    if (v < 0.0 || u + v > 1.0) return false;
    float hit = dot(ac, turned) * inverse;
    if (!(hit > max(ray.tMin, 1e-4) && hit < t)) return false;
    t = hit;
    return true;
}

Surface surfaceTriangle(Triangle triangle, Ray ray, float t) {
    vec3 normal = normalize(cross(triangle.b - triangle.a, triangle.c - triangle.a));
    return bareSurface(ray.origin + t * ray.direction, normal, 0.0);
}
