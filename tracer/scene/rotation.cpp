#include "tracer/scene/rotation.h"

namespace gnomon {

glm::dquat rotationOfDegrees(glm::dvec3 degrees) {
    const auto about = [&](int axis) {
        glm::dvec3 unit{0};
        unit[axis] = 1;
        return glm::angleAxis(glm::radians(degrees[axis]), unit);
    };
    return about(2) * about(1) * about(0);
}

glm::dvec3 rodriguesOf(glm::dquat q) {
    q = glm::normalize(q.w < 0 ? -q : q);
    return glm::dvec3(q.x, q.y, q.z) / (1 + q.w);
}

glm::dmat3 axesOf(glm::dvec3 rodrigues) {
    const double square = glm::dot(rodrigues, rodrigues);
    const glm::dvec3 v = 2.0 / (1 + square) * rodrigues;
    return glm::mat3_cast(glm::dquat((1 - square) / (1 + square), v.x, v.y, v.z));
}

} // namespace gnomon
