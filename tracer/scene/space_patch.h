/// A bicubic Bézier surface in space, polynomial or rational, told by its net of control points.
///
/// At (u, v) in [0, 1]² lies Σ B_i(u) B_j(v) w_k p_k over Σ B_i(u) B_j(v) w_k, with k = 4 j + i, the control points p,
/// their weights w > 0 and the cubic Bernstein polynomials B.
#pragma once

#include <glm/glm.hpp>

#include <array>

namespace gnomon {

using ControlPoints = std::array<glm::dvec4, 16>; ///< places with their weights, row by row along u

/// What is drawn of it: {weight * (place - anchor), weight} of each control point. Patches that share an edge share
/// their anchor, so that in float32, too, they have the same edge.
struct SpaceNet {
    std::array<glm::dvec4, 16> points{};
    glm::dvec3 low{0}, high{0}; ///< a box about the surface, relative to the anchor
};

SpaceNet spaceNet(const ControlPoints&, glm::dvec3 anchor);

/// The net of the surface that a linear map makes of one, about the mapped anchor.
SpaceNet mappedNet(const SpaceNet&, const glm::dmat3& linear);

} // namespace gnomon
