// What the flat shapes share: where a ray meets a plane, and the surface there.
//
// meetPlane      t of the plane through `anchor`, or -1 where the ray lies in it or has it behind
// surfacePlanar  the point, put back onto the plane so that it is exact to its own coordinates; uv = in-plane coordinates
//                in scene units relative to the anchor: for a normal +y they are x and z
float meetPlane(vec3 anchor, vec3 normal, Ray ray) {
    float facing = dot(normal, ray.direction);
    if (facing == 0.0) return -1.0;
    return -dot(normal, ray.origin - anchor) / facing;
}

Surface surfacePlanar(vec3 anchor, vec3 normal, Ray ray, float t) {
    vec3 offset = (ray.origin - anchor) + t * ray.direction;
    offset -= dot(normal, offset) * normal;
    Surface surface = bareSurface(anchor + offset, normal, 0.0);
#if IMAGES
    // The world axis least along the normal, laid into the plane; +x wherever the normal is not mostly x.
    vec3 axis = abs(normal.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, -1.0);
    surface.tangent = normalize(axis - dot(axis, normal) * normal);
    vec3 bitangent = cross(surface.tangent, normal);
    surface.uv = vec2(dot(offset, surface.tangent), dot(offset, bitangent));
    surface.uvPerUnit = vec2(1.0);
#endif
    return surface;
}
