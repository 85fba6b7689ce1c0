/// The geometry of a shape as the texels that shaders/primitive/KEY.glsl reads. Where a field lies follows from the
/// shape table: each vector takes a texel, a rotation three for the axes that it comes to, scalars the fourth
/// components of these in turn, and what is left over further texels. GLSL calls a shape by its key: large_sphere is
/// LargeSphere.
#pragma once

#include "tracer/scene/shapes.h"

#include <glm/glm.hpp>

#include <array>
#include <string>
#include <vector>

namespace gnomon {

/// Most texels that the geometry of one shape takes, however many of its values make vectors; two more of a rotation.
inline constexpr int kMaxShapeTexels = kMaxShapeValues / 3 + 2;
using ShapeTexels = std::array<glm::dvec4, kMaxShapeTexels>;

/// struct TYPE, loadTYPE, intersectTYPE, surfaceTYPE in GLSL.
std::string glslTypeOf(ShapeKind);

/// Texels that the geometry of one shape takes; of a solid its bounding sphere only.
int texelsOf(ShapeKind);

/// The texels of a shape; zeros follow them.
ShapeTexels packedShape(const Shape&);

/// What follows the texels of its geometry. Of a smooth triangle: three normals, with u beside them, and v; of a height
/// patch the rows of its net; of a patch in space those of x, of y, of z and of the weights.
int netTexelsOf(ShapeKind);
void appendNet(const Shape&, std::vector<glm::vec4>&);

/// Appends its texels.
void appendShape(const Shape&, std::vector<glm::vec4>&);

} // namespace gnomon
