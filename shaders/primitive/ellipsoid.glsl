// Ellipsoid: the points center + axes * (radii * u), |u| = 1.
//
// ballEllipsoid       about the centre
// distanceEllipsoid   gradient and signed distance; at the centre along the shortest radius
// intersectEllipsoid  nearest t in (ray.tMin, t); from inside the far side
// surfaceEllipsoid    point and normal of the u that the ray meets; uv = longitude and latitude of u, as of a sphere
// Error               band 2^-22 size, ray 1.5 ulp, point 2 and normal 2 roundings, as docs/numerics.md names them
//                     (tests/shader/intersect_test.cpp); distance 3 roundings, gradient 4
//                     (tests/shader/distance_test.cpp; measured 2.5 and 2.7)
// Source              ray re-centred on the centre (ray/split.glsl), then the unit sphere in lengths of the radii. The
//                     distance: D. Eberly, Distance from a Point to an Ellipsoid, 2013, solved for 1 / |u| as the
//                     Hessian of a trust region is, nearly a straight line (J. Moré, D. Sorensen, 1983)
// Limits              radii > 0, the longest at most 1e4 times the shortest
#include "primitive/convex.glsl"

struct Ellipsoid {
    vec3 center;
    vec3 radii;
    mat3 axes; // as columns: axes * v rotates v, v * axes rotates it back
};

Ellipsoid loadEllipsoid(int at) {
    mat3 axes = mat3(sceneTexel(at + 2).xyz, sceneTexel(at + 3).xyz, sceneTexel(at + 4).xyz);
    return Ellipsoid(sceneTexel(at).xyz, sceneTexel(at + 1).xyz, axes);
}

vec4 ballEllipsoid(Ellipsoid ellipsoid) {
    return vec4(ellipsoid.center, max(ellipsoid.radii.x, max(ellipsoid.radii.y, ellipsoid.radii.z)));
}

// A vector from the centre in lengths of the radii, and back.
vec3 inRadii(Ellipsoid ellipsoid, vec3 v) { return (v * ellipsoid.axes) / ellipsoid.radii; }
// The same with the products of 12-bit halves exact: half of what rotating rounds.
vec3 inRadiiExactly(Ellipsoid ellipsoid, vec3 v) {
    vec3 high = high12(v);
    vec3 low = optimisationBarrier(v - high);
    mat3 axes = ellipsoid.axes;
    mat3 coarse = mat3(high12(axes[0]), high12(axes[1]), high12(axes[2]));
    mat3 fine = mat3(optimisationBarrier(axes[0] - coarse[0]), optimisationBarrier(axes[1] - coarse[1]),
        optimisationBarrier(axes[2] - coarse[2]));
    return (high * coarse + (high * fine + low * axes)) / ellipsoid.radii;
}
vec3 fromRadii(Ellipsoid ellipsoid, vec3 u) { return ellipsoid.axes * (ellipsoid.radii * u); }

#if DISTANCES
// The foot of p is radii² p / (radii² + s) for the s that puts it onto the surface. All is told from the shortest
// radius' own pole, s = -least², where nothing cancels. The first s is too small, and no step passes the right one.
vec4 distanceEllipsoid(Ellipsoid ellipsoid, vec3 p, vec3 from) {
    vec3 radii = ellipsoid.radii;
    vec3 local = (p - ellipsoid.center) * ellipsoid.axes;
    float least = min(radii.x, min(radii.y, radii.z));
    vec3 scaled = radii * max(abs(local), 6e-8 * least); // off the planes of symmetry by less than rounding
    vec3 gap = (radii - least) * (radii + least);
    vec3 start = scaled - gap;
    float fromPole = max(start.x, max(start.y, start.z));
    vec3 u = scaled / (fromPole + gap);
    for (int i = 0; i < 24; ++i) {
        float square = dot(u, u);
        if (square < 1.000001) break;
        fromPole += (sqrt(square) - 1.0) * square / dot(u, u / (fromPole + gap));
        u = scaled / (fromPole + gap);
    }
    u = normalize(u);
    vec3 normal = normalize(u / radii);
    vec3 side = 1.0 - 2.0 * vec3(lessThan(local, vec3(0.0)));
    return vec4(ellipsoid.axes * (side * normal), dot(abs(local) - radii * u, normal));
}
#endif

