// Torus: the points at distance `minor` from a circle of radius `major` about `center`, in the plane across `axis`.
//
// ballTorus       about its centre
// distanceTorus   gradient and signed distance; about the circle the axis, on the axis one of the ways out
// intersectTorus  nearest t in (ray.tMin, t)
// surfaceTorus    point and normal exact to a few ulp of major + minor; u runs around the axis, v around the tube,
//                 downward outside
// Error           band 2^-22 (major + minor), ray 1.5 ulp, point 2 and normal 2 roundings, as docs/numerics.md names
//                 them (tests/shader/intersect_test.cpp); distance 2 roundings, gradient 2
//                 (tests/shader/distance_test.cpp; measured 1.7 and 1.0)
// Source          ray re-centred exactly (ray/split.glsl). Along the ray g(s) = (|xy| - major)² + z² - minor² is
//                 concave on one interval about the axis and convex before and after it. g and g' at the ends of these
//                 three pieces tell which can hold the nearest root, and Newton, started at the end where it converges
//                 from one side, finds it or shows that there is none: no root is missed and none invented
//                 (docs/numerics.md)
// Cost            after the ends of the pieces 1.1 steps a ray into the bounding sphere, 6 where it grazes; 2.2 times
//                 the time of the textbook's closed form (tests/shader/cost_test.cpp)
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

vec4 ballTorus(Torus torus) { return vec4(torus.center, torus.major + torus.minor); }

#if DISTANCES
#include "sdf/safe_direction.glsl"

vec4 distanceTorus(Torus torus, vec3 p, vec3 from) {
    vec3 offset = p - torus.center;
    float along = dot(offset, torus.axis);
    vec3 across = offset - along * torus.axis;
    float radial = length(across);
    float beyond = radial - torus.major;
    float fromCircle = length(vec2(beyond, along));
    across -= dot(across, torus.axis) * torus.axis; // what rounding left along the axis counts close to it
    vec3 outward = safeDirection(across, length(across), anyAcross(torus.axis));
    vec3 offCircle = beyond * outward + along * torus.axis;
    return vec4(safeDirection(offCircle, length(offCircle), torus.axis), fromCircle - torus.minor);
}
#endif

// A ray as the torus sees it, from the re-centred origin: its parts along the axis and across it.
struct TubeRay {
    float z;
    float dz;
    vec3 across;     // of the origin
    vec3 acrossStep; // of the direction
    float square;    // |acrossStep|²
    float perSquare; // 1 / square, below all infinities
    float middle;    // s of the point nearest to the axis
    float least;     // its squared distance from the axis
};

TubeRay tubeRay(Torus torus, vec3 p, vec3 d) {
    float z = dot(p, torus.axis);
    float dz = dot(d, torus.axis);
    vec3 across = p - z * torus.axis;
    vec3 acrossStep = d - dz * torus.axis;
    float square = dot(acrossStep, acrossStep);
    float perSquare = 1.0 / max(square, 1e-16);
    float middle = -dot(across, acrossStep) * perSquare;
    vec3 nearest = across + middle * acrossStep;
    return TubeRay(z, dz, across, acrossStep, square, perSquare, middle, max(dot(nearest, nearest), 1e-30));
}

// g at s and half its derivative, both times the distance from the axis: that spares a division. `lost` makes up for a
// square root that is coarse on some GPUs; compilers that fold the square of a root would fold it to 0.
vec2 tubeResidual(Torus torus, TubeRay ray, float s) {
    vec3 across = ray.across + s * ray.acrossStep;
    float z = ray.z + s * ray.dz;
    float square = dot(across, across);
    float fromAxis = optimisationBarrier(vec3(sqrt(square))).x;
    float lost = square - fromAxis * fromAxis;
    float q = fromAxis - torus.major;
    float g = (q * q + (z * z - torus.minor * torus.minor)) * fromAxis + q * lost;
    return vec2(g, q * dot(across, ray.acrossStep) + z * ray.dz * fromAxis);
}

// Half the second derivative of g at s, times the distance from the axis like the others.
float tubeBend(Torus torus, TubeRay ray, float s) {
    float square = ray.square * (s - ray.middle) * (s - ray.middle) + ray.least;
    return (ray.square + ray.dz * ray.dz) * sqrt(square) - torus.major * ray.square * ray.least / square;
}

// The interval of the ray that can hold a hit: within the cylinder |xy| <= major + minor and the slab |z| <= minor;
// empty where x > y.
vec2 torusBounds(Torus torus, TubeRay ray) {
    const vec2 kNone = vec2(1.0, 0.0);
    float reach = (torus.major + torus.minor) * 1.0000005;
    float square = (reach * reach - ray.least) * ray.perSquare;
    if (square < 0.0) return kNone;
    float halfChord = sqrt(square);
    vec2 bounds = vec2(ray.middle - halfChord, ray.middle + halfChord);
    float slab = torus.minor + 4e-7 * (torus.major + torus.minor);
    if (abs(ray.dz) <= 1e-9) return abs(ray.z) > slab ? kNone : bounds;
    float perDz = 1.0 / ray.dz;
    vec2 z = (vec2(-slab, slab) - ray.z) * perDz;
    return vec2(max(bounds.x, min(z.x, z.y)), min(bounds.y, max(z.x, z.y)));
}

