// Sphere as textbooks have it: the baseline that shaders/primitive/sphere.glsl is measured against.
//
// Source  |o + t d - c|² = r² as a quadratic in t with b² - a c about the far origin
// Limits  b² and a c are of the size of the distance squared, their difference of the radius': from 1000 radii on hits
//         are lost. An epsilon keeps rays off their own start, wherever that lies; side is ignored
struct Sphere {
    vec3 center;
    float radius;
};

Sphere loadSphere(int at) {
    vec4 a = sceneTexel(at);
    return Sphere(a.xyz, a.w);
}

bool intersectSphere(Sphere sphere, Ray ray, float side, inout float t) {
    vec3 o = ray.origin - sphere.center;
    float a = dot(ray.direction, ray.direction);
    float b = dot(o, ray.direction);
    float c = dot(o, o) - sphere.radius * sphere.radius;
    float discriminant = b * b - a * c;
    if (discriminant < 0.0) return false;
    float least = max(ray.tMin, 1e-4);
    float root = sqrt(discriminant);
    float hit = (-b - root) / a;
    if (hit <= least) hit = (-b + root) / a;
    if (!(hit > least && hit < t)) return false;
    t = hit;
    return true;
}

Surface surfaceSphere(Sphere sphere, Ray ray, float t) {
    vec3 point = ray.origin + t * ray.direction;
    vec3 normal = normalize(point - sphere.center);
    Surface surface = bareSurface(point, normal, 1.0 / sphere.radius);
#if IMAGES
    const float kPi = 3.14159265358979;
    surface.uv = vec2(0.5 + atan(-normal.z, normal.x) / (2.0 * kPi), acos(clamp(normal.y, -1.0, 1.0)) / kPi);
    surface.uvPerUnit = vec2(0.5, 1.0) / (kPi * sphere.radius);
    float equator = length(normal.xz);
    surface.tangent = equator > 1e-6 ? vec3(normal.z, 0.0, -normal.x) / equator : vec3(1.0, 0.0, 0.0);
#endif
    return surface;
}
