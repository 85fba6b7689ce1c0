/// Where groups and transforms put things: linear maps with a translation, and what shapes and solids become by them.
#pragma once

#include "tracer/scene/solid.h"

#include <array>
#include <optional>
#include <string>
#include <variant>

namespace gnomon {

/// p becomes linear * p + translate. The linear part keeps left and right apart: its determinant is above 0.
struct Affine {
    glm::dmat3 linear{1};
    glm::dvec3 translate{0};

    glm::dvec3 operator()(glm::dvec3 p) const { return linear * p + translate; }
};

/// Scaled along x, y and z, then rotated, then moved.
Affine affineOf(glm::dvec3 scale, glm::dquat rotate, glm::dvec3 translate);

/// By how much all lengths grow alike; none where they do not.
std::optional<double> scaleOf(const glm::dmat3& linear);

/// What cannot be, and what to do instead.
using Complaint = std::array<std::string, 2>;

/// The shape that the map makes of one; a complaint where that is none that can be drawn. A rotated sphere is an
/// ellipsoid of equal radii: an image on it is rotated as well.
std::variant<Shape, Complaint> transformed(const Shape&, const Affine&);

/// The same of a solid. Scaled evenly it is one node around it; else the map goes on to the shapes inside.
std::variant<SolidNode, Complaint> transformed(const SolidNode&, const Affine&);

} // namespace gnomon
