// Rotations in three numbers: the axis times the tangent of a quarter of the angle (modified Rodrigues parameters).
//
// axesOf  the rotated axes as columns: axes * v rotates v, v * axes rotates it back
// Error   2 roundings of each component
// Source  M. Shuster, A Survey of Attitude Representations, 1993. Any three numbers are a rotation, so that those of
//         float32 are an exact one; a unit quaternion rounded to float32 is none
vec3 axisOf(vec3 v, float w, vec3 axis) {
    vec3 twice = 2.0 * cross(v, axis);
    return axis + w * twice + cross(v, twice);
}

mat3 axesOf(vec3 rotation) {
    float square = dot(rotation, rotation);
    vec3 v = (2.0 / (1.0 + square)) * rotation;
    float w = (1.0 - square) / (1.0 + square);
    return mat3(axisOf(v, w, vec3(1.0, 0.0, 0.0)), axisOf(v, w, vec3(0.0, 1.0, 0.0)),
        axisOf(v, w, vec3(0.0, 0.0, 1.0)));
}
