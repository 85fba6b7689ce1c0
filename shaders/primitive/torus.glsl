// Torus: the points at distance `minor` from a circle of radius `major` about `center`, in the plane across `axis`.
//
// intersectTorus  nearest t in (ray.tMin, t)
// surfaceTorus    point and normal exact to a few ulp of major + minor; u runs around the axis, v around the tube, downward outside
// Error           decisions wrong only within 2^-22 (major + minor) of tangency; t: 1.4 ulp of the distance
// Source          ray re-centred exactly (ray/split.glsl). Along the ray g(s) = (|xy| - major)² + z² - minor² is concave on
//                 one interval about the axis and convex before and after it, so the nearest root lies in the first of three
//                 pieces where Newton, started at the end where it converges from one side, finds one: no root is missed
//                 and none invented (docs/numerics.md)
// Limits          axis unit; 0 < minor < major
struct Torus {
    vec3 center;
    float major;
    vec3 axis;
    float minor;
};

Torus loadTorus(int at) {
    vec4 a = sceneTexel(at);
    vec4 b = sceneTexel(at + 1);
    return Torus(a.xyz, a.w, b.xyz, b.w);
}

// Rows: two directions across the axis and the axis itself.
mat3 torusFrame(vec3 axis) {
    // Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1) 2017; exact for the axes x, y, z
    float s = axis.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + axis.z);
    float b = axis.x * axis.y * a;
    vec3 x = vec3(1.0 + s * axis.x * axis.x * a, s * b, -s * axis.x);
    vec3 y = vec3(b, s + axis.y * axis.y * a, -axis.y);
    return transpose(mat3(x, y, axis));
}

// g and half its derivative at p along d. The distance from the axis gets one refinement step: inversesqrt alone is too
// coarse on some GPUs.
vec2 tubeResidual(Torus torus, vec3 p, vec3 d) {
    float square = dot(p.xy, p.xy);
    float inverse = inversesqrt(max(square, 1e-30));
    float fromAxis = square * inverse;
    fromAxis += 0.5 * inverse * (square - fromAxis * fromAxis);
    float q = fromAxis - torus.major;
    return vec2(q * q + p.z * p.z - torus.minor * torus.minor, q * dot(p.xy, d.xy) * inverse + p.z * d.z);
}

// The stretch of the ray that can hold a hit: within the bounding sphere and the slab |z| <= minor; empty where x > y.
vec2 torusBounds(Torus torus, vec3 p, vec3 d) {
    const vec2 kNone = vec2(1.0, 0.0);
    float a = dot(d, d);
    float b = dot(p, d);
    float reach = (torus.major + torus.minor) * 1.0000005;
    float square = b * b - a * (dot(p, p) - reach * reach);
    if (square < 0.0) return kNone;
    float h = sqrt(square);
    vec2 bounds = vec2(-b - h, -b + h) / a;
    float slab = torus.minor + 4e-7 * (torus.major + torus.minor);
    if (abs(d.z) <= 1e-9) return abs(p.z) > slab ? kNone : bounds;
    vec2 z = (vec2(-slab, slab) - p.z) / d.z;
    return vec2(max(bounds.x, min(z.x, z.y)), min(bounds.y, max(z.x, z.y)));
}

// Where g is concave; empty (beyond all numbers) where it is convex throughout.
vec2 concaveStretch(Torus torus, vec3 p, vec3 d) {
    float across = max(dot(d.xy, d.xy), 1e-20);
    float moment = p.x * d.y - p.y * d.x; // the same all along the ray
    float root = pow(torus.major * moment * moment / dot(d, d), 1.0 / 3.0);
    float w = root * root * across - moment * moment;
    if (w < 0.0) return vec2(3e38);
    float middle = -dot(p.xy, d.xy) / across;
    float halfWidth = sqrt(w) / across + 1e-5 * torus.major;
    return vec2(middle - halfWidth, middle + halfWidth);
}

