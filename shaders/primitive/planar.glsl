// What the flat shapes share: where a ray meets a plane, and the surface there.
//
// planeAhead     t of the plane through the point that the origin is relative to; beyond all numbers where the ray lies
//                in it
// surfacePlanar  the point at `offset` from the anchor, put back onto the plane; uv = in-plane coordinates in scene
//                units relative to the anchor: for a normal +y they are x and z
float planeAhead(vec3 toOrigin, vec3 normal, vec3 direction) {
    float facing = dot(normal, direction);
    return facing == 0.0 ? -3e38 : -dot(normal, toOrigin) / facing;
}

Surface surfacePlanar(vec3 anchor, vec3 normal, vec3 offset) {
    // Opaque: else compilers round what comes of it as it is used, and so differently in each program.
    offset = optimisationBarrier(offset - dot(normal, offset) * normal);
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
