#include "tracer/plan/shape_texels.h"

#include "tracer/scene/rotation.h"

#include <cctype>

namespace gnomon {
namespace {

/// Of a kind: where each of a shape's values lies among its texels.
struct Packing {
    std::array<int, kMaxShapeValues> component{}; ///< of value i: 4 * texel + component
    int values = 0, texels = 0;
    int rotation = -1; ///< the first of the three texels of its axes; -1: it has none
};

Packing packingOf(const FieldList& fields) {
    Packing packing;
    packing.values = fields.valueCount();
    for (const ShapeField& field : fields) {
        if (field.type == FieldType::Rotation) packing.rotation = packing.texels;
        for (int v = 0; v < vectorCount(field.type); ++v, ++packing.texels)
            for (int i = 0; i < 3; ++i) packing.component[std::size_t(field.at + 3 * v + i)] = 4 * packing.texels + i;
        if (field.type == FieldType::Rotation) packing.texels += 2;
    }
    const int end = 4 * packing.texels;
    int beside = 3, after = end; // the next free component beside a vector, and after all vectors
    for (const ShapeField& field : fields) {
        if (vectorCount(field.type) > 0) continue;
        int& next = beside < end ? beside : after;
        packing.component[std::size_t(field.at)] = next;
        next += beside < end ? 4 : 1;
    }
    packing.texels = (after + 3) / 4;
    return packing;
}

const Packing& packing(ShapeKind kind) {
    static const auto all = [] {
        std::array<Packing, kShapeKinds> packings;
        for (int i = 0; i < kShapeKinds; ++i) packings[std::size_t(i)] = packingOf(shapeRow(ShapeKind(i)).fields);
        return packings;
    }();
    return all[std::size_t(kind)];
}

} // namespace

std::string glslTypeOf(ShapeKind kind) {
    std::string type;
    bool begins = true;
    for (const char c : shapeRow(kind).key) {
        if (c != '_') type += begins ? char(std::toupper(static_cast<unsigned char>(c))) : c;
        begins = c == '_';
    }
    return type;
}

int texelsOf(ShapeKind kind) { return packing(kind).texels; }

ShapeTexels packedShape(const Shape& shape) {
    const Packing& to = packing(shape.kind);
    ShapeTexels texels{};
    for (std::size_t i = 0; i < std::size_t(to.values); ++i)
        texels[std::size_t(to.component[i] / 4)][to.component[i] % 4] = shape.values[i];
    if (to.rotation < 0) return texels;
    // Rounded once each, where the shader would round its way from three numbers to nine. Those of float32 are meant.
    const glm::dvec4 told = texels[std::size_t(to.rotation)];
    const glm::dmat3 axes = axesOf({inFloat(told.x), inFloat(told.y), inFloat(told.z)});
    for (int i = 0; i < 3; ++i) texels[std::size_t(to.rotation + i)] = glm::dvec4(axes[i], 0);
    return texels;
}

int netTexelsOf(ShapeKind kind) {
    if (kind == ShapeKind::SpacePatch) return 16;
    return kind == ShapeKind::SmoothTriangle || kind == ShapeKind::HeightPatch ? 4 : 0;
}

void appendNet(const Shape& shape, std::vector<glm::vec4>& out) {
    if (const auto& corners = shape.corners) {
        const auto& uv = corners->uv;
        for (std::size_t i = 0; i < 3; ++i) out.emplace_back(glm::vec3(corners->normals[i]), float(uv[i].x));
        out.emplace_back(float(uv[0].y), float(uv[1].y), float(uv[2].y), 0.0f);
    }
    if (const auto& heights = shape.heights)
        for (std::size_t row = 0; row < 16; row += 4)
            out.emplace_back((*heights)[row], (*heights)[row + 1], (*heights)[row + 2], (*heights)[row + 3]);
    if (!shape.net) return;
    const auto& points = shape.net->points;
    for (int axis = 0; axis < 4; ++axis)
        for (std::size_t row = 0; row < 16; row += 4)
            out.emplace_back(
                glm::dvec4(points[row][axis], points[row + 1][axis], points[row + 2][axis], points[row + 3][axis]));
}

void appendShape(const Shape& shape, std::vector<glm::vec4>& out) {
    const ShapeTexels texels = packedShape(shape);
    out.insert(out.end(), texels.begin(), texels.begin() + texelsOf(shape.kind));
}

} // namespace gnomon
