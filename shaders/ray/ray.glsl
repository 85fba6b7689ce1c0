// A ray, and what is known of the surface point where it ends.
//
// A ray that leaves a surface names the object it starts on (`self`) and the side it travels on: that object's
// intersector then knows without an epsilon that the start itself is no hit. For all other objects hits nearer than
// `tMin` are rounding of the start; tMin scales with the start's coordinates.
const float kFar = 3e38; // where a ray ends that meets nothing

struct Ray {
    vec3 origin;
    vec3 direction; // unit
    float tMin;
    int self;       // object the ray starts on, as in nearestHit(); -1: none
    float side;     // +1 travels outside of self, -1 inside
};

// point      on the surface to the precision of the shape's own size, not of the distance from the eye
// normal     geometric, unit, outward (planar shapes: the side of the stated normal or winding)
// uv         texture coordinates, and uvPerUnit: how much of them one scene unit covers
// tangent    unit, towards +u; with the normal it gives the frame of normal maps
// curvature  1 / radius of the surface, 0 where it is flat; how much a reflected ray cone spreads
// lean       from the normal to that of the surface which a smooth triangle stands for
struct Surface {
    vec3 point;
    vec3 normal;
    vec2 uv;
    vec2 uvPerUnit;
    vec3 tangent;
    float curvature;
#if SMOOTH
    vec3 lean;
#endif
};

// A surface without a texture's frame: shapes add uv, uvPerUnit and tangent where objects of theirs show images.
Surface bareSurface(vec3 point, vec3 normal, float curvature) {
#if SMOOTH
    return Surface(point, normal, vec2(0.0), vec2(0.0), vec3(0.0), curvature, vec3(0.0));
#else
    return Surface(point, normal, vec2(0.0), vec2(0.0), vec3(0.0), curvature);
#endif
}

// +1 or -1 where the ray starts on object `object`, else 0.
float startSide(Ray ray, int object) { return object == ray.self ? ray.side : 0.0; }

// A ray from a point that is exact to a few roundings of its own coordinates.
Ray rayFrom(vec3 point, vec3 direction, int self, float side) {
    vec3 size = abs(point);
    float tMin = 4.8e-7 * (max(size.x, max(size.y, size.z)) + 1e-3); // 4 ulp of the largest coordinate
    return Ray(point, direction, tMin, self, side);
}
