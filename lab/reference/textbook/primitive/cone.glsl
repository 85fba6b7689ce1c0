// Cone as textbooks have it: the baseline that shaders/primitive/cone.glsl is measured against.
//
// Source  ((p - apex) · v)² = cos² |p - apex|² as a quadratic in t, v being the axis from the apex down and cos that of
//         the half angle; roots kept between apex and base; then the base's plane
// Limits  b² - a c about the far origin: from some 100 radii on hits are lost; a ray along a side divides by nearly 0.
//         Which part of the surface was hit is guessed from the point. An epsilon keeps rays off their own start; side
//         is ignored. No texture coordinates
struct Cone {
    vec3 apex;
    float radius;
    vec3 down; // unit
    float height;
};

Cone loadCone(int at) {
    vec4 base = sceneTexel(at);
    vec3 apex = sceneTexel(at + 1).xyz;
    return Cone(apex, base.w, normalize(base.xyz - apex), length(base.xyz - apex));
}

void coneSideRoot(Cone cone, float hit, float o, float d, float least, inout float t) {
    float below = o + hit * d;
    if (hit > least && hit < t && below >= 0.0 && below <= cone.height) t = hit;
}

bool intersectCone(Cone cone, Ray ray, float side, inout float t) {
    vec3 o = ray.origin - cone.apex;
    vec3 d = ray.direction;
    float oDown = dot(o, cone.down);
    float dDown = dot(d, cone.down);
    float cos2 = cone.height * cone.height / (cone.height * cone.height + cone.radius * cone.radius);
    float least = max(ray.tMin, 1e-4);
    float before = t;
    float a = dDown * dDown - cos2 * dot(d, d);
    float b = dDown * oDown - cos2 * dot(o, d);
    float c = oDown * oDown - cos2 * dot(o, o);
    float discriminant = b * b - a * c;
    if (discriminant >= 0.0 && abs(a) > 1e-12) {
        float root = sqrt(discriminant);
        coneSideRoot(cone, (-b - root) / a, oDown, dDown, least, t);
        coneSideRoot(cone, (-b + root) / a, oDown, dDown, least, t);
    }
    if (abs(dDown) > 1e-6) {
        float hit = (cone.height - oDown) / dDown;
        vec3 across = o + hit * d - cone.height * cone.down;
        if (hit > least && hit < t && dot(across, across) <= cone.radius * cone.radius) t = hit;
    }
    return t < before;
}

Surface surfaceCone(Cone cone, Ray ray, float t) {
    vec3 point = ray.origin + t * ray.direction;
    vec3 p = point - cone.apex;
    float below = dot(p, cone.down);
    vec3 across = p - below * cone.down;
    float away = length(across);
    vec2 slope = normalize(vec2(cone.height, cone.radius)); // of the side's normal: outward, and towards the apex
    float fromSide = abs(slope.x * away - slope.y * below);
    if (abs(cone.height - below) < fromSide) return bareSurface(point, cone.down, 0.0);
    vec3 outward = across / max(away, 1e-30);
    return bareSurface(point, slope.x * outward - slope.y * cone.down, slope.x / max(away, 1e-6 * cone.radius));
}
