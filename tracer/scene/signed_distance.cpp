#include "tracer/scene/signed_distance.h"

#include "tracer/scene/rotation.h"
#include "tracer/scene/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Of a box about 0 with such half sides.
double boxDistance(glm::dvec3 p, glm::dvec3 half) {
    const glm::dvec3 over = glm::abs(p) - half;
    return glm::length(glm::max(over, 0.0)) + std::min(std::max({over.x, over.y, over.z}), 0.0);
}

/// To the nearest point x of an ellipsoid about 0, x_i = r_i^2 p_i / (s + r_i^2): s is the one that puts x on it, and
/// lies above -r^2 of the shortest radius.
double ellipsoidDistance(glm::dvec3 p, glm::dvec3 radii) {
    p = glm::abs(p);
    const glm::dvec3 squares = radii * radii;
    const double shortest = std::min({squares.x, squares.y, squares.z});
    const auto nearest = [&](double s) { return squares * p / glm::max(s + squares, 1e-300); };
    const auto beyond = [&](double s) { return glm::length(nearest(s) / radii) > 1; };
    double low = -shortest, high = glm::length(radii * p);
    for (int i = 0; i < 200 && low < high; ++i) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) break;
        (beyond(middle) ? low : high) = middle;
    }
    glm::dvec3 x = nearest(high);
    // On the plane through the middle across the shortest radius the nearest point lies off it, on either side.
    const double left = 1 - glm::dot(x / radii, x / radii);
    for (int i = 0; i < 3; ++i)
        if (squares[i] == shortest && p[i] <= 1e-12 * radii[i] && left > 0) {
            x[i] = radii[i] * std::sqrt(left);
            break;
        }
    return glm::length(p / radii) < 1 ? -glm::distance(p, x) : glm::distance(p, x);
}

double segmentDistance(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const double part = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::distance(p, a + part * (b - a));
}

double segmentDistance(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
    const double part = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::distance(p, a + part * (b - a));
}

/// Flat shapes have no inside: never negative.
double triangleDistance(const Shape& triangle, glm::dvec3 p) {
    const glm::dvec3 a = vertexOf(triangle, 0),
                     normal = glm::normalize(glm::cross(vertexOf(triangle, 1) - a, vertexOf(triangle, 2) - a));
    bool over = true;
    double rim = kInfinity;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 from = vertexOf(triangle, i), to = vertexOf(triangle, (i + 1) % 3);
        over = over && glm::dot(glm::cross(normal, to - from), p - from) >= 0;
        rim = std::min(rim, segmentDistance(p, from, to));
    }
    return over ? std::abs(glm::dot(p - a, normal)) : rim;
}

/// Of a point from an axis through `middle`: radial distance, and along it.
glm::dvec2 profile(glm::dvec3 p, glm::dvec3 middle, glm::dvec3 axis) {
    const double along = glm::dot(p - middle, axis);
    return {glm::length(p - middle - along * axis), along};
}

double torusDistance(const Shape& torus, glm::dvec3 p) {
    const glm::dvec2 at = profile(p, pointOf(torus, "center"), glm::normalize(pointOf(torus, "axis")));
    return std::hypot(at.x - lengthOf(torus, "major_radius"), at.y) - lengthOf(torus, "minor_radius");
}

double discDistance(const Shape& disc, glm::dvec3 p) {
    const glm::dvec2 at = profile(p, pointOf(disc, "center"), glm::normalize(pointOf(disc, "normal")));
    return std::hypot(std::max(at.x - lengthOf(disc, "radius"), 0.0), at.y);
}

/// Cylinder, capsule, cone.
double axialDistance(const Shape& shape, glm::dvec3 p) {
    const glm::dvec3 from = pointOf(shape, "from"), to = pointOf(shape, "to");
    const double radius = lengthOf(shape, "radius"), half = 0.5 * glm::distance(from, to);
    const glm::dvec2 at = profile(p, 0.5 * (from + to), glm::normalize(to - from));
    if (shape.kind == ShapeKind::Cylinder) return boxDistance({at, 0}, {radius, half, kInfinity});
    if (shape.kind == ShapeKind::Capsule) return std::hypot(at.x, std::max(std::abs(at.y) - half, 0.0)) - radius;
    const bool inside = std::abs(at.y) < half && at.x * 2 * half < radius * (half - at.y);
    const glm::dvec2 rim(radius, -half);
    const double distance = std::min(segmentDistance(at, {0, -half}, rim), segmentDistance(at, rim, {0, half}));
    return inside ? -distance : distance;
}

