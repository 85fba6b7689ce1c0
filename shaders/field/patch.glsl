// The height patch that is baked, and the samples of its field.
//
// Coordinates   x along u, z along v, y up, from the patch's corner u = v = 0, in lengths of its longer side: the patch
//               lies over [0, bake.sides.xy]. Heights are told from the patch's centre
// jetOf         height, first and second derivatives along x and z, at a point over the patch
// samplePoint   sample i of n lies at i / (n - 1) of the box: those at its ends lie on its faces
#include "field/height_net.glsl"

layout(std140) uniform Bake {
    mat4 net;      // column j: heights of row j, along u
    vec4 low;      // corners of the box of samples
    vec4 high;
    vec4 sides;    // of the patch along x and z; 1 / both
    vec4 rates;    // rate, beta1 and beta2 of the descents; w: the world's units in one of ours
    ivec4 counts;  // samples along a side of the box, of these in a brick, iterations, starts or samples along a side
    vec4 bounds;   // x: Lipschitz constant, y: what float32 loses of a height, zw: texel where the field begins
} bake;

uniform int slice; // of the samples along z

struct Jet {
    float height;
    vec2 slope; // along x, z
    vec3 bend;  // xx, zz, xz
};

float heightAt(vec2 x) { return heightOn(bake.net, x * bake.sides.zw); }

Jet jetOf(vec2 x) {
    vec2 inverse = bake.sides.zw;
    vec2 t = x * inverse;
    vec4 across = bernstein(t.y);
    vec4 acrossSlope = bernsteinSlope(t.y);
    vec4 rows = bernstein(t.x) * bake.net;
    vec4 rowSlopes = bernsteinSlope(t.x) * bake.net;
    vec3 bend = vec3(dot(bernsteinBend(t.x) * bake.net, across), dot(rows, bernsteinBend(t.y)),
        dot(rowSlopes, acrossSlope));
    return Jet(dot(rows, across), inverse * vec2(dot(rowSlopes, across), dot(rows, acrossSlope)),
        inverse.xyx * inverse.xyy * bend);
}

vec3 samplePoint(vec3 index) {
    vec3 t = index / float(bake.counts.x - 1);
    return bake.low.xyz * (1.0 - t) + bake.high.xyz * t;
}

vec2 texelOfField() { return floor(gl_FragCoord.xy) - bake.bounds.zw; }
vec3 samplePoint() { return samplePoint(vec3(texelOfField(), float(slice))); }
