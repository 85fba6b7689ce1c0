#include "tracer/scene/affine.h"

#include "tracer/problem.h"
#include "tracer/scene/read_patch.h"
#include "tracer/scene/read_solid.h"
#include "tracer/scene/rotation.h"
#include "tracer/scene/scene_format.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

constexpr double kEqual =
    1e-9; ///< relatively: what rounding leaves of angles that are right and lengths that are equal

using Transformed = std::variant<Shape, Complaint>;

bool across(glm::dvec3 a, glm::dvec3 b) { return std::abs(glm::dot(a, b)) <= kEqual * glm::length(a) * glm::length(b); }
bool equal(double a, double b) { return std::abs(a - b) <= kEqual * std::max(a, b); }

glm::dvec3 lengthsOf(const glm::dmat3& m) { return {glm::length(m[0]), glm::length(m[1]), glm::length(m[2])}; }

/// The rotation that orthogonal columns make, without what rounding leaves of none.
glm::dvec3 rotationOf(const glm::dmat3& columns) {
    const glm::dvec3 lengths = lengthsOf(columns);
    const glm::dmat3 axes(columns[0] / lengths.x, columns[1] / lengths.y, columns[2] / lengths.z);
    const glm::dvec3 rotation = rodriguesOf(glm::quat_cast(axes));
    return glm::length(rotation) < 1e-12 ? glm::dvec3(0) : rotation;
}

/// Columns of the same ellipsoid that are across one another: Hestenes' one-sided Jacobi rotations.
glm::dmat3 orthogonalised(glm::dmat3 m) {
    for (int sweep = 0; sweep < 30; ++sweep)
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 &a = m[i], &b = m[(i + 1) % 3];
            if (across(a, b)) continue;
            const double zeta = (glm::dot(b, b) - glm::dot(a, a)) / (2 * glm::dot(a, b));
            const double tangent = (zeta < 0 ? -1 : 1) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));
            const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
            const glm::dvec3 before = a;
            a = cosine * before - sine * b;
            b = sine * before + cosine * b;
        }
    return m;
}

Complaint unevenly(const Shape& shape, const std::string& remedy) {
    return {"a " + std::string(shapeRow(shape.kind).key) + " scaled unevenly is none any more", remedy};
}

Transformed ellipsoidOf(glm::dvec3 center, const glm::dmat3& linear) {
    const glm::dmat3 columns = orthogonalised(linear);
    const glm::dvec3 radii = lengthsOf(columns), rotation = rotationOf(columns);
    const Shape ellipsoid = makeShape(ShapeKind::Ellipsoid, {center, radii, rotation});
    return rotation == glm::dvec3(0) ? unoriented(ellipsoid) : ellipsoid;
}

Transformed boxOf(const Shape& box, const glm::dmat3& linear, glm::dvec3 center) {
    if (!across(linear[0], linear[1]) || !across(linear[1], linear[2]) || !across(linear[2], linear[0]))
        return Complaint{"a box that is rotated, then scaled unevenly is none any more",
                         "scale it before it is rotated, or write it as triangles"};
    Shape result = makeShape(ShapeKind::RotatedBox, {center, lengthsOf(linear), rotationOf(linear)});
    return box.kind == ShapeKind::Box ? simplest(result) : result;
}

Transformed heightPatchOf(const Shape& patch, const Affine& map) {
    glm::dmat3 linear = map.linear * axesOf(pointOf(patch, "rotate"));
    for (int i = 0; i < 3; ++i) linear[i] *= pointOf(patch, "size")[i];
    if (!across(linear[0], linear[1]) || !across(linear[1], linear[2]) || !across(linear[2], linear[0]))
        return Complaint{"a patch of heights that is rotated, then scaled unevenly is none any more",
                         "scale it before it is rotated"};
    Shape result = makeShape(ShapeKind::HeightPatch,
                             {map(pointOf(patch, "center")), lengthsOf(linear), rotationOf(linear)});
    result.heights = patch.heights;
    return result;
}

glm::dvec3 anyAcross(glm::dvec3 axis) {
    const glm::dvec3 other = std::abs(axis.x) < 0.9 * glm::length(axis) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(axis, other));
}

/// Disc, cylinder and cone: how a map changes the circle across an axis. 0 where it is none any more.
double radiusFactor(const glm::dmat3& linear, glm::dvec3 axis) {
    const glm::dvec3 first = anyAcross(axis), a = linear * first, b = linear * glm::normalize(glm::cross(axis, first));
    return across(a, b) && equal(glm::length(a), glm::length(b)) ? glm::length(a) : 0;
}

