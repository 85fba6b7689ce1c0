// Cylinder as textbooks have it: the baseline that shaders/primitive/cylinder.glsl is measured against.
//
// Source  x² = r² as a quadratic in t, x being the part of o + t d across the axis, then the planes of the two ends
// Limits  b² - a c about the far origin: from 1000 radii on hits are lost; a ray along the axis divides by nearly 0.
//         Which part of the surface was hit is guessed from the point. An epsilon keeps rays off their own start; side
//         is ignored. No texture coordinates
struct Cylinder {
    vec3 from;
    float radius;
    vec3 along; // unit
    float height;
};

Cylinder loadCylinder(int at) {
    vec4 a = sceneTexel(at);
    vec3 reach = sceneTexel(at + 1).xyz - a.xyz;
    return Cylinder(a.xyz, a.w, normalize(reach), length(reach));
}

// Takes a root of the wall where it lies between the ends, one of an end's plane where it lies within the radius.
void cylinderWall(Cylinder cylinder, float hit, float o, float d, float least, inout float t) {
    float height = o + hit * d;
    if (hit > least && hit < t && height >= 0.0 && height <= cylinder.height) t = hit;
}

void cylinderEnd(Cylinder cylinder, float hit, vec3 o, vec3 d, float least, inout float t) {
    vec3 across = o + hit * d;
    if (hit > least && hit < t && dot(across, across) <= cylinder.radius * cylinder.radius) t = hit;
}

bool intersectCylinder(Cylinder cylinder, Ray ray, float side, inout float t) {
    vec3 o = ray.origin - cylinder.from;
    float oAlong = dot(o, cylinder.along);
    float dAlong = dot(ray.direction, cylinder.along);
    vec3 oAcross = o - oAlong * cylinder.along;
    vec3 dAcross = ray.direction - dAlong * cylinder.along;
    float least = max(ray.tMin, 1e-4);
    float before = t;
    float a = dot(dAcross, dAcross);
    float b = dot(oAcross, dAcross);
    float c = dot(oAcross, oAcross) - cylinder.radius * cylinder.radius;
    float discriminant = b * b - a * c;
    if (discriminant >= 0.0 && a > 1e-12) {
        float root = sqrt(discriminant);
        cylinderWall(cylinder, (-b - root) / a, oAlong, dAlong, least, t);
        cylinderWall(cylinder, (-b + root) / a, oAlong, dAlong, least, t);
    }
    if (abs(dAlong) > 1e-6) {
        cylinderEnd(cylinder, -oAlong / dAlong, oAcross, dAcross, least, t);
        cylinderEnd(cylinder, (cylinder.height - oAlong) / dAlong, oAcross, dAcross, least, t);
    }
    return t < before;
}

Surface surfaceCylinder(Cylinder cylinder, Ray ray, float t) {
    vec3 point = ray.origin + t * ray.direction;
    vec3 p = point - cylinder.from;
    float height = dot(p, cylinder.along);
    vec3 across = p - height * cylinder.along;
    float away = length(across);
    float fromEnd = min(abs(height), abs(cylinder.height - height));
    if (fromEnd >= abs(cylinder.radius - away)) return bareSurface(point, across / away, 1.0 / cylinder.radius);
    return bareSurface(point, 2.0 * height < cylinder.height ? -cylinder.along : cylinder.along, 0.0);
}
