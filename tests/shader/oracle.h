/// What a ray meets, worked out on the CPU in long double by other means than the shader's: dense sampling of the
/// signed distance along the ray between bounds, then bisection, for closed shapes; for convex ones ternary search for
/// its least value instead, then bisection; direct solution for flat ones.
#pragma once

#include "tracer/render/camera.h"
#include "tracer/scene/scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace gnomon::test {

using Vec = glm::tvec3<long double>;

struct OracleHit {
    int object = -1; ///< index in the scene, -1: nothing
    long double t = 0;
    Vec point{0}, normal{0}; ///< normal against the ray
    /// How far the ray is from deciding otherwise, in scene units: from the nearest silhouette it passes or grazes.
    long double margin = 1e30L;
    /// From the hit to the nearest edge of its shape, where the normal jumps; and how fast it turns near an apex: 1 /
    /// radius.
    long double edge = 1e30L, turn = 0;
};

/// Of a closed shape, in its shader's float32 numbers; negative inside.
long double signedDistance(const Shape&, Vec);

OracleHit oracleHit(const std::vector<Shape>& shapes, Vec origin, Vec direction);

/// The ray through the centre of pixel (x, y), row 0 at the top, with the float32 camera that the shader gets.
void pixelRay(const CameraPose&, int x, int y, int width, int height, Vec& origin, Vec& direction);

} // namespace gnomon::test
