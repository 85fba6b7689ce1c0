// Capsule as textbooks have it: the baseline that shaders/primitive/capsule.glsl is measured against.
//
// Source  the wall as for the cylinder, x² = r² as a quadratic in t, kept between the ends; the two spheres as
//         quadratics, kept beyond them
// Limits  b² - a c about the far origin: from 1000 radii on hits are lost. An epsilon keeps rays off their own start;
//         side is ignored. No texture coordinates
struct Capsule {
    vec3 from;
    float radius;
    vec3 along; // unit
    float height;
};

Capsule loadCapsule(int at) {
    vec4 a = sceneTexel(at);
    vec3 reach = sceneTexel(at + 1).xyz - a.xyz;
    return Capsule(a.xyz, a.w, normalize(reach), length(reach));
}

void capsuleRoot(float hit, float o, float d, float low, float high, float least, inout float t) {
    float height = o + hit * d;
    if (hit > least && hit < t && height >= low && height <= high) t = hit;
}

// The roots of a t² + 2 b t + c where the height along the axis is between low and high.
void capsuleRoots(float a, float b, float c, float o, float d, float low, float high, float least, inout float t) {
    float discriminant = b * b - a * c;
    if (discriminant < 0.0 || a < 1e-12) return;
    float root = sqrt(discriminant);
    capsuleRoot((-b - root) / a, o, d, low, high, least, t);
    capsuleRoot((-b + root) / a, o, d, low, high, least, t);
}

bool intersectCapsule(Capsule capsule, Ray ray, float side, inout float t) {
    vec3 o = ray.origin - capsule.from;
    vec3 top = o - capsule.height * capsule.along;
    vec3 d = ray.direction;
    float oAlong = dot(o, capsule.along);
    float dAlong = dot(d, capsule.along);
    vec3 oAcross = o - oAlong * capsule.along;
    vec3 dAcross = d - dAlong * capsule.along;
    float r2 = capsule.radius * capsule.radius;
    float least = max(ray.tMin, 1e-4);
    float before = t;
    capsuleRoots(dot(dAcross, dAcross), dot(oAcross, dAcross), dot(oAcross, oAcross) - r2, oAlong, dAlong, 0.0,
        capsule.height,
                 least, t);
    capsuleRoots(dot(d, d), dot(o, d), dot(o, o) - r2, oAlong, dAlong, -1e30, 0.0, least, t);
    capsuleRoots(dot(d, d), dot(top, d), dot(top, top) - r2, oAlong, dAlong, capsule.height, 1e30, least, t);
    return t < before;
}

Surface surfaceCapsule(Capsule capsule, Ray ray, float t) {
    vec3 point = ray.origin + t * ray.direction;
    vec3 p = point - capsule.from;
    vec3 normal = normalize(p - clamp(dot(p, capsule.along), 0.0, capsule.height) * capsule.along);
    return bareSurface(point, normal, 1.0 / capsule.radius);
}
