#include "tests/support/scene_rays.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gnomon::test {

using namespace oracle;

SceneRays::SceneRays(const Scene& scene, const SceneOracle& oracle, std::uint64_t seed)
    : scene_(scene), oracle_(oracle), dice_(seed) {}

std::vector<BatchRay> SceneRays::primary(int count) {
    constexpr int kTogether = 32; // neighbours share a camera or an object
    std::vector<BatchRay> rays;
    while (int(rays.size()) < count) {
        const double which = dice_.number(0, 1);
        if (which < 0.4)
            addView(rays, kTogether);
        else if (which < 0.8)
            addAbout(rays, kTogether);
        else
            addBetween(rays, kTogether);
    }
    rays.resize(std::size_t(count));
    return rays;
}

SceneRays::Ball SceneRays::ballOf(int object) const {
    const Shape& shape = oracle_.shapeOf(object);
    if (shape.solid) return {pointOf(shape, "center"), lengthOf(shape, "radius")};
    const ExactShape<double> exact(shape);
    const auto middle = exact.middle();
    return {{double(middle.x), double(middle.y), double(middle.z)}, exact.size()};
}

/// Of any kind: a scene may have sixty triangles and one solid.
int SceneRays::anyObject() {
    std::vector<int> begins;
    for (int i = 0; i < int(oracle_.objects()); ++i)
        if (i == 0 || oracle_.kindOf(i) != oracle_.kindOf(i - 1)) begins.push_back(i);
    begins.push_back(int(oracle_.objects()));
    const auto kind = std::size_t(dice_.number(0, double(begins.size() - 1)));
    return begins[kind] + int(dice_.number(0, begins[kind + 1] - begins[kind]));
}

glm::dvec3 SceneRays::direction() {
    for (;;) {
        const glm::dvec3 p = dice_.point(1);
        const double length = glm::length(p);
        if (length > 0.01 && length <= 1) return p / length;
    }
}

BatchRay SceneRays::towards(glm::dvec3 from, glm::dvec3 to) const {
    BatchRay ray;
    ray.origin = glm::vec3(from);
    ray.direction = glm::vec3(glm::normalize(to - glm::dvec3(ray.origin)));
    return ray;
}

void SceneRays::addView(std::vector<BatchRay>& rays, int count) {
    const Ball ball = ballOf(anyObject());
    const double reach = std::min(ball.radius, 5.0), which = dice_.number(0, 1);
    const glm::dvec3 target = ball.radius > 100 ? dice_.point(2) : ball.center + dice_.point(reach);
    const glm::dvec3 eye = which < 0.2   ? scene_.camera.eye
                           : which < 0.5 ? dice_.point(3) // from among the objects, also from inside
                           : which < 0.8 ? target + direction() * std::pow(10, dice_.number(0, 4))
                                         : target + direction() * reach * std::pow(10, dice_.number(-4, 0));
    const double wide = std::pow(10, dice_.number(-5, 0)) * glm::distance(eye, target);
    for (int i = 0; i < count; ++i) rays.push_back(towards(eye, target + dice_.point(1) * wide));
}

void SceneRays::addAbout(std::vector<BatchRay>& rays, int count) {
    constexpr double kDistances[] = {3, 10, 100, 1000, 10000};
    const int object = anyObject();
    const Shape& shape = oracle_.shapeOf(object);
    if (shape.solid || oracle_.kindOf(object) == ShapeKind::LargeSphere) return addBetween(rays, count);
    const Subject subject{shapeRow(shape.kind).key, "", inFloat(shape)};
    const RayClass kind = kRayClasses[std::size_t(dice_.number(0, double(kRayClasses.size())))];
    if (!fits(kind, subject)) return addBetween(rays, count);
    const double distance = kDistances[std::size_t(dice_.number(0, double(std::size(kDistances))))];
    RayStream stream(subject.geometry, kind, distance, std::uint64_t(dice_.number(0, 1e15)));
    for (int i = 0; i < count; ++i) rays.push_back(stream.next());
}

void SceneRays::addBetween(std::vector<BatchRay>& rays, int count) {
    for (int i = 0; i < count; ++i) {
        const Ball ball = ballOf(anyObject());
        const glm::dvec3 target = ball.radius > 100 ? dice_.point(3) : ball.center + dice_.point(ball.radius);
        BatchRay ray = towards(dice_.point(4), target);
        if (dice_.number(0, 1) < 0.1) { // along faces
            ray.direction = glm::vec3(0);
            ray.direction[int(dice_.number(0, 3))] = dice_.number(0, 1) < 0.5 ? 1 : -1;
        }
        rays.push_back(ray);
    }
}

std::vector<BatchRay> SceneRays::secondary(const std::vector<BatchRay>& rays, const std::vector<BatchHit>& hits) {
    constexpr double kFar = 1e5; // docs/numerics.md promises as many sizes
    std::vector<BatchRay> more;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const glm::dvec3 point(hits[i].point), d(rays[i].direction);
        if (hits[i].object < 0 || glm::length(point) > kFar) continue;
        glm::dvec3 n(hits[i].normal);
        if (glm::dot(n, d) > 0) n = -n;
        const double which = dice_.number(0, 1);
        glm::dvec3 way = direction();
        if (which < 0.3) way = glm::reflect(d, n);
        if (which >= 0.3 && which < 0.5) way = glm::normalize(d - dice_.number(-0.3, 0.3) * n);
        if (which >= 0.5 && which < 0.7 && !scene_.lights.empty())
            way = glm::normalize(scene_.lights[std::size_t(dice_.number(0, double(scene_.lights.size())))].position -
                                 point);
        BatchRay ray;
        ray.origin = hits[i].point;
        ray.direction = glm::vec3(way);
        ray.side = (glm::dot(ray.direction, hits[i].normal) < 0 ? -1.0f : 1.0f) * float(1 + hits[i].object);
        ray.tMin = -1; // as the integrator has it
        more.push_back(ray);
    }
    return more;
}

} // namespace gnomon::test