// Of x >= 0, to a rounding or two, at less than pow()'s cost: 1 / root guessed to 4 % by a third of the exponent, then
// two steps of third order.
float cubeRoot(float x) {
    float inverse = intBitsToFloat(0x54A2FA8C - int(float(floatBitsToInt(x)) * 0.33333333));
    for (int i = 0; i < 2; ++i) {
        float off = 1.0 - x * inverse * inverse * inverse;
        inverse += inverse * off * (0.33333333 + 0.22222222 * off);
    }
    return x * inverse * inverse;
}

// Where g is concave; empty (beyond all numbers) where it is convex throughout.
vec2 concaveInterval(Torus torus, TubeRay ray) {
    float fromAxis = cubeRoot(torus.major * ray.square * ray.least / (ray.square + ray.dz * ray.dz)); // there g'' is 0
    float square = fromAxis * fromAxis - ray.least;
    if (square < 0.0) return vec2(3e38);
    float halfWidth = sqrt(square * ray.perSquare) + 1e-5 * torus.major;
    return vec2(ray.middle - halfWidth, ray.middle + halfWidth);
}

// A piece of the ray that may hold the root: `s` is one step from the end where Newton converges from one side.
struct TubePiece {
    float s;
    float low;
    float high;
    bool convex; // Newton comes from the left and stays there, else from the right
    bool known; // sign * g is positive at low and not at high; else it falls at low, and rises again at high
    bool trial; // s is from a parabola, and may lie beyond where g falls
    bool worth; // there may be a root
};

// at.x is the start of the bounded ray, at.y and at.z the ends of the concave interval. Where the ray starts outside of
// the tube the pieces are convex, concave, convex; inside, where -g is what falls, concave, convex, concave.
TubePiece firstPiece(Torus torus, TubeRay ray, vec3 at, vec3 g, vec3 slope, bool outside) {
    bool before = at.y > at.x && g.y <= 0.0; // the root lies before the interval
    bool within = at.z > at.y && g.z <= 0.0; // or, if not, in it
    bool upToInterval = outside || before;
    float low = upToInterval ? at.x : at.y;
    float high = upToInterval ? at.y : at.z;
    bool known = before || (!outside && within);
    // From outside Newton starts at at.x. There the parabola through g, g' and g'' is better still: what it misses is
    // of third order, and as g'' shrinks towards the axis it meets 0 at or behind the root. At at.y it is a line.
    float from = outside ? at.x : at.y;
    float fall = outside ? slope.x : slope.y;
    float value = outside ? g.x : g.y;
    float bend = outside ? tubeBend(torus, ray, at.x) : 0.0;
    float square = fall * fall - value * bend;
    float steep = square > 0.0 ? sqrt(square) : -fall;
    bool trial = square > 0.0 && (known || value <= (high - from) * (steep - fall));
    if (!trial) steep = -fall; // the parabola says nothing within the piece: half its slope is Newton's
    float s = fall < 0.0 ? from - value / (fall - steep) : high;
    bool dips = (outside ? slope.y : slope.z) > 0.0 && s <= high;
    return TubePiece(s, low, high, outside || !before, known, trial, fall < 0.0 && high > low && (known || dips));
}

// From outside the concave interval where it holds a root, else what lies behind it, both from at.z; from inside always
// what lies behind.
TubePiece nextPiece(vec3 at, vec3 g, vec3 slope, float end, bool outside) {
    bool within = outside && at.z > at.y && g.z <= 0.0;
    float low = within ? at.y : at.z;
    float high = within ? at.z : end;
    bool known = within || !outside;
    float s = slope.z < 0.0 ? at.z - 0.5 * g.z / slope.z : high;
    return TubePiece(s, low, high, outside && !within, known, false,
        !outside || (slope.z < 0.0 && (within || s <= high)));
}

