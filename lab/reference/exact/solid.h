/// A solid's field in double, as its tree says: what the shader's generated code is held against.
#pragma once

#include "tracer/scene/solid.h"

#include <glm/glm.hpp>

namespace gnomon::oracle {

/// Signed distance as the operations define it (tracer/scene/solid.h). Closed analytic shapes by
/// lab/reference/exact/exact_shape.h; a Mandelbulb's estimate by its own formula.
double fieldOf(const SolidNode&, glm::dvec3 p);

} // namespace gnomon::oracle
