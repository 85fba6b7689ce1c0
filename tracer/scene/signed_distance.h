/// Signed distance to a body, on the CPU: which bodies a point lies in.
#pragma once

#include "tracer/scene/shapes.h"

#include <glm/glm.hpp>

namespace gnomon {

/// Whether points can lie inside: a plane has the half space behind its normal, discs and triangles have nothing.
bool boundsBody(ShapeKind);

/// Negative inside. Exact outside of analytic shapes, of solids as tracer/scene/solid.h says; of a Mandelbulb only the
/// sign counts; of a disc and a triangle it is never negative.
double signedDistance(const Shape&, glm::dvec3 p);

} // namespace gnomon
