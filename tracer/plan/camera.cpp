#include "tracer/plan/camera.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace gnomon {

namespace {

constexpr double kSteepest = 0.01, kDeepest = 3.13;

/// Unit vector along `v`, or `otherwise` where it has no direction.
glm::dvec3 unit(glm::dvec3 v, glm::dvec3 otherwise) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

/// Axes of a world whose up is `up`: for +y the usual x, y, z.
glm::dmat3 worldOf(glm::dvec3 up) {
    const glm::dvec3 other = std::abs(up.z) < 0.9 ? glm::dvec3{0, 0, 1} : glm::dvec3{0, -1, 0};
    const glm::dvec3 x = glm::normalize(glm::cross(up, other));
    return {x, up, glm::cross(x, up)};
}

double halfHeightOf(double fov) { return std::tan(glm::radians(fov) / 2); }

} // namespace

CameraFrame frameOf(const CameraPose& pose) {
    const glm::dvec3 forward = unit(pose.target - pose.eye, {0, 0, -1});
    const glm::dvec3 up = unit(pose.up, {0, 1, 0});
    // Nearly along `up` the product is rounding noise, and any right that is level will do.
    const glm::dvec3 level = glm::cross(forward, up);
    const glm::dvec3 right = glm::length(level) > 1e-7 ? glm::normalize(level) : worldOf(up)[0];
    return {pose.eye, forward, right, glm::cross(right, forward), halfHeightOf(pose.fov)};
}

void Camera::setPose(const CameraPose& pose) {
    up_ = unit(pose.up, {0, 1, 0});
    const glm::dvec3 ahead = pose.target - pose.eye;
    const glm::dvec3 direction = glm::transpose(worldOf(up_)) * unit(ahead, {0, 0, -1});
    eye_ = pose.eye;
    u_ = std::atan2(direction.x, -direction.z);
    // From both components: acos alone would lose half the digits near the poles.
    v_ = std::clamp(std::atan2(std::hypot(direction.x, direction.z), direction.y), kSteepest, kDeepest);
    fov_ = pose.fov;
    reach_ = glm::length(ahead) > 0 ? glm::length(ahead) : 1;
}

CameraPose Camera::pose() const {
    const glm::dvec3 direction{std::sin(v_) * std::sin(u_), std::cos(v_), -std::sin(v_) * std::cos(u_)};
    return {eye_, eye_ + reach_ * (worldOf(up_) * direction), up_, fov_};
}

void Camera::look(double right, double up) {
    u_ = std::remainder(u_ + right, 2 * glm::pi<double>());
    v_ = std::clamp(v_ - up, kSteepest, kDeepest);
}

void Camera::drag(double dx, double dy, double height) {
    if (!(height > 0)) return;
    const double perPixel = 2 * halfHeightOf(fov_) / height;
    // Towards the poles a turn about the world's up moves the view less; not followed all the way, where it would spin.
    const double widening = std::max(std::sin(v_), 0.3);
    look(-std::atan(dx * perPixel) / widening, std::atan(dy * perPixel));
}

void Camera::move(glm::dvec3 forwardRightUp) {
    const CameraFrame frame = frameOf(pose());
    eye_ += glm::dmat3(frame.forward, frame.right, frame.up) * forwardRightUp;
}

void Camera::zoom(double ratio) {
    if (ratio > 0) move({reach_ * (1 - 1 / ratio), 0, 0});
}

void Camera::pan(double dx, double dy, double height) {
    if (!(height > 0)) return;
    const double perPixel = 2 * halfHeightOf(fov_) * reach_ / height;
    move({0, -dx * perPixel, dy * perPixel});
}

} // namespace gnomon