/// The estimate's sign: shaders/primitive/mandelbulb.glsl.
double mandelbulbDistance(const Shape& bulb, glm::dvec3 p) {
    const double power = lengthOf(bulb, "power");
    const glm::dvec3 c = (p - pointOf(bulb, "center")) / lengthOf(bulb, "radius");
    glm::dvec3 z = c;
    for (int i = 0; i < int(lengthOf(bulb, "iterations")) && glm::length(z) <= 2; ++i) {
        const double r = glm::length(z), theta = power * std::acos(r > 0 ? std::clamp(z.y / r, -1.0, 1.0) : 1.0);
        const double phi = power * std::atan2(z.x, z.z);
        z = std::pow(r, power) *
                glm::dvec3(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)) +
            c;
    }
    return lengthOf(bulb, "radius") * (glm::length(z) - 1);
}

double fieldOf(const SolidNode&, glm::dvec3 p);

double repeatedField(const SolidNode& node, glm::dvec3 p) {
    double least = kInfinity;
    for (int i = 0; i < int(node.count.x); ++i)
        for (int j = 0; j < int(node.count.y); ++j)
            for (int k = 0; k < int(node.count.z); ++k)
                least = std::min(least, fieldOf(node.of[0], p - node.period * glm::dvec3(i, j, k)));
    return least;
}

double combined(const SolidNode& node, double field, double other) {
    const double overlap = std::max(node.amount - std::abs(field - other), 0.0);
    switch (node.op) {
    case SolidOp::Intersection: return std::max(field, other);
    case SolidOp::Difference: return std::max(field, -other);
    case SolidOp::SmoothUnion: return std::min(field, other) - overlap * overlap / (4 * node.amount);
    default: return std::min(field, other);
    }
}

double fieldOf(const SolidNode& node, glm::dvec3 p) {
    switch (node.op) {
    case SolidOp::Shape: return signedDistance(node.shape, p);
    case SolidOp::Offset: return fieldOf(node.of[0], p) - node.amount;
    case SolidOp::Transform:
        return node.scale * fieldOf(node.of[0], glm::inverse(node.rotate) * (p - node.translate) / node.scale);
    case SolidOp::Repetition: return repeatedField(node, p);
    default: break;
    }
    double field = fieldOf(node.of[0], p);
    for (std::size_t i = 1; i < node.of.size(); ++i) field = combined(node, field, fieldOf(node.of[i], p));
    return field;
}

} // namespace

bool boundsBody(ShapeKind kind) {
    return kind != ShapeKind::Disc && kind != ShapeKind::Triangle && kind != ShapeKind::SmoothTriangle &&
           kind != ShapeKind::HeightPatch && kind != ShapeKind::SpacePatch;
}

double signedDistance(const Shape& shape, glm::dvec3 p) {
    const auto alongAxes = [&] {
        return (p - pointOf(shape, "center")) * axesOf(pointOf(shape, "rotate")); // by the transposed matrix
    };
    switch (shape.kind) {
    case ShapeKind::Sphere: return glm::distance(p, pointOf(shape, "center")) - lengthOf(shape, "radius");
    case ShapeKind::Plane: return glm::dot(p - pointOf(shape, "point"), glm::normalize(pointOf(shape, "normal")));
    case ShapeKind::Torus: return torusDistance(shape, p);
    case ShapeKind::Box: return boxDistance(p - pointOf(shape, "center"), pointOf(shape, "half_size"));
    case ShapeKind::RotatedBox: return boxDistance(alongAxes(), pointOf(shape, "half_size"));
    case ShapeKind::Ellipsoid: return ellipsoidDistance(alongAxes(), pointOf(shape, "radii"));
    case ShapeKind::Cylinder:
    case ShapeKind::Capsule:
    case ShapeKind::Cone: return axialDistance(shape, p);
    case ShapeKind::Mandelbulb: return mandelbulbDistance(shape, p);
    case ShapeKind::Solid: return fieldOf(shape.solid->root, p - (pointOf(shape, "center") - shape.home));
    case ShapeKind::Disc: return discDistance(shape, p);
    case ShapeKind::Triangle:
    case ShapeKind::SmoothTriangle: return triangleDistance(shape, p);
    case ShapeKind::HeightPatch: // are no part of a solid and bound no body
    case ShapeKind::SpacePatch:
    case ShapeKind::LargeSphere: break; // that is only how a sphere is drawn
    }
    return kInfinity;
}

} // namespace gnomon
