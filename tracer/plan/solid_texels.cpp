#include "tracer/plan/solid_texels.h"

#include "tracer/plan/shape_texels.h"

namespace gnomon {
namespace {

int texelsBelow(const SolidNode& node) {
    int texels = ownTexels(node);
    for (const SolidNode& part : node.of) texels += texelsBelow(part);
    return texels;
}

/// `home` is what the node's coordinates become relative to.
void append(const SolidNode& node, glm::dvec3 home, std::vector<glm::vec4>& out) {
    switch (node.op) {
    case SolidOp::Shape: appendShape(translated(node.shape, -home), out); break;
    case SolidOp::SmoothUnion:
    case SolidOp::Offset: out.emplace_back(glm::vec4(float(node.amount), 0, 0, 0)); break;
    case SolidOp::Transform:
        out.emplace_back(node.rotate.x, node.rotate.y, node.rotate.z, node.rotate.w);
        out.emplace_back(glm::dvec4(node.translate - home, node.scale));
        home = glm::dvec3(0);
        break;
    case SolidOp::Repetition: {
        // Copies are told from the middle of the first, so that the nearest one is found by rounding.
        const Extent first = extentOf(node.of[0]).value();
        const glm::dvec3 middle = 0.5 * (first.low + first.high);
        out.emplace_back(glm::dvec4(node.period, 0));
        out.emplace_back(glm::dvec4(node.count, 0));
        out.emplace_back(glm::dvec4(middle - home, 0));
        home = middle;
        break;
    }
    default: break;
    }
    for (const SolidNode& part : node.of) append(part, home, out);
}

} // namespace

int ownTexels(const SolidNode& node) {
    switch (node.op) {
    case SolidOp::Shape: return texelsOf(node.shape.kind);
    case SolidOp::SmoothUnion:
    case SolidOp::Offset: return 1;
    case SolidOp::Transform: return 2;
    case SolidOp::Repetition: return 3;
    default: return 0;
    }
}

int texelsOf(const Solid& solid) { return 1 + texelsBelow(solid.root); }

void appendTexels(const Shape& shape, std::vector<glm::vec4>& out) {
    appendShape(shape, out);
    append(shape.solid->root, shape.home, out);
}

} // namespace gnomon