Transformed discOf(const Shape& disc, const Affine& map, glm::dvec3 normal) {
    const double factor = radiusFactor(map.linear, pointOf(disc, "normal"));
    if (factor == 0) return unevenly(disc, "use a flat ellipsoid, or scale the disc evenly along its plane");
    return makeShape(ShapeKind::Disc, {map(pointOf(disc, "center")), normal}, {factor * lengthOf(disc, "radius")});
}

/// Along its axis a cylinder or a cone may be scaled by itself.
Transformed axialOf(const Shape& shape, const Affine& map) {
    const glm::dvec3 from = pointOf(shape, "from"), to = pointOf(shape, "to"), axis = to - from;
    const double factor = radiusFactor(map.linear, axis);
    const glm::dvec3 first = anyAcross(axis), along = map.linear * axis;
    const bool straight = across(along, map.linear * first) && across(along, map.linear * glm::cross(axis, first));
    const bool roundEnds = shape.kind == ShapeKind::Capsule;
    if (factor == 0 || !straight || (roundEnds && !scaleOf(map.linear)))
        return unevenly(shape, roundEnds ? "scale it evenly, or change its points and its radius"
                                         : "scale it evenly across its axis, or change its points and its radius");
    return makeShape(shape.kind, {map(from), map(to)}, {factor * lengthOf(shape, "radius")});
}

Transformed triangleOf(const Shape& triangle, const Affine& map, const glm::dmat3& forNormals) {
    Shape result = triangle;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 vertex = map(vertexOf(triangle, i));
        std::copy_n(&vertex.x, 3, &result.values[std::size_t(3 * i)]);
    }
    if (!triangle.corners) return result;
    Corners corners = *triangle.corners;
    for (glm::dvec3& normal : corners.normals) normal = glm::normalize(forNormals * normal);
    result.corners = std::make_shared<const Corners>(corners);
    return result;
}

Transformed torusOf(const Shape& torus, const Affine& map) {
    const auto factor = scaleOf(map.linear);
    if (!factor) return unevenly(torus, "scale it evenly, or change its two radii");
    return makeShape(ShapeKind::Torus,
                     {map(pointOf(torus, "center")), glm::normalize(map.linear * pointOf(torus, "axis"))},
                     {*factor * lengthOf(torus, "major_radius"), *factor * lengthOf(torus, "minor_radius")});
}

Transformed solidOf(const Shape& solid, const Affine& map) {
    auto root = transformed(solid.solid->root, map);
    if (auto* complaint = std::get_if<Complaint>(&root)) return *complaint;
    SolidNode& node = std::get<SolidNode>(root);
    if (Complaint complaint = complaintOf(node); !complaint[0].empty()) return complaint;
    return *shapeOf(std::move(node));
}

/// What the map makes of it exactly, whatever its numbers.
Transformed mapped(const Shape& shape, const Affine& map) {
    const glm::dmat3 forNormals = glm::transpose(glm::inverse(map.linear));
    const auto normalOf = [&] { return glm::normalize(forNormals * pointOf(shape, "normal")); };
    switch (shape.kind) {
    case ShapeKind::Sphere: return ellipsoidOf(map(pointOf(shape, "center")), lengthOf(shape, "radius") * map.linear);
    case ShapeKind::Ellipsoid: {
        glm::dmat3 linear = map.linear * axesOf(pointOf(shape, "rotate"));
        for (int i = 0; i < 3; ++i) linear[i] *= pointOf(shape, "radii")[i];
        return ellipsoidOf(map(pointOf(shape, "center")), linear);
    }
    case ShapeKind::Plane: return makeShape(ShapeKind::Plane, {map(pointOf(shape, "point")), normalOf()});
    case ShapeKind::Disc: return discOf(shape, map, normalOf());
    case ShapeKind::Triangle:
    case ShapeKind::SmoothTriangle: return triangleOf(shape, map, forNormals);
    case ShapeKind::Torus: return torusOf(shape, map);
    case ShapeKind::Box:
    case ShapeKind::RotatedBox: {
        const bool rotated = shape.kind == ShapeKind::RotatedBox;
        glm::dmat3 linear = rotated ? map.linear * axesOf(pointOf(shape, "rotate")) : map.linear;
        for (int i = 0; i < 3; ++i) linear[i] *= pointOf(shape, "half_size")[i];
        return boxOf(shape, linear, map(pointOf(shape, "center")));
    }
    case ShapeKind::HeightPatch: return heightPatchOf(shape, map);
    case ShapeKind::SpacePatch: return spacePatchOf(mappedNet(*shape.net, map.linear), map(pointOf(shape, "anchor")));
    case ShapeKind::Cylinder:
    case ShapeKind::Capsule:
    case ShapeKind::Cone: return axialOf(shape, map);
    case ShapeKind::Solid: return solidOf(shape, map);
    case ShapeKind::Mandelbulb: return unevenly(shape, "scale it evenly");
    case ShapeKind::LargeSphere: break; // is made when all is placed
    }
    return shape;
}

