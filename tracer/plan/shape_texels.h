/// The geometry of a shape as the texels that shaders/primitive/KEY.glsl reads.
#pragma once

#include "tracer/scene/shapes.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace gnomon {

/// struct TYPE, loadTYPE, intersectTYPE, surfaceTYPE in GLSL.
std::string glslTypeOf(ShapeKind);

/// Texels that the geometry of one shape takes; of a solid its bounding sphere only.
int texelsOf(ShapeKind);

/// Appends them.
void appendShape(const Shape&, std::vector<glm::vec4>&);

} // namespace gnomon
