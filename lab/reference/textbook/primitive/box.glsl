// Box as textbooks have it: the baseline that shaders/primitive/box.glsl is measured against.
//
// Source  three slabs met at (±h - o) / d with the reciprocal of the direction (T. Kay, J. Kajiya, Ray Tracing Complex
//         Scenes, 1986)
// Limits  a ray within a face's plane makes 0 · inf; edges are off by the rounding of o · 1/d. The face is guessed from
//         the point. An epsilon keeps rays off their own start; side is ignored. No texture coordinates
struct Box {
    vec3 center;
    vec3 halfSize;
};

Box loadBox(int at) { return Box(sceneTexel(at).xyz, sceneTexel(at + 1).xyz); }

bool intersectBox(Box box, Ray ray, float side, inout float t) {
    vec3 inverse = 1.0 / ray.direction;
    vec3 a = (box.center - box.halfSize - ray.origin) * inverse;
    vec3 b = (box.center + box.halfSize - ray.origin) * inverse;
    vec3 low = min(a, b);
    vec3 high = max(a, b);
    float entry = max(low.x, max(low.y, low.z));
    float leave = min(high.x, min(high.y, high.z));
    float least = max(ray.tMin, 1e-4);
    float hit = entry > least ? entry : leave;
    if (!(entry <= leave && hit > least && hit < t)) return false;
    t = hit;
    return true;
}

Surface surfaceBox(Box box, Ray ray, float t) {
    vec3 point = ray.origin + t * ray.direction;
    vec3 p = (point - box.center) / box.halfSize;
    vec3 size = abs(p);
    vec3 normal = vec3(0.0, 0.0, sign(p.z));
    if (size.x > size.y && size.x > size.z) normal = vec3(sign(p.x), 0.0, 0.0);
    else if (size.y > size.z) normal = vec3(0.0, sign(p.y), 0.0);
    return bareSurface(point, normal, 0.0);
}