// First s in [from, to] where sign * g falls through 0, given the concave stretch; false where there is none.
// sign is +1 where the ray starts outside of the tube, -1 inside: inside the roles of convex and concave change places.
bool firstCrossing(Torus torus, vec3 p, vec3 d, float from, float to, vec2 concave, float sign, out float s) {
    const int kMaxSteps = 40; // 2.4 on average, 7 for grazing rays
    int piece = from < concave.x ? 0 : (from < concave.y ? 1 : 2);
    float low = from;
    float end = min(piece == 0 ? concave.x : (piece == 1 ? concave.y : to), to);
    bool forwards = (sign > 0.0) == (piece != 1); // g is convex here: Newton from the left end never oversteps the root
    bool fresh = true;
    s = forwards ? low : end;
    for (int step = 0; step < kMaxSteps; ++step) {
        vec2 g = sign * tubeResidual(torus, p + s * d, d);
        float newton = s - 0.5 * g.x / (g.y == 0.0 ? 1e-30 : g.y);
        float enough = 1.2e-7 * (abs(s) + torus.major);
        bool leave = false;
        if (forwards) {
            if (g.y >= 0.0 || (g.x > 0.0 && newton > end)) {
                leave = true;
            } else if (g.x <= 0.0) {
                s = max(newton, low);
                return true;
            } else {
                bool done = newton - s <= enough;
                low = s;
                s = newton;
                if (done) return true;
            }
        } else if (fresh && g.x > 0.0) {
            leave = true; // concave and still outside at the end: no root in between
        } else {
            newton = max(newton, low);
            bool done = abs(newton - s) <= enough || g.x >= 0.0;
            if (g.x < 0.0) s = newton;
            if (done) return true;
        }
        fresh = false;
        if (leave) {
            if (end >= to || piece == 2) return false;
            low = end;
            ++piece;
            end = min(piece == 1 ? concave.y : to, to);
            forwards = (sign > 0.0) == (piece != 1);
            s = forwards ? low : end;
            fresh = true;
        }
    }
    return true; // converging still, from one side: s is between the start and the root
}

bool intersectTorus(Torus torus, Ray ray, float side, inout float t) {
    if (passesBy(ray.origin - torus.center, ray.direction, torus.major + torus.minor)) return false;
    mat3 axes = torusFrame(torus.axis);
    NearRay near = recentre(ray.origin, torus.center, ray.direction);
    vec3 p = axes * near.origin; // turned after the re-centring: turning a far origin would round it
    vec3 d = axes * ray.direction;
    vec2 bounds = torusBounds(torus, p, d);
    float sign = 1.0;
    float start = ((side == 0.0 ? ray.tMin : 0.0) - near.tHigh) - near.tLow;
    if (start > bounds.x) { // the ray starts within the bounds: on which side of the tube?
        bounds.x = start;
        sign = side != 0.0 ? side : (tubeResidual(torus, p + start * d, d).x < 0.0 ? -1.0 : 1.0);
    }
    if (!(bounds.x <= bounds.y)) return false;
    float s;
    if (!firstCrossing(torus, p, d, bounds.x, bounds.y, concaveStretch(torus, p, d), sign, s)) return false;
    float hit = near.tHigh + (near.tLow + s);
    if (!(hit < t)) return false;
    t = hit;
    return true;
}

Surface surfaceTorus(Torus torus, Ray ray, float t) {
    mat3 axes = torusFrame(torus.axis);
    vec3 d = axes * ray.direction;
    NearRay near = recentre(ray.origin, torus.center, ray.direction);
    vec3 p = axes * near.origin + ((t - near.tHigh) - near.tLow) * d;
    vec2 around = p.xy * inversesqrt(max(dot(p.xy, p.xy), 1e-30));
    vec3 normal = normalize(p - vec3(torus.major * around, 0.0));
    vec3 ring = vec3(torus.major * around, 0.0);
    Surface surface = bareSurface(torus.center + (ring + torus.minor * normal) * axes, normal * axes, 1.0 / torus.minor);
#if IMAGES
    const float kTwoPi = 6.28318530717959;
    surface.uv = vec2(atan(around.y, around.x), atan(-normal.z, dot(normal.xy, around))) / kTwoPi + 0.5;
    surface.uvPerUnit = 1.0 / (kTwoPi * vec2(torus.major, torus.minor));
    surface.tangent = vec3(-around.y, around.x, 0.0) * axes;
#endif
    return surface;
}
