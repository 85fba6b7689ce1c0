#include "tracer/accel/bounds.h"

#include <algorithm>

namespace gnomon {
namespace {

double largest(glm::dvec3 v) { return std::max({v.x, v.y, v.z}); }

} // namespace

std::optional<Bounds> boundsOf(const Shape& shape) {
    const auto extent = shapeRow(shape.kind).extent;
    if (!extent) return std::nullopt;
    const Extent box = extent(inFloat(shape));
    // At least 3/2 of the size, which is the farthest that a shape reaches from its middle: a triangle's longest edge
    // is so much more than its farthest vertex is from the centroid; a cone comes next, all others are twice the size.
    const double diagonal = glm::length(box.high - box.low);
    const double farthest = largest(glm::max(glm::abs(box.low), glm::abs(box.high)));
    // Two roundings of the shader's surface point, one of the bound itself.
    const double room = 0x1p-21 * diagonal + 3 * 0x1p-23 * farthest;
    return Bounds{glm::vec3(box.low - room), glm::vec3(box.high + room)};
}

} // namespace gnomon
