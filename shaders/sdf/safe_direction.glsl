// Gradients of distances: where a point lies off what is nearest to it.
//
// safeDirection   unit direction of `offset`, whose length is given; `otherwise` where that is too short to have a
//                 direction
// anyAcross  some unit direction across `axis`, which is unit: the same one for an axis
const float kNoDirection = 1e-15; // the squares of shorter ones leave float32

vec2 safeDirection(vec2 offset, float size, vec2 otherwise) { return size > kNoDirection ? offset / size : otherwise; }
vec3 safeDirection(vec3 offset, float size, vec3 otherwise) { return size > kNoDirection ? offset / size : otherwise; }

vec3 anyAcross(vec3 axis) {
    return normalize(cross(axis, abs(axis.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0)));
}
