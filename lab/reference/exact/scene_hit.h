/// What a ray meets first of several solids, in long double: a ray may start 1e-12 of its coordinates off a surface.
#pragma once

#include "lab/reference/exact/exact_shape.h"
#include "tracer/plan/camera.h"
#include "tracer/scene/scene.h"

#include <vector>

namespace gnomon::oracle {

using Vec = glm::tvec3<long double>;
using SceneShape = ExactShape<long double>;

/// The scene's objects, in their order: in the float32 values that the shader gets, and a large sphere, which the
/// shader has in double-float anchored form, in the scene's own.
std::vector<SceneShape> exactShapesOf(const Scene&, double time);

struct SceneHit {
    int object = -1; ///< index of the shape, -1: nothing
    long double t = 0;
    Vec point{0}, normal{0}; ///< normal against the ray
    bool outside = false;    ///< the ray comes from outside of the shape, or from the side of a flat one's own normal
    /// How far the ray is from deciding otherwise, in scene units: across itself, or along it to another surface.
    long double margin = 1e30L;
    /// From the hit to the nearest edge of its shape, where the normal jumps; and how fast it turns about an apex: 1 /
    /// radius.
    long double edge = 1e30L, turn = 0;
};

SceneHit nearestHit(const std::vector<SceneShape>&, Vec origin, Vec direction);

/// The ray through the centre of pixel (x, y), row 0 at the top, with the float32 camera that the shader gets.
void pixelRay(const CameraPose&, int x, int y, int width, int height, Vec& origin, Vec& direction);

} // namespace gnomon::oracle
