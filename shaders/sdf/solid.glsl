// A solid of a form that is told by its distances: what rays and shadows do with the generated fieldTYPE().
//
// intersect  nearest t in (ray.tMin, t), found by marching between where the ray enters and leaves the solid's ball.
//            frame.marchSteps steps at most: what they do not reach is not met.
//            MARCH_STEPS: equal steps of the ball, then bisection: what is thinner than a step may be missed
//            MARCH_SPHERE: steps as long as the distance, until that is what float32 resolves of the ball
//            MARCH_CONE: the same, until the pixel's cone, taken to widen from the eye, holds the surface
//            MARCH_RELAXED: that with steps as long as if the distance went on to change along the ray as it did, taken
//            back where the balls free of the surface about both ends do not touch
// surface    the point pulled onto the surface along the gradient; images lie on it as on a floor, in scene units
// gradient   of an estimate: differences over a tetrahedron of size `reach`
// Error      t: short of the surface by what the pixel covers, or 2^-20 of the ball's radius where rays start
//            elsewhere; the point is at most half of that beside it (tests/shader/solid_test.cpp)
// Source     J. Hart, Sphere Tracing, 1996; J. Amanatides, Ray Tracing with Cones, 1984;
//            C. Bán and G. Valasek, Automatic Step Size Relaxation in Sphere Tracing, 2023
struct $Shape {
    int at;
    vec4 ball;
};

$Shape load$Shape(int at) { return $Shape(at, sceneTexel(at)); }
vec4 ball$Shape($Shape solid) { return solid.ball; }
vec4 distance$Shape($Shape solid, vec3 p, vec3 from) { return field$Shape(solid.at, p - solid.ball.xyz); }

vec4 marched$Shape(int at, vec3 p) {
#if OUTPUT == STEPS
    ++evaluations;
#endif
    return field$Shape(at, p);
}

bool intersect$Shape($Shape solid, Ray ray, float side, inout float t) {
    if (side == 0.0 && passesBy(ray, solid.ball)) return false;
    NearRay near = recentre(ray.origin, solid.ball.xyz, ray.direction);
    float radial = length(near.origin);
    float chord = sqrt(max((solid.ball.w - radial) * (solid.ball.w + radial), 0.0));
    float s = max(-chord, (ray.tMin - near.tHigh) - near.tLow);
    float end = min(chord, (t - near.tHigh) - near.tLow);
    float finest = 1e-6 * solid.ball.w;
    float inside = side;
#if MARCH == MARCH_STEPS
    float stride = 2.0 * solid.ball.w / float(frame.marchSteps);
    float last = s;
    bool met = false;
    if (inside == 0.0) inside = marched$Shape(solid.at, near.origin + s * ray.direction).w < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < frame.marchSteps && !met; ++i) {
        last = s;
        s += stride;
        if (last > end) return false;
        met = inside * marched$Shape(solid.at, near.origin + s * ray.direction).w < 0.0;
    }
    if (!met) return false;
    for (int i = 0; i < 24; ++i) {
        float middle = 0.5 * (last + s);
        if (inside * marched$Shape(solid.at, near.origin + middle * ray.direction).w < 0.0) s = middle;
        else last = middle;
    }
#else
    bool met = false;
#if MARCH == MARCH_RELAXED
    float taken = 0.0;   // the last step
    float known = 0.0;   // what was free at its start
    float slope = -1.0;  // of the distance along the ray, as it seems
#endif
#if $SHAPE_ESTIMATED
    float before = side == 0.0 ? 1e30 : -1.0; // at its start a ray touches the surface that it leaves
#endif
    for (int i = 0; i < frame.marchSteps && !met; ++i) {
#if MARCH == MARCH_RELAXED
        if (s > end && s - taken + known < end) { // what lies between is not known to be free
            taken -= s - end;
            s = end;
        }
#endif
        if (s > end) return false;
        vec4 field = marched$Shape(solid.at, near.origin + s * ray.direction);
        if (inside == 0.0) inside = field.w < 0.0 ? -1.0 : 1.0;
        float free = inside * field.w;
        float enough = finest;
#if MARCH == MARCH_RELAXED
        if (abs(free) + known < taken) {
            s += known - taken;
            taken = known;
            slope = -1.0;
            continue;
        }
        if (taken > 0.0) slope = mix(slope, (free - known) / taken, 0.7);
#endif
#if MARCH == MARCH_CONE || MARCH == MARCH_RELAXED
        enough = max(enough, 0.5 * frame.pixelAngle * (near.tHigh + (near.tLow + s)));
#endif
        // What the ray recedes from, as the surface that it leaves, it does not meet.
#if $SHAPE_ESTIMATED
        met = free < enough && free <= before;
        before = free;
#else
        met = free < enough && inside * dot(field.xyz, ray.direction) < 0.0;
#endif
#if MARCH == MARCH_RELAXED
        known = max(free, enough);
        taken = known * 2.0 / clamp(1.0 - slope, 1.25, 2.0);
        if (!met) s += taken;
#else
        if (!met) s += max(free, enough);
#endif
    }
    if (!met) return false;
#endif
    if (s > end) return false;
    t = near.tHigh + (near.tLow + s);
    return true;
}

vec3 gradient$Shape(int at, vec3 p, float reach) {
#if $SHAPE_ESTIMATED
    vec2 e = vec2(reach, -reach);
    return e.xyy * field$Shape(at, p + e.xyy).w + e.yyx * field$Shape(at, p + e.yyx).w +
        e.yxy * field$Shape(at, p + e.yxy).w +
           e.xxx * field$Shape(at, p + e.xxx).w;
#else
    return field$Shape(at, p).xyz;
#endif
}

Surface surface$Shape($Shape solid, Ray ray, float t) {
    NearRay near = recentre(ray.origin, solid.ball.xyz, ray.direction);
    vec3 p = near.origin + ((t - near.tHigh) - near.tLow) * ray.direction;
    float free = field$Shape(solid.at, p).w;
    vec3 gradient = gradient$Shape(solid.at, p, max(0.25 * frame.pixelAngle * t, 1e-4 * solid.ball.w));
    float steep = length(gradient);
    vec3 normal = steep > 1e-30 ? gradient / steep : -ray.direction;
#if $SHAPE_ESTIMATED
    p -= free * normal;
#else
    // Twice: by an edge the first step lands beside the solid, on the plane of one face, the second on the other face.
    p -= free / max(steep, 0.5) * normal;
    vec4 beside = field$Shape(solid.at, p);
    p -= beside.w * beside.xyz / max(dot(beside.xyz, beside.xyz), 0.25);
#endif
    // A cone that grazes a silhouette ends beside what is turned off already: it sees the rim.
    float facing = dot(normal, ray.direction);
    if (free >= 0.0 ? facing > 0.0 : facing < 0.0) normal = normalize(normal - 1.001 * facing * ray.direction);
    Surface surface = bareSurface(solid.ball.xyz + p, normal, 0.0);
#if IMAGES
    surface.uv = p.xz;
    surface.uvPerUnit = vec2(1.0);
    vec3 axis = abs(normal.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, -1.0);
    surface.tangent = normalize(axis - dot(axis, normal) * normal);
#endif
    return surface;
}

#if COVERS && !$SHAPE_ESTIMATED
float thick$Shape($Shape solid, vec3 p, vec3 direction) { return 2.0 * solid.ball.w; }
#endif
