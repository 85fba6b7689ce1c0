// Two unit vectors across a unit vector and across each other; continuous but at -z.
// Source  T. Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017
mat2x3 frameAbout(vec3 axis) {
    float s = axis.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + axis.z);
    float b = axis.x * axis.y * a;
    return mat2x3(vec3(1.0 + s * axis.x * axis.x * a, s * b, -s * axis.x), vec3(b, s + axis.y * axis.y * a, -axis.y));
}