// The interval of the ray p + s d, both in lengths of the radii, inside: about its middle, each end put back once by
// Newton.
vec2 ellipsoidSpan(vec3 p, vec3 d) {
    float square = dot(d, d);
    float middle = -dot(p, d) / square;
    vec3 nearest = p + middle * d;
    float radial = length(nearest);
    float halfSquare = (1.0 - radial) * (1.0 + radial) / square;
    if (!(halfSquare >= 0.0)) return kNever;
    vec2 s = sqrt(halfSquare) * vec2(-1.0, 1.0);
    float lean = dot(nearest, d);
    vec2 off = (dot(nearest, nearest) - 1.0) + s * (s * square + 2.0 * lean);
    vec2 slope = 2.0 * (lean + s * square);
    s -= halfSquare * square > 1e-6 ? off / slope : vec2(0.0); // at a tangent there is no slope
    return middle + s;
}

bool intersectEllipsoid(Ellipsoid ellipsoid, Ray ray, float side, inout float t) {
    if (side > 0.0) return false; // convex: what leaves it never comes back
    if (side == 0.0 && passesBy(ray, ballEllipsoid(ellipsoid))) return false;
    NearRay near = recentre(ray.origin, ellipsoid.center, ray.direction);
    vec2 span = ellipsoidSpan(inRadiiExactly(ellipsoid, near.origin), inRadiiExactly(ellipsoid, ray.direction));
    return meetConvex(near, span, ray, side, t);
}

Surface surfaceEllipsoid(Ellipsoid ellipsoid, Ray ray, float t) {
    NearRay near = recentre(ray.origin, ellipsoid.center, ray.direction);
    vec3 p = inRadiiExactly(ellipsoid, near.origin);
    vec3 d = inRadiiExactly(ellipsoid, ray.direction);
    float end;
    vec3 u = p + spanEnd(near, ellipsoidSpan(p, d), t, end) * d;
    // Back onto the surface across itself: a step along u would lead along the surface where a radius is short.
    vec3 gradient = u / ellipsoid.radii;
    u = normalize(u - 0.5 * (dot(u, u) - 1.0) / dot(gradient, gradient) * gradient / ellipsoid.radii);
    gradient = u / ellipsoid.radii;
    float steep = length(gradient);
    vec3 normal = gradient / steep;
    vec3 bends = 1.0 / (ellipsoid.radii * ellipsoid.radii);
    float bend = 0.5 * dot(1.0 - normal * normal, bends) / steep; // the mean of both principal curvatures
    Surface surface = bareSurface(ellipsoid.center + fromRadii(ellipsoid, u), ellipsoid.axes * normal, bend);
#if ELLIPSOID_IMAGES
    const float kPi = 3.14159265358979;
    surface.uv = vec2(0.5 + atan(-u.z, u.x) / (2.0 * kPi), acos(clamp(u.y, -1.0, 1.0)) / kPi);
    float equator = length(u.xz);
    vec3 east = equator > 1e-6 ? vec3(u.z, 0.0, -u.x) / equator : vec3(1.0, 0.0, 0.0);
    vec3 along = ellipsoid.radii * east;
    vec3 down = ellipsoid.radii * cross(east, u);
    surface.uvPerUnit = vec2(0.5 / length(along), 1.0 / length(down)) / kPi;
    surface.tangent = ellipsoid.axes * normalize(along);
#endif
    return surface;
}

#if COVERS
#include "sdf/safe_direction.glsl"
#include "shadow/outline.glsl"

// Its outline is where the apex' polar plane cuts it: a circle of the unit sphere, an ellipse in space.
Cover coverEllipsoid(Ellipsoid ellipsoid, LightCone cone) {
    vec3 apex = inRadii(ellipsoid, cone.apex - ellipsoid.center);
    float radial = length(apex);
    if (!(radial > 1.0)) return coverFromInside();
    vec3 towards = apex / radial;
    float height = 1.0 / radial;
    float radius = sqrt((1.0 - height) * (1.0 + height));
    vec3 first = radius * anyAcross(towards);
    vec3 middle = (ellipsoid.center - cone.apex) + fromRadii(ellipsoid, height * towards);
    Rim rim = Rim(across(cone, middle), across(cone, fromRadii(ellipsoid, first)),
        across(cone, fromRadii(ellipsoid, cross(towards, first))), 0.0, 2.0 * kPi);
    return coverRims(rim, rim, true);
}
#endif
