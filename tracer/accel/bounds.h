/// Boxes along the axes, in float32, that hold whatever the shader may find of a shape.
///
/// boundsOf  of the shape in the float32 numbers that the shader gets. Beyond the smallest box it leaves room for the
///           band in which the shader may decide either way, 2^-21 of the size, and for the roundings that its surface
///           points are written with (docs/numerics.md): a surface point of the shader lies inside, not just an exact
///           one
/// Error     conservative; no face is farther out than 2^-19 of the size and four roundings of the farthest coordinate
///           (tests/unit/bounds_test.cpp)
#pragma once

#include "tracer/scene/shapes.h"

#include <glm/glm.hpp>

#include <limits>
#include <optional>

namespace gnomon {

/// Empty by default: the neutral element of merged().
struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};

    bool operator==(const Bounds&) const = default;
};

inline Bounds merged(const Bounds& a, const Bounds& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

/// Half the surface of a box that is not empty: the chance of a random line to meet it, but for a factor.
inline double halfArea(const Bounds& box) {
    const glm::dvec3 side = glm::dvec3(box.high) - glm::dvec3(box.low);
    return side.x * side.y + side.y * side.z + side.z * side.x;
}

/// None for what has no end: planes, large spheres.
std::optional<Bounds> boundsOf(const Shape&);

} // namespace gnomon
