#include "tracer/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon {

namespace {

glm::dvec3 swing(const Orbit& orbit, double time) {
    return orbit.cos * std::cos(orbit.rate * time) + orbit.sin * std::sin(orbit.rate * time);
}

/// The object that `index` moves around, or -1.
int centreOf(const Scene& scene, int index) {
    const Object& object = scene.objects[std::size_t(index)];
    const int around = object.motion ? object.motion->around : -1;
    return around >= 0 && around < int(scene.objects.size()) ? around : -1;
}

/// How far a point is from the surface of a sphere.
double heightAbove(const Shape& sphere, glm::dvec3 point) {
    return std::abs(glm::distance(point, pointOf(sphere, "center")) - lengthOf(sphere, "radius"));
}

void addOnce(std::vector<std::string>& names, const std::string& name) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

} // namespace

std::vector<Shape> shapesAt(const Scene& scene, double time) {
    enum class State : char { Resting, OnTheWay, Placed };
    std::vector<Shape> shapes(scene.objects.size());
    std::vector<State> states(scene.objects.size(), State::Resting);
    // An object, what it moves around, what that moves around, …: the file may name them in any order.
    std::vector<int> chain;

    for (int first = 0; first < int(scene.objects.size()); ++first) {
        for (int i = first; i >= 0 && states[std::size_t(i)] == State::Resting; i = centreOf(scene, i)) {
            states[std::size_t(i)] = State::OnTheWay;
            chain.push_back(i);
        }
        for (; !chain.empty(); chain.pop_back()) {
            const std::size_t i = std::size_t(chain.back());
            const Object& object = scene.objects[i];
            const int around = centreOf(scene, int(i));
            shapes[i] = object.shape;
            if (object.motion) shapes[i] = translated(shapes[i], swing(*object.motion, time));
            // Only a circle, which the reader refuses, leaves the centre unplaced here.
            if (around >= 0 && states[std::size_t(around)] == State::Placed)
                shapes[i] = translated(shapes[i], referencePoint(shapes[std::size_t(around)]));
            states[i] = State::Placed;
        }
    }
    return shapes;
}

std::vector<ShapeKind> drawnKinds(const Scene& scene) {
    constexpr double kHuge = 100;
    const std::vector<Shape> shapes = shapesAt(scene, 0);
    double least = std::numeric_limits<double>::infinity();
    for (const Shape& shape : shapes) least = std::min(least, sizeOf(shape));
    std::vector<ShapeKind> kinds;
    kinds.reserve(shapes.size());
    for (const Shape& shape : shapes) {
        const bool huge = shape.kind == ShapeKind::Sphere &&
                          lengthOf(shape, "radius") > kHuge * std::min(least, heightAbove(shape, scene.camera.eye));
        kinds.push_back(huge ? ShapeKind::Globe : shape.kind);
    }
    return kinds;
}

std::vector<std::string> imagesOf(const Scene& scene) {
    std::vector<std::string> names;
    if (!scene.background.cubemap.empty())
        for (const char* face : {"-px", "-nx", "-py", "-ny", "-pz", "-nz"})
            addOnce(names, scene.background.cubemap + face);
    for (const Material& material : scene.materials) {
        if (material.texture) addOnce(names, material.texture->image);
        if (material.normalMap) addOnce(names, material.normalMap->image);
        if (const Coat* coat = std::get_if<Coat>(&material.optics)) addOnce(names, coat->mask);
    }
    return names;
}

} // namespace gnomon
