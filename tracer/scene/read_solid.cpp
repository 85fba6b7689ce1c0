#include "tracer/scene/read_solid.h"

#include "tracer/scene/affine.h"
#include "tracer/scene/read_patch.h"
#include "tracer/scene/rotation.h"
#include "tracer/scene/solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gnomon {
namespace {

constexpr int kMostParts = 64;  ///< of a solid: each is code in the shader
constexpr int kMostCopies = 64; ///< of a repetition that a point may be nearest to: each is an evaluation

/// The fields of an analytic shape, as the shape table says.
Shape readFields(const ObjectReader& reader, const ShapeRow& key, SceneReport& report) {
    const ShapeRow& row = writtenRow(key);
    Shape shape{row.kind, {}};
    for (const ShapeField& field : row.fields) {
        double* values = &shape.values[std::size_t(field.at)];
        std::array<glm::dvec3, 3> vectors{};
        if (vectorCount(field.type) == 0) {
            reader.read(field.key, *values);
        } else if (field.type == FieldType::Vertices) {
            reader.read(field.key, vectors);
        } else {
            reader.read(field.key, vectors[0]);
            if (field.type == FieldType::Rotation) vectors[0] = rodriguesOf(rotationOfDegrees(vectors[0]));
        }
        for (int i = 0; i < 3 * vectorCount(field.type); ++i) values[i] = vectors[std::size_t(i / 3)][i % 3];
    }
    if (reader.sound()) {
        const auto [what, remedy] = row.check(shape);
        if (!what.empty()) report.add(reader.line(), reader.path(), what, remedy);
    }
    return simplest(shape);
}

SolidNode readNode(const ObjectReader&, SceneReport&);
bool complete(const SolidNode&);

/// What stands under "of".
std::vector<SolidNode> readInner(const ObjectReader& reader, SceneReport& report) {
    std::vector<SolidNode> of;
    if (const auto inner = reader.object("of")) of.push_back(readNode(*inner, report));
    return of;
}

/// `node` holds what is moved. Scaled unevenly it is no node of its own: its shapes are other ones.
SolidNode readTransform(const ObjectReader& reader, SolidNode node, SceneReport& report) {
    const Placement placement = readPlacement(reader);
    const glm::dvec3 scale = placement.scale;
    node.translate = placement.translate;
    node.rotate = placement.rotate;
    node.scale = scale.x;
    if ((scale.x == scale.y && scale.y == scale.z) || !reader.sound() || !complete(node)) return node;
    auto scaled = transformed(node.of[0], affineOf(scale, node.rotate, node.translate));
    if (auto* result = std::get_if<SolidNode>(&scaled)) return std::move(*result);
    const auto& [what, remedy] = std::get<Complaint>(scaled);
    report.add(reader.lineOf("scale"), reader.pathOf("scale"), what, remedy);
    return node;
}

void readCopies(const ObjectReader& reader, SolidNode& node, SceneReport& report) {
    reader.read("period", node.period);
    reader.read("count", node.count);
    if (!reader.sound()) return;
    for (int i = 0; i < 3; ++i) {
        if (node.count[i] > 1 && !(node.period[i] > 0))
            return report.add(reader.lineOf("period"), reader.pathOf("period"),
                              "copies along an axis need a period above 0", "give the distance from copy to copy");
    }
}

SolidNode readOperation(const ObjectReader& object, SolidOp op, double blend, SceneReport& report) {
    const std::string_view key = kSolidKeys[std::size_t(op)];
    SolidNode node;
    node.op = op;
    if (op < SolidOp::Offset) {
        for (const auto& member : object.members(key)) node.of.push_back(readNode(object.open(key, member), report));
        node.amount = blend;
        return node;
    }
    const auto reader = object.object(key);
    node.of = readInner(*reader, report);
    switch (op) {
    case SolidOp::Offset: reader->read("by", node.amount); break;
    case SolidOp::Transform: return readTransform(*reader, std::move(node), report);
    default: readCopies(*reader, node, report); break;
    }
    return node;
}

SolidNode readNode(const ObjectReader& object, SceneReport& report) {
    const double blend = readBlend(object);
    for (const ShapeRow& row : shapeTable())
        if (const auto reader = object.object(row.key)) return {SolidOp::Shape, readFields(*reader, row, report)};
    for (std::size_t op = 1; op < kSolidKeys.size(); ++op)
        if (object.has(kSolidKeys[op])) return readOperation(object, SolidOp(op), blend, report);
    return {};
}

int partsOf(const SolidNode& node) {
    int parts = 1;
    for (const SolidNode& part : node.of) parts += partsOf(part);
    return parts;
}

/// A repetition whose part reaches over too many of its neighbours.
const SolidNode* denseRepetition(const SolidNode& node) {
    if (node.op == SolidOp::Repetition) {
        const glm::ivec3 window = copiesAbout(node);
        if (double(window.x) * window.y * window.z > kMostCopies) return &node;
    }
    for (const SolidNode& part : node.of)
        if (const SolidNode* dense = denseRepetition(part)) return dense;
    return nullptr;
}

/// Whether every operation got what it works on; where one did not, that has been reported.
bool complete(const SolidNode& node) {
    if (node.op != SolidOp::Shape && node.of.empty()) return false;
    return std::all_of(node.of.begin(), node.of.end(), complete);
}

/// How far the parts of a solid go beyond what float32 computes with, one within another.
struct Ranges {
    double leastScale = 1, mostScale = 1; ///< products of the scales around a part
    double reach = 0;                     ///< coordinates of a part, from the object's origin
};

void addRanges(const SolidNode& node, double scale, double moved, Ranges& ranges) {
    const auto longest = [](const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
    if (node.op == SolidOp::Transform) {
        moved += scale * longest(node.translate);
        scale *= node.scale;
    }
    if (node.op == SolidOp::Repetition) moved += scale * longest(node.period * (node.count - 1.0));
    ranges.leastScale = std::min(ranges.leastScale, scale);
    ranges.mostScale = std::max(ranges.mostScale, scale);
    double inner = 0;
    if (node.op == SolidOp::Shape)
        if (const auto extent = extentOf(node)) inner = std::max(longest(extent->low), longest(extent->high));
    ranges.reach = std::max(ranges.reach, moved + scale * inner);
    for (const SolidNode& part : node.of) addRanges(part, scale, moved, ranges);
}

/// What keeps the solid from being drawn, and what to do about it; empty where nothing does.
Complaint outOfRange(const SolidNode& node) {
    constexpr double kMostScale = 1e6, kMostReach = 1e10; // squares and products of them stay inside float32
    Ranges ranges;
    addRanges(node, 1, 0, ranges);
    const double scale = ranges.mostScale > kMostScale ? ranges.mostScale : ranges.leastScale;
    if (scale > kMostScale || scale < 1 / kMostScale)
        return {"its transforms, one within another, scale by " + toString(scale),
                "keep their product from " + toString(1 / kMostScale) + " to " + toString(kMostScale)};
    if (ranges.reach > kMostReach)
        return {"its parts, moved one within another, reach " + toString(ranges.reach) + " units away",
                "keep them within " + toString(kMostReach)};
    return {};
}

} // namespace

double readBlend(const ObjectReader& object) {
    double blend = 0.25;
    object.read("blend", blend);
    return blend;
}

Placement readPlacement(const ObjectReader& reader) {
    Placement placement;
    glm::dvec3 degrees{0};
    reader.read("scale", placement.scale);
    if (reader.read("rotate", degrees)) placement.rotate = rotationOfDegrees(degrees);
    reader.read("translate", placement.translate);
    return placement;
}

Complaint complaintOf(const SolidNode& node) {
    if (const int parts = partsOf(node); parts > kMostParts)
        return {"a solid of " + std::to_string(parts) + " parts, operations counted",
                "use at most " + std::to_string(kMostParts) + ", or several objects"};
    if (const SolidNode* dense = denseRepetition(node)) {
        const glm::ivec3 window = copiesAbout(*dense);
        return {"copies that reach over " + std::to_string(window.x) + " x " + std::to_string(window.y) + " x " +
                    std::to_string(window.z) + " of one another",
                "use a longer period or a smaller part: at most " + std::to_string(kMostCopies) + " may meet"};
    }
    if (Complaint range = outOfRange(node); !range[0].empty()) return range;
    if (extentOf(node)) return {};
    return {"the solid has no end",
            "intersect its plane with something that has, or make the plane an object of its own"};
}

Shape readShape(const ObjectReader& object, SceneReport& report) {
    if (const auto patch = object.object("patch")) return readPatch(*patch, report);
    const SolidNode node = readNode(object, report);
    const bool analytic = node.op == SolidOp::Shape && node.shape.kind != ShapeKind::Mandelbulb;
    if (analytic || !object.sound() || !complete(node)) return node.shape;
    if (const auto [what, remedy] = complaintOf(node); !what.empty()) {
        report.add(object.line(), object.path(), what, remedy);
        return {};
    }
    return *shapeOf(node);
}

} // namespace gnomon
