// A solid of a form that is told by its distances: what rays and shadows do with the generated fieldTYPE().
//
// intersect  nearest t in (ray.tMin, t) at which the ray passes through the surface, found by marching between where
//            the ray enters and leaves the solid's bounding sphere. frame.marchSteps steps at most: what they do not
//            reach is not met.
//            MARCH_STEPS: equal steps of the sphere: what is thinner than a step may be missed
//            MARCH_SPHERE: steps as long as the distance, or what float32 resolves of the sphere
//            MARCH_CONE: or half the width of the pixel's cone, taken to widen from the eye, and of a solid that is no
//            estimate at most 1/64 of the sphere's radius. Taken back where the distance behind it or its slope are not
//            those of the plane that the ray was by
//            MARCH_RELAXED: that with steps as long as if the distance went on to change along the ray as it did, taken
//            back where the balls free of the surface about both ends do not touch
//            Where the surface is as near as the least step, the step is to where its tangent plane says, and a little
//            beyond. Only what has the solid beyond it is met: a surface that the ray just touches, as the skin that
//            two flush solids leave over a hole, is passed. Steps and so t are the same whatever was met before: of
//            equal solids the first is met. An estimate has no gradient, and its surface detail without end: it is met
//            where it is as near as the least step, by MARCH_STEPS just before it; in scenes with glass a ray that
//            leaves it meets it again only beyond that detail
// surface    the point pulled onto the surface along the gradient; images lie on it as on a floor, in scene units. Of
//            an estimate the normal faces a ray from outside, and not one from inside: `ray.side` is that on which the
//            ray travels, 0 where only the distance tells
// gradient   of an estimate: differences over a tetrahedron of size `reach`
// Error      t: a point at most 2^-18 of the sphere's radius off the surface; what is thinner than that is not met.
//            Of an estimate: short of the surface by what the pixel covers, the point at most half of that beside it
//            (tests/shader/solid_test.cpp)
// Source     J. Hart, Sphere Tracing, 1996; J. Amanatides, Ray Tracing with Cones, 1984;
//            C. Bán and G. Valasek, Automatic Step Size Relaxation in Sphere Tracing, 2023;
//            false position: M. Dowell and P. Jarratt, A Modified Regula Falsi Method, 1971
struct $Shape {
    int at;
    vec4 ball;
};

$Shape load$Shape(int at) { return $Shape(at, sceneTexel(at)); }
vec4 ball$Shape($Shape solid) { return solid.ball; }
float detail$Shape($Shape solid) { return 1e-4 * solid.ball.w; } // the least that an estimate's normal is the mean of
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
    float end = sqrt(max((solid.ball.w - radial) * (solid.ball.w + radial), 0.0));
    float limit = min(end, (t - near.tHigh) - near.tLow);
    float s = max(-end, (ray.tMin - near.tHigh) - near.tLow);
    float finest = 1e-6 * solid.ball.w;
#if REFRACTION && $SHAPE_ESTIMATED
    if (side != 0.0) s += detail$Shape(solid); // or glass that is dust would be met at every step of a ray
#endif
    float inside = side;
    float last = s;    // the ray is free up to here
    float known = 0.0; // the distance there
    float free = 0.0;  // the distance at s, negative beyond the surface
    bool met = false;
#if MARCH == MARCH_STEPS
    float stride = 2.0 * solid.ball.w / float(frame.marchSteps);
    for (int i = 0; i <= frame.marchSteps && !met; ++i) {
        if (s > end || last > limit) return false;
        float field = marched$Shape(solid.at, near.origin + s * ray.direction).w;
        if (inside == 0.0) inside = field < 0.0 ? -1.0 : 1.0;
        free = inside * field;
        met = free < -finest && i > 0;
        if (!met) {
            last = s;
            known = free;
            s += stride;
        }
    }
#else
    bool bold = false; // the last step is longer than what is known to be free
    bool clear = side == 0.0; // the ray has left the surface that it starts on, where rounding says anything
#if MARCH == MARCH_RELAXED
    float slope = -1.0;  // of the distance along the ray, as it seems
#endif
#if $SHAPE_ESTIMATED
    float before = side == 0.0 ? 1e30 : -1.0;
#else
    float approached = 0.0; // how fast the ray nears the surface at `last`
