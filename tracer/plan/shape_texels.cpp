#include "tracer/plan/shape_texels.h"

namespace gnomon {

std::string glslTypeOf(ShapeKind kind) { return std::string(shapeRow(kind).type); }

int texelsOf(ShapeKind kind) { return shapeRow(kind).texels; }

void appendShape(const Shape& shape, std::vector<glm::vec4>& out) {
    for (int i = 0; i < texelsOf(shape.kind); ++i) out.emplace_back(shape.texels[std::size_t(i)]);
}

} // namespace gnomon
