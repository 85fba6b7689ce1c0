// Ellipsoid as textbooks have it: the baseline that shaders/primitive/ellipsoid.glsl is measured against.
//
// Source  the ray scaled to the unit sphere's space, then |o + t d|² = 1 as a quadratic in t
// Limits  b² - a c about the far origin: from 1000 radii on hits are lost, of thin ones earlier. An epsilon keeps rays
//         off their own start; side is ignored. No texture coordinates

struct Ellipsoid {
    vec3 center;
    vec3 radii;
    mat3 axes;
};

Ellipsoid loadEllipsoid(int at) {
    mat3 axes = mat3(sceneTexel(at + 2).xyz, sceneTexel(at + 3).xyz, sceneTexel(at + 4).xyz);
    return Ellipsoid(sceneTexel(at).xyz, sceneTexel(at + 1).xyz, axes);
}

bool intersectEllipsoid(Ellipsoid ellipsoid, Ray ray, float side, inout float t) {
    vec3 o = ((ray.origin - ellipsoid.center) * ellipsoid.axes) / ellipsoid.radii;
    vec3 d = (ray.direction * ellipsoid.axes) / ellipsoid.radii;
    float a = dot(d, d);
    float b = dot(o, d);
    float discriminant = b * b - a * (dot(o, o) - 1.0);
    if (discriminant < 0.0) return false;
    float least = max(ray.tMin, 1e-4);
    float root = sqrt(discriminant);
    float hit = (-b - root) / a;
    if (hit <= least) hit = (-b + root) / a;
    if (!(hit > least && hit < t)) return false;
    t = hit;
    return true;
}

Surface surfaceEllipsoid(Ellipsoid ellipsoid, Ray ray, float t) {
    vec3 point = ray.origin + t * ray.direction;
    vec3 local = (point - ellipsoid.center) * ellipsoid.axes;
    return bareSurface(point, normalize(ellipsoid.axes * (local / (ellipsoid.radii * ellipsoid.radii))), 0.0);
}
