#include "tracer/plan/drawn.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double largest(glm::dvec3 v) { return std::max({v.x, v.y, v.z}); }

/// How far a point is from the surface of a sphere.
double heightAbove(const Shape& sphere, glm::dvec3 point) {
    return std::abs(glm::distance(point, pointOf(sphere, "center")) - lengthOf(sphere, "radius"));
}

Shape largeSphereOf(const Shape& sphere, glm::dvec3 eye) {
    const glm::dvec3 center = pointOf(sphere, "center");
    const double radius = lengthOf(sphere, "radius"), distance = glm::distance(eye, center);
    const glm::dvec3 towardsEye = distance > 0 ? (eye - center) / distance : glm::dvec3(0, 1, 0);
    // The anchor is a point that float32 holds; all else is worked out for it, so that its rounding moves nothing.
    const glm::dvec3 nearest = center + radius * towardsEye;
    const glm::dvec3 anchor{inFloat(nearest.x), inFloat(nearest.y), inFloat(nearest.z)};
    const double reach = glm::distance(anchor, center);
    const double height = (reach - radius) * (reach + radius) / (2 * reach);
    return makeShape(ShapeKind::LargeSphere, {anchor, (anchor - center) / reach}, {1 / reach, height});
}

/// All that bounded objects, large spheres aside, ever touch; empty, from infinity to -infinity, where there are none.
Extent bounded(const Scene& scene) {
    Extent box{glm::dvec3(kInfinity), glm::dvec3(-kInfinity)};
    const std::vector<ShapeKind> kinds = drawnKinds(scene);
    for (const std::vector<Shape>& shapes : outermostShapes(scene))
        for (std::size_t i = 0; i < shapes.size(); ++i)
            if (const auto extent = shapeRow(kinds[i]).extent) {
                const Extent own = extent(shapes[i]);
                box.low = glm::min(box.low, own.low);
                box.high = glm::max(box.high, own.high);
            }
    return box;
}

/// The least power of two above x > 0; 0 of 0.
double powerOfTwoAbove(double x) {
    int exponent = 0;
    return std::frexp(x, &exponent) > 0 ? std::ldexp(1.0, exponent) : 0;
}

} // namespace

std::vector<ShapeKind> drawnKinds(const Scene& scene) {
    constexpr double kHuge = 100;
    const std::vector<Shape> shapes = shapesAt(scene, 0);
    double least = kInfinity;
    for (const Shape& shape : shapes) least = std::min(least, sizeOf(shape));
    std::vector<ShapeKind> kinds;
    kinds.reserve(shapes.size());
    for (const Shape& shape : shapes) {
        const bool huge = shape.kind == ShapeKind::Sphere &&
                          lengthOf(shape, "radius") > kHuge * std::min(least, heightAbove(shape, scene.camera.eye));
        kinds.push_back(huge ? ShapeKind::LargeSphere : shape.kind);
    }
    return kinds;
}

Shape drawnAs(ShapeKind kind, const Shape& shape, glm::dvec3 eye) {
    return kind == ShapeKind::LargeSphere ? largeSphereOf(shape, eye) : shape;
}

glm::dvec3 originOf(const Scene& scene) {
    const CameraPose& camera = scene.camera;
    const Extent box = bounded(scene);
    const double reach = largest(0.5 * (box.high - box.low));
    const bool any = reach >= 0;
    const glm::dvec3 middle = any ? 0.5 * (box.low + box.high) : camera.eye;
    const glm::dvec3 other = any ? camera.eye : camera.target;
    const double step = powerOfTwoAbove(std::max(8 * reach, 2 * largest(glm::abs(other - middle))));
    if (step == 0) return glm::dvec3(0);
    return glm::trunc(middle / step) * step + 0.0; // + 0: never -0, which would turn a coordinate of -0 into 0
}

} // namespace gnomon
