#include "tracer/scene/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon {
namespace {

using Box = std::optional<Extent>;

Box hull(const Box& a, const Box& b) {
    if (!a || !b) return std::nullopt;
    return Extent{glm::min(a->low, b->low), glm::max(a->high, b->high)};
}

Box common(const Box& a, const Box& b) {
    if (!a || !b) return a ? a : b;
    const glm::dvec3 low = glm::max(a->low, b->low);
    return Extent{low, glm::max(low, glm::min(a->high, b->high))};
}

Box grown(Box box, double by) {
    if (!box) return box;
    const glm::dvec3 middle = 0.5 * (box->low + box->high);
    return Extent{glm::min(box->low - by, middle), glm::max(box->high + by, middle)};
}

Box moved(const Box& box, const SolidNode& node) {
    if (!box) return box;
    Extent all{glm::dvec3(std::numeric_limits<double>::infinity()),
               glm::dvec3(-std::numeric_limits<double>::infinity())};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(corner & 1 ? box->high.x : box->low.x, corner & 2 ? box->high.y : box->low.y,
                           corner & 4 ? box->high.z : box->low.z);
        const glm::dvec3 q = node.rotate * (node.scale * p) + node.translate;
        all = {glm::min(all.low, q), glm::max(all.high, q)};
    }
    return all;
}

Box repeated(const Box& box, const SolidNode& node) {
    if (!box) return box;
    const glm::dvec3 last = node.period * (node.count - 1.0);
    return Extent{box->low + glm::min(last, 0.0), box->high + glm::max(last, 0.0)};
}

/// Of the operations that take many, in the order they stand.
Box ofMany(const SolidNode& node) {
    Box box = extentOf(node.of.front());
    for (std::size_t i = 1; i < node.of.size() && node.op != SolidOp::Difference; ++i)
        box = node.op == SolidOp::Intersection ? common(box, extentOf(node.of[i])) : hull(box, extentOf(node.of[i]));
    return box;
}

} // namespace

std::optional<Extent> extentOf(const SolidNode& node) {
    switch (node.op) {
    case SolidOp::Shape: {
        const auto extent = shapeRow(node.shape.kind).extent;
        return extent ? Box(extent(node.shape)) : std::nullopt;
    }
    case SolidOp::SmoothUnion: return grown(ofMany(node), node.amount / 4 * double(node.of.size() - 1));
    case SolidOp::Offset: return grown(extentOf(node.of[0]), node.amount);
    case SolidOp::Transform: return moved(extentOf(node.of[0]), node);
    case SolidOp::Repetition: return repeated(extentOf(node.of[0]), node);
    default: return ofMany(node);
    }
}

glm::ivec3 copiesAbout(const SolidNode& node) {
    const Box box = extentOf(node.of[0]);
    glm::ivec3 window(1);
    for (int i = 0; i < 3; ++i) {
        if (node.count[i] <= 1) continue;
        // The nearest n copies leave out none whose middle is nearer than n / 2 periods: half a period more than the
        // part reaches from its own.
        const double reach = box ? 0.5 * (box->high[i] - box->low[i]) / node.period[i] : node.count[i];
        window[i] = int(std::min(node.count[i], std::ceil(1 + 2 * reach - 1e-9)));
    }
    return window;
}

std::string formOf(const SolidNode& node) {
    if (node.op == SolidOp::Shape) return std::string(shapeRow(node.shape.kind).key);
    std::string form(kSolidKeys[std::size_t(node.op)]);
    if (node.op == SolidOp::Repetition) { // how many copies are looked at is structure
        const glm::ivec3 window = copiesAbout(node);
        for (int i = 0; i < 3; ++i) form += std::to_string(window[i]) + (i < 2 ? "," : "");
    }
    form += '(';
    for (const SolidNode& part : node.of) form += formOf(part) + (&part == &node.of.back() ? ")" : ",");
    return form;
}

std::optional<Shape> shapeOf(SolidNode root) {
    const auto box = extentOf(root);
    if (!box) return std::nullopt;
    Shape shape{ShapeKind::Solid, {}};
    // Room for the rounding of values inside.
    const double reach = 0.5 * glm::length(box->high - box->low) * (1 + 1e-5) + 1e-9;
    shape.home = 0.5 * (box->low + box->high);
    setPoint(shape, "center", shape.home);
    setLength(shape, "radius", reach);
    shape.solid = std::make_shared<const Solid>(Solid{std::move(root)});
    return shape;
}

} // namespace gnomon
