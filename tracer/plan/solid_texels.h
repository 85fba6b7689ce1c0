/// The values of a solid as the texels that its generated GLSL reads (tracer/shader/solid_source.h).
#pragma once

#include "tracer/scene/solid.h"

#include <glm/glm.hpp>

#include <vector>

namespace gnomon {

/// Texels of a node itself, without its operands.
int ownTexels(const SolidNode&);

/// Texels that a solid takes: its bounding sphere, then the values of its nodes as the tree is walked.
int texelsOf(const Solid&);

/// Appends them. Nodes are told relative to the middle of the bounding sphere, so that solids keep float32's digits
/// wherever they stand.
void appendTexels(const Shape& solid, std::vector<glm::vec4>&);

} // namespace gnomon
