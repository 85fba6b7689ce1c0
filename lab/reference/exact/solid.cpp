#include "lab/reference/exact/solid.h"

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

double melted(double a, double b, double blend) {
    const double overlap = std::max(blend - std::abs(a - b), 0.0) / blend;
    return std::min(a, b) - overlap * overlap * blend / 4;
}

} // namespace

SolidField::SolidField(const SolidNode& node) : node_(node) {
    node_.of.clear();
    for (const SolidNode& part : node.of) of_.emplace_back(part);
    if (node.op == SolidOp::Shape && node.shape.kind != ShapeKind::Mandelbulb)
        shape_.emplace(node.shape, Values::OfTheScene);
    if (node.op == SolidOp::Transform) back_ = glm::mat3_cast(glm::inverse(node.rotate)) / node.scale;
}

double SolidField::ofShape(glm::dvec3 p) const {
    if (!shape_) return estimateOf(node_.shape, p);
    const auto& middle = shape_->middle();
    return shape_->boundedDistance({p.x - double(middle.x), p.y - double(middle.y), p.z - double(middle.z)});
}

double SolidField::ofCopies(glm::dvec3 p) const {
    double least = 1e30;
    for (int i = 0; i < int(node_.count.x); ++i)
        for (int j = 0; j < int(node_.count.y); ++j)
            for (int k = 0; k < int(node_.count.z); ++k)
                least = std::min(least, of_[0].at(p - node_.period * glm::dvec3(i, j, k)));
    return least;
}

double SolidField::at(glm::dvec3 p) const {
    switch (node_.op) {
    case SolidOp::Shape: return ofShape(p);
    case SolidOp::Offset: return of_[0].at(p) - node_.amount;
    case SolidOp::Transform: return node_.scale * of_[0].at(back_ * (p - node_.translate));
    case SolidOp::Repetition: return ofCopies(p);
    default: break;
    }
    double field = of_[0].at(p);
    for (std::size_t i = 1; i < of_.size(); ++i) {
        const double other = of_[i].at(p);
        if (node_.op == SolidOp::Union) field = std::min(field, other);
        if (node_.op == SolidOp::Intersection) field = std::max(field, other);
        if (node_.op == SolidOp::Difference) field = std::max(field, -other);
        if (node_.op == SolidOp::SmoothUnion) field = melted(field, other, node_.amount);
    }
    return field;
}

} // namespace gnomon::oracle