// First s in the bounds where g falls through 0, or rises through it where the ray starts inside of the tube; false
// where there is none. `side` as in intersectTorus, 0 where g at the start is to tell.
bool firstCrossing(Torus torus, TubeRay ray, vec2 bounds, float side, out float s) {
    const int kMaxSteps = 40;
    vec3 at = vec3(bounds.x, clamp(concaveInterval(torus, ray), bounds.x, bounds.y));
    vec2 a = tubeResidual(torus, ray, at.x);
    vec2 b = tubeResidual(torus, ray, at.y);
    vec2 c = tubeResidual(torus, ray, at.z);
    float sign = (side != 0.0 ? side : a.x) < 0.0 ? -1.0 : 1.0;
    vec3 g = sign * vec3(a.x, b.x, c.x);
    vec3 slope = sign * vec3(a.y, b.y, c.y);
    TubePiece piece = firstPiece(torus, ray, at, g, slope, sign > 0.0);
    TubePiece next = nextPiece(at, g, slope, bounds.y, sign > 0.0);
    s = 0.0;
    if (!piece.worth && !next.worth) return false;
    bool more = piece.worth && next.worth;
    if (!piece.worth) piece = next;
    s = clamp(piece.s, piece.low, piece.high);
    // The next step is less than step² |g''| / |2 g'|; |g''| / 2 is less than 1 + major / (major - minor) near the
    // surface.
    float hole = torus.major - torus.minor;
    float ample = 4e-9 * torus.major * hole / ((torus.major + hole) * (torus.major + torus.minor));
    float enough = 1.4e-14 * torus.major * torus.major;
    bool found = true;
    for (int step = 0; step < kMaxSteps; ++step) {
        vec2 here = tubeResidual(torus, ray, s);
        bool ahead = sign * here.x > 0.0;
        bool falls = sign * here.y < 0.0;
        bool astray = piece.trial && !falls; // the parabola went too far: Newton, from the start
        bool before = ahead && !astray;      // the root, if there is one
        float newton = falls ? s - 0.5 * here.x / here.y : (astray ? piece.low : s);
        bool leave = !piece.known && before && (!falls || newton > piece.high);
        bool settled = piece.convex ? !ahead && !piece.trial : ahead; // on the root's other side only by rounding
        piece.low = leave ? next.low : (before ? s : piece.low);
        piece.high = leave ? next.high : (before ? piece.high : s);
        piece.convex = leave ? next.convex : piece.convex;
        piece.known = leave ? next.known : piece.known || !ahead;
        piece.trial = false;
        newton = clamp(leave ? next.s : newton, piece.low, piece.high);
        float change = newton - s;
        s = newton;
        found = !leave || more;
        if (!found || (!leave && (settled || change * change <= max(ample * abs(here.y), enough)))) break;
        more = more && !leave;
    }
    return found; // after all steps converging still, from one side: s is between the start and the root
}

bool intersectTorus(Torus torus, Ray ray, float side, inout float t) {
    if (passesBy(ray, ballTorus(torus))) return false;
    NearRay near = recentre(ray.origin, torus.center, ray.direction);
    TubeRay tube = tubeRay(torus, near.origin, ray.direction);
    vec2 bounds = torusBounds(torus, tube);
    float start = ((side == 0.0 ? ray.tMin : 0.0) - near.tHigh) - near.tLow;
    // Before the bounds is outside, but for a ray that leaves inward: it starts there by rounding.
    float startsOn = side < 0.0 || start > bounds.x ? side : 1.0;
    bounds.x = max(bounds.x, start);
    if (!(bounds.x <= bounds.y)) return false;
    float s;
    if (!firstCrossing(torus, tube, bounds, startsOn, s)) return false;
    float sum = near.tHigh + s;
    float lost = lostBy(vec3(sum), vec3(near.tHigh), vec3(-s)).x; // near by s is as large as t: one rounding, not two
    float hit = sum + (near.tLow + lost);
    if (!(hit < t)) return false;
    t = hit;
    return true;
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

Surface surfaceTorus(Torus torus, Ray ray, float t) {
    mat3 axes = torusFrame(torus.axis);
    vec3 d = axes * ray.direction;
    NearRay near = recentre(ray.origin, torus.center, ray.direction);
    vec3 p = axes * near.origin + ((t - near.tHigh) - near.tLow) * d;
    vec2 around = p.xy * inversesqrt(max(dot(p.xy, p.xy), 1e-30));
    vec3 normal = normalize(p - vec3(torus.major * around, 0.0));
    vec3 ring = vec3(torus.major * around, 0.0);
    Surface surface = bareSurface(torus.center + (ring + torus.minor * normal) * axes, normal * axes,
        1.0 / torus.minor);
#if TORUS_IMAGES
    const float kTwoPi = 6.28318530717959;
    surface.uv = vec2(atan(around.y, around.x), atan(-normal.z, dot(normal.xy, around))) / kTwoPi + 0.5;
    surface.uvPerUnit = 1.0 / (kTwoPi * vec2(torus.major, torus.minor));
    surface.tangent = vec3(-around.y, around.x, 0.0) * axes;
#endif
    return surface;
}

#if COVERS
#include "shadow/ring_cover.glsl"

// horizon: the surface's normal; own: that of the torus itself, whose position is exact to `uncertain`.
void uniteTorus(Torus torus, LightCone cone, vec3 horizon, bool own, float uncertain, inout Shade shade) {
    float perMajor = 1.0 / torus.major;
    vec3 apex = (cone.apex - torus.center) * perMajor;
    float minor = torus.minor * perMajor;
    float z = dot(apex, torus.axis);
    vec3 across = apex - z * torus.axis;
    cone.distance *= perMajor;
    if (!own && length(vec2(length(across) - 1.0, z)) < minor) shade.largest = kPi;
    else uniteRing(Ring(apex, torus.axis, minor, z, across, own ? 2.0 * minor * uncertain * perMajor : 0.0), cone,
        horizon, own, shade);
}
#endif
