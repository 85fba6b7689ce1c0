// Nets of a bicubic Bézier height function: net[j][i] is the control height at u = i/3, v = j/3.
//
// bernstein, bernsteinSlope, bernsteinBend  the four cubic polynomials at t, their first and second derivatives
// heightOn   height at (u, v)
// partOfNet  the net of the part over [low, high], which may be turned round: by means of control heights only
// Error      4 roundings of the largest control height
vec4 bernstein(float t) {
    float s = 1.0 - t;
    return vec4(s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t);
}
vec4 bernsteinSlope(float t) {
    float s = 1.0 - t;
    return 3.0 * vec4(-s * s, s * (s - 2.0 * t), t * (2.0 * s - t), t * t);
}
vec4 bernsteinBend(float t) { return 6.0 * vec4(1.0 - t, 3.0 * t - 2.0, 1.0 - 3.0 * t, t); }

float heightOn(mat4 net, vec2 uv) { return dot(bernstein(uv.x) * net, bernstein(uv.y)); }

// Of four cubics side by side: from `low` to `high`.
mat4 segments(mat4 c, float low, float high) {
    vec4 a = mix(c[0], c[1], low), b = mix(c[1], c[2], low), d = mix(c[2], c[3], low);
    vec4 first = mix(a, b, low), second = mix(b, d, low);
    vec4 third = mix(mix(a, b, high), mix(b, d, high), high);
    a = mix(c[0], c[1], high), b = mix(c[1], c[2], high), d = mix(c[2], c[3], high);
    return mat4(mix(first, second, low), mix(first, second, high), third, mix(mix(a, b, high), mix(b, d, high), high));
}

mat4 partOfNet(mat4 net, vec2 low, vec2 high) {
    return segments(transpose(segments(transpose(net), low.x, high.x)), low.y, high.y);
}
