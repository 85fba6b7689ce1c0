/// A solid's tree as GLSL, and its numbers as the texels that this GLSL reads.
#pragma once

#include "tracer/scene/solid.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace gnomon {

/// Texels that a solid takes: its ball, then the numbers of its parts as the tree is walked.
int texelsOf(const Solid&);

/// Appends them. Parts are told relative to the ball's middle, so that solids keep float32's digits wherever they
/// stand.
void appendTexels(const Shape& solid, std::vector<glm::vec4>&);

/// Whether some part only estimates its distance, and has no gradient of its own.
bool estimated(const Solid&);

/// A file of the shader library for solids of this form, drawn as `type` (as Solid0): the field of their distances as
/// `vec4 fieldTYPE(int at, vec3 p)`, gradient and distance of a point relative to the ball's middle. What
/// shaders do with it stands in shaders/sdf/solid.glsl.
std::string solidSource(const Solid&, const std::string& type);

} // namespace gnomon
