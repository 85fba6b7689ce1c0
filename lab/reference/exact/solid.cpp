#include "lab/reference/exact/solid.h"

#include "lab/reference/exact/exact_shape.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace gnomon::oracle {
namespace {

/// z^power as the bulb has it: both angles, the first from +y, the second about y from +z, are multiplied.
glm::dvec3 powerOf(glm::dvec3 z, double power) {
    const double r = glm::length(z);
    if (r == 0) return z;
    const std::complex<double> polar(z.y, std::hypot(z.x, z.z)), round(z.z, z.x);
    const double theta = power * std::arg(polar), phi = power * std::arg(round);
    return std::pow(r, power) *
           glm::dvec3(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
}

double estimateOf(const Shape& bulb, glm::dvec3 p) {
    const double radius = lengthOf(bulb, "radius"), power = lengthOf(bulb, "power");
    const glm::dvec3 c = (p - pointOf(bulb, "center")) / radius;
    glm::dvec3 z = c;
    double slope = 1;
    for (int i = 0; i < int(lengthOf(bulb, "iterations")) && glm::length(z) <= 2; ++i) {
        slope = power * std::pow(glm::length(z), power - 1) * slope + 1;
        z = powerOf(z, power) + c;
    }
    const double r = std::max(glm::length(z), 1e-12);
    return radius * std::max(std::min(0.5 * std::log(r) * r / slope, 1.0), glm::length(c) - 1.25);
}

double distanceOf(const Shape& shape, glm::dvec3 p) {
    if (shape.kind == ShapeKind::Mandelbulb) return estimateOf(shape, p);
    const ExactShape<double> exact(shape, Values::OfTheScene);
    const auto middle = exact.middle();
    return exact.boundedDistance({p.x - double(middle.x), p.y - double(middle.y), p.z - double(middle.z)});
}

double melted(double a, double b, double blend) {
    const double overlap = std::max(blend - std::abs(a - b), 0.0) / blend;
    return std::min(a, b) - overlap * overlap * blend / 4;
}

double repeatedField(const SolidNode& node, glm::dvec3 p) {
    double least = 1e30;
    for (int i = 0; i < int(node.count.x); ++i)
        for (int j = 0; j < int(node.count.y); ++j)
            for (int k = 0; k < int(node.count.z); ++k)
                least = std::min(least, fieldOf(node.of[0], p - node.period * glm::dvec3(i, j, k)));
    return least;
}

} // namespace

double fieldOf(const SolidNode& node, glm::dvec3 p) {
    switch (node.op) {
    case SolidOp::Shape: return distanceOf(node.shape, p);
    case SolidOp::Offset: return fieldOf(node.of[0], p) - node.amount;
    case SolidOp::Transform:
        return node.scale * fieldOf(node.of[0], glm::inverse(node.rotate) * (p - node.translate) / node.scale);
    case SolidOp::Repetition: return repeatedField(node, p);
    default: break;
    }
    double field = fieldOf(node.of[0], p);
    for (std::size_t i = 1; i < node.of.size(); ++i) {
        const double other = fieldOf(node.of[i], p);
        if (node.op == SolidOp::Union) field = std::min(field, other);
        if (node.op == SolidOp::Intersection) field = std::max(field, other);
        if (node.op == SolidOp::Difference) field = std::max(field, -other);
        if (node.op == SolidOp::SmoothUnion) field = melted(field, other, node.amount);
    }
    return field;
}

} // namespace gnomon::oracle
