// One given point a pixel: how far the scene is from it, as float32, for measuring and testing distances.
//
// points       xyz: the point
// viewpoints   xyz: `from`, which says what side of a plane is outside
// outNearest   xyz: gradient, w: distance of the nearest object
// outCasters   the same of those that cast shadows, as sceneDistance() tells it
// outObject    x: number of the nearest object in the shader's order; of several as near the first
#include "frame.glsl"
#include "scene.glsl"
#include "ray/ray.glsl"
#include "ray/split.glsl"
#for Shape in SHAPES
#include "primitive/$shape.glsl"
#endfor
#include "sdf/scene.glsl"

uniform sampler2D points;
uniform sampler2D viewpoints;

layout(location = 0) out vec4 outNearest;
layout(location = 1) out vec4 outCasters;
layout(location = 2) out vec4 outObject;

vec4 nearestObject(vec3 p, vec3 from, out int object) {
    vec4 nearest = vec4(0.0, 1.0, 0.0, 3e38);
    object = -1;
#for Shape in SHAPES
    for (int i = 0; i < k$ShapeCount; ++i) {
        vec4 other = distance$Shape(load$Shape(k$ShapeBase + i * k$ShapeTexels), p, from);
        object = other.w < nearest.w ? k$ShapeFirst + i : object;
        nearest = other.w < nearest.w ? other : nearest;
    }
#endfor
    return nearest;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 p = texelFetch(points, at, 0).xyz;
    vec3 from = texelFetch(viewpoints, at, 0).xyz;
    int object;
    outNearest = nearestObject(p, from, object);
    outCasters = sceneDistance(p, from, 3e38);
    outObject = vec4(float(object), 0.0, 0.0, 0.0);
}
