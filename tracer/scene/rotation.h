/// Rotations as scene files and shapes tell them.
///
/// A shape's is three numbers: the axis times the tangent of a quarter of the angle (modified Rodrigues parameters).
/// Any three numbers are a rotation, so that those of float32 are an exact one too.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace gnomon {

/// About x, then y, then z.
glm::dquat rotationOfDegrees(glm::dvec3 degrees);

/// Three numbers of at most length 1, and back.
glm::dvec3 rodriguesOf(glm::dquat);
glm::dmat3 axesOf(glm::dvec3 rodrigues); ///< the rotated axes as columns

} // namespace gnomon
