// Mandelbulb: the points that z -> z^power + c, in spherical coordinates, keeps bounded. It has a distance only, and
// this from below: an estimate.
//
// distanceMandelbulb  no gradient (0): who needs one takes differences
// Error               nothing that the estimate shows as inside lies within 0.99 of it (tests/shader/solid_test.cpp:
//                     4000 points in 64 directions each). It jumps where an orbit escapes a round later
// Source              D. White and P. Nylander's map, 2009; the estimate 1/2 |z| log |z| / |z'| is J. Hart et al., Ray
//                     Tracing Deterministic 3-D Fractals, 1989, with the scalar derivative of I. Quilez's Mandelbulb
//                     article, 2009
// Limits              power 2 … 16, iterations 1 … 32
struct Mandelbulb {
    vec3 center;
    float radius;
    float power;
    float iterations;
};

Mandelbulb loadMandelbulb(int at) {
    vec4 a = sceneTexel(at);
    vec4 b = sceneTexel(at + 1);
    return Mandelbulb(a.xyz, a.w, b.x, b.y);
}

vec4 distanceMandelbulb(Mandelbulb bulb, vec3 p, vec3 from) {
    vec3 c = (p - bulb.center) / bulb.radius;
    vec3 z = c;
    float r = length(z);
    float slope = 1.0;
    for (int i = 0; i < 32; ++i) {
        if (float(i) >= bulb.iterations || r > 2.0) break;
        float grown = pow(max(r, 1e-12), bulb.power - 1.0);
        slope = bulb.power * grown * slope + 1.0;
        float theta = bulb.power * acos(clamp(z.y / max(r, 1e-12), -1.0, 1.0));
        float phi = bulb.power * (abs(z.x) + abs(z.z) > 0.0 ? atan(z.x, z.z) : 0.0);
        z = grown * r * vec3(sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi)) + c;
        r = length(z);
    }
    float estimate = 0.5 * log(max(r, 1e-12)) * r / slope;
    // Far off the bulb's ball is nearer to the truth than the estimate.
    float ball = length(c) - 1.25;
    return vec4(0.0, 0.0, 0.0, bulb.radius * max(min(estimate, 1.0), ball));
}