#endif
    for (int i = 0; i < frame.marchSteps && !met; ++i) {
        if (s > end && last + known < end) s = end;
        if (s > end || last > limit) return false;
        vec4 field = marched$Shape(solid.at, near.origin + s * ray.direction);
        if (inside == 0.0) inside = field.w < 0.0 ? -1.0 : 1.0;
        free = inside * field.w;
        float least = finest;
#if MARCH == MARCH_CONE || MARCH == MARCH_RELAXED
        float width = 0.5 * frame.pixelAngle * (near.tHigh + (near.tLow + s));
#if $SHAPE_ESTIMATED
        least = max(least, width);
#else
        least = max(least, min(width, solid.ball.w / 64.0)); // smaller than a pixel it has holes and edges still
#endif
#endif
        float taken = s - last;
        bool between = abs(free) + known < taken; // what lies between is not known to be free
        bool gap = bold && between;
#if $SHAPE_ESTIMATED
        met = !gap && free < least && free <= before;
        if (!gap) before = free;
#else
        float approach = -inside * dot(field.xyz, ray.direction);
        // Half a pixel's width may hold more than the plane that the ray was by, which told another distance and slope.
        bool foreseen = abs(free - known + approached * taken) < 0.01 * taken + finest
            && abs(approach - approached) < 0.02;
        gap = gap || (between && taken > 4.0 * finest && !foreseen);
        gap = gap && !(known < least && free >= 0.0 && free <= known && approach > 0.0); // it nears as was foreseen
        met = free < -finest && (clear || approach > 0.0);
        clear = clear || free > 2.0 * finest;
#endif
#if MARCH == MARCH_RELAXED
        if (taken > 0.0) slope = gap ? -1.0 : mix(slope, (free - known) / taken, 0.7);
#endif
        if (!met) {
            last = gap ? last : s;
            known = gap ? known : max(free, 0.0);
#if !$SHAPE_ESTIMATED
            approached = gap ? approached : approach;
#endif
            float step = max(known, least);
#if MARCH == MARCH_RELAXED
            step *= 2.0 / clamp(1.0 - slope, 1.25, 2.0);
#endif
            bold = step > max(known, least);
#if !$SHAPE_ESTIMATED
            bool nears = free < least && approach > 0.0;
            if (nears) step = max(known, min((free + 2.0 * finest) / approach, 32.0 * least));
            bold = bold || nears;
#endif
            if (gap) step = max(max(known, finest), 0.5 * taken);
            bold = gap ? 0.5 * taken > max(known, finest) : bold;
            s = last + step;
        }
    }
#endif
    if (!met) return false;
#if MARCH == MARCH_STEPS && $SHAPE_ESTIMATED
    // On the near side of what lies between `last` and s: from the point that is met the surface is on that side, too.
    float beyond = s;
    for (int i = 0; i < 24 && beyond - last > finest; ++i) {
        s = 0.5 * (last + beyond);
        bool nearer = inside * marched$Shape(solid.at, near.origin + s * ray.direction).w > 2.0 * finest;
        last = nearer ? s : last;
        beyond = nearer ? beyond : s;
    }
    s = last;
#elif !$SHAPE_ESTIMATED
    // Where the solid is about `finest` deep, between `last` and s by false position: an end that stays twice counts
    // half.
    float beyond = s, depth = free + finest;
    float off = depth, earlier = 0.0;
    known = max(known, 0.0) + finest;
    for (int i = 0; i < 24 && abs(off) > 2.0 * finest && beyond - last > finest; ++i) {
        s = mix(last, beyond, known / (known - depth));
        off = inside * marched$Shape(solid.at, near.origin + s * ray.direction).w + finest;
        bool nearer = off > 0.0;
        float weight = off * earlier > 0.0 ? 0.5 : 1.0;
        last = nearer ? s : last;
        known = nearer ? off : weight * known;
        beyond = nearer ? beyond : s;
        depth = nearer ? weight * depth : off;
        earlier = off;
    }
#endif
    float hit = near.tHigh + (near.tLow + s);
    if (s > end || hit >= t) return false;
    t = hit;
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
    vec3 gradient = gradient$Shape(solid.at, p, max(0.25 * frame.pixelAngle * t, detail$Shape(solid)));
    float steep = length(gradient);
    vec3 normal = steep > 1e-30 ? gradient / steep : -ray.direction;
#if $SHAPE_ESTIMATED
    p -= free * normal;
    // A cone that grazes a silhouette ends beside what faces away already: it sees the rim.
    // And what travels inside meets it from inside: the gradient, which jumps, may say otherwise.
    float facing = dot(normal, ray.direction);
    float side = ray.side == 0.0 ? (free >= 0.0 ? 1.0 : -1.0) : ray.side;
    if (side * facing > 0.0) normal = normalize(normal - 1.001 * facing * ray.direction);
#else
    // Twice: by an edge the first step lands beside the solid, on the plane of one face, the second on the other face.
    p -= free / max(steep, 0.5) * normal;
    vec4 beside = field$Shape(solid.at, p);
    p -= beside.w * beside.xyz / max(dot(beside.xyz, beside.xyz), 0.25);
#endif
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
