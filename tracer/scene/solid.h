/// A solid, defined by signed distances: a tree of shapes and what is made of them. The tree becomes GLSL, its values
/// stay data.
///
/// Union, intersection and difference take the least and the greatest of distances: outside of what they make that is
/// at most the distance, inside it may be less. Smooth union never tells more than union; offsets, motions, uniform
/// scale and repetition keep distances, a Mandelbulb estimates its own from below.
#pragma once

#include "tracer/scene/shapes.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gnomon {

enum class SolidOp { Shape, Union, Intersection, Difference, SmoothUnion, Offset, Transform, Repetition };

struct SolidNode {
    SolidOp op = SolidOp::Shape;
    Shape shape; ///< of Shape
    /// One of the last three, at least one of the others; a difference takes all others from the first.
    std::vector<SolidNode> of;
    double amount = 0;       ///< SmoothUnion: how far from a seam it still bends; Offset: outwards, negative inwards
    glm::dvec3 translate{0}; ///< Transform: after scale and turn
    glm::dquat rotate{1, 0, 0, 0};
    double scale = 1;
    glm::dvec3 period{0}; ///< Repetition: from copy to copy
    glm::dvec3 count{1};  ///< copies along x, y and z, whole numbers; the first stands where `of` does
};

struct Solid {
    SolidNode root;
};

/// The words of scene files for the operations, in the order of SolidOp; the first is empty.
inline constexpr std::array<std::string_view, 8> kSolidKeys{
    "", "union", "intersection", "difference", "smooth_union", "offset", "transform", "repetition"};

/// A box that holds the solid; none where it has no end.
std::optional<Extent> extentOf(const SolidNode&);

/// Of a repetition with such a part: how many copies along each axis, those nearest to a point, tell the distance
/// there. A part that reaches over its neighbours takes more of them.
glm::ivec3 copiesAbout(const SolidNode& repetition);

/// Its structure without its values: solids of one form share their GLSL.
std::string formOf(const SolidNode&);

/// The solid as a shape, its bounding sphere about the middle of its box; none where it has no end.
std::optional<Shape> shapeOf(SolidNode root);

} // namespace gnomon
