#include "lab/reference/exact/fan.h"

#include <cmath>

namespace gnomon::oracle {
namespace {
constexpr int kSpokes = 6;
}

Fan::Fan(glm::dvec3 middle) : middle_(middle) {
    for (int i = 0; i < kSpokes; ++i) {
        const double angle = 6.283185307179586 * i / kSpokes;
        rim_.emplace_back(middle + glm::dvec3(std::cos(angle), std::sin(angle), number(-0.3, 0.3)));
    }
    for (int i = 0; i < kSpokes; ++i) {
        const glm::vec3 vertices[] = {middle_, rim_[i], rim_[(i + 1) % kSpokes]};
        triangles_.push_back(makeShape(ShapeKind::Triangle, {vertices[0], vertices[1], vertices[2]}));
    }
}

BatchRay Fan::next(double distance) {
    const float along = asked_ % 4 == 0 ? 0.0f : float(number(0, 0.9));
    const glm::vec3 aim = middle_ + along * (rim_[std::size_t(asked_ % kSpokes)] - middle_);
    ++asked_;
    // The direction is a difference of floats: edges are met as exactly as they can be.
    const glm::dvec3 away(number(-0.3, 0.3), number(-0.3, 0.3), number(0.5, 1.0));
    BatchRay ray;
    ray.origin = aim + glm::vec3(distance * away);
    ray.direction = glm::normalize(aim - ray.origin);
    return ray;
}

} // namespace gnomon::oracle
