/// A solid's tree as GLSL. It reads the texels of tracer/plan/solid_texels.h.
#pragma once

#include "tracer/scene/solid.h"

#include <string>

namespace gnomon {

/// Whether some part only estimates its distance, and has no gradient of its own.
bool estimated(const Solid&);

/// A file of the shader library for solids of this form, drawn as `type` (as Solid0): the field of their distances as
/// `vec4 fieldTYPE(int at, vec3 p)`, gradient and distance of a point relative to the ball's middle. What
/// shaders do with it stands in shaders/sdf/solid.glsl.
std::string solidSource(const Solid&, const std::string& type);

} // namespace gnomon