/// What of a shape's numbers the format would not take.
Complaint outOfLimits(const Shape& shape) {
    if (shape.kind == ShapeKind::Solid) return {}; // read_solid.h
    for (const ShapeField& field : shapeRow(shape.kind).fields) {
        const Range range = limitsOf(field);
        if (field.type == FieldType::Rotation) continue;
        for (const double value : valuesOf(shape, field.key))
            if (!(value >= range.min && value <= range.max))
                return {std::string(field.key) + " of a " + std::string(shapeRow(shape.kind).key) + " becomes " +
                            toString(value),
                        "keep it from " + toString(range.min) + " to " + toString(range.max)};
    }
    return shapeRow(shape.kind).check(shape);
}

bool keepsSlant(const glm::dmat3& linear) { // along the axes only
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            if (i != k && linear[i][k] != 0) return false;
    return true;
}

SolidNode around(SolidNode node, double scale, const Affine& map) {
    const glm::dquat rotate = glm::normalize(glm::quat_cast(map.linear / scale));
    if (node.op == SolidOp::Transform) {
        node.translate = map(node.translate);
        node.rotate = glm::normalize(rotate * node.rotate);
        node.scale *= scale;
        return node;
    }
    SolidNode result;
    result.op = SolidOp::Transform;
    result.translate = map.translate;
    result.rotate = rotate;
    result.scale = scale;
    result.of.push_back(std::move(node));
    return result;
}

} // namespace

Affine affineOf(glm::dvec3 scale, glm::dquat rotate, glm::dvec3 translate) {
    glm::dmat3 linear = glm::mat3_cast(rotate);
    for (int i = 0; i < 3; ++i) linear[i] *= scale[i];
    return {linear, translate};
}

std::optional<double> scaleOf(const glm::dmat3& linear) {
    const glm::dvec3 lengths = lengthsOf(linear);
    const bool even = across(linear[0], linear[1]) && across(linear[1], linear[2]) && across(linear[2], linear[0]) &&
                      equal(lengths.x, lengths.y) && equal(lengths.y, lengths.z);
    return even ? std::optional(lengths.x) : std::nullopt;
}

Transformed transformed(const Shape& shape, const Affine& map) {
    Transformed result = mapped(shape, map);
    if (const Shape* mappedShape = std::get_if<Shape>(&result))
        if (Complaint complaint = outOfLimits(*mappedShape); !complaint[0].empty()) return complaint;
    return result;
}

std::variant<SolidNode, Complaint> transformed(const SolidNode& node, const Affine& map) {
    if (const auto scale = scaleOf(map.linear)) return around(node, *scale, map);
    SolidNode result = node;
    switch (node.op) {
    case SolidOp::Shape: {
        auto shape = transformed(node.shape, map);
        if (const auto* complaint = std::get_if<Complaint>(&shape)) return *complaint;
        result.shape = unoriented(std::get<Shape>(shape));
        return result;
    }
    case SolidOp::Transform: {
        const Affine inner = affineOf(glm::dvec3(node.scale), node.rotate, node.translate);
        return transformed(node.of[0], {map.linear * inner.linear, map(inner.translate)});
    }
    case SolidOp::Repetition:
        if (!keepsSlant(map.linear))
            return Complaint{"copies in rows, rotated and scaled unevenly", "scale them before they are rotated"};
        result.period = map.linear * node.period;
        break;
    case SolidOp::SmoothUnion:
    case SolidOp::Offset:
        return Complaint{"an offset or a smooth union scaled unevenly: what it grows by or melts is a distance",
                         "scale its parts instead"};
    default: break;
    }
    for (SolidNode& part : result.of) {
        auto mappedPart = transformed(part, map);
        if (const auto* complaint = std::get_if<Complaint>(&mappedPart)) return *complaint;
        part = std::get<SolidNode>(std::move(mappedPart));
    }
    return result;
}

} // namespace gnomon
