#include "tracer/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon {

namespace {

glm::dvec3 swing(const Orbit& orbit, double time) {
    return orbit.cos * std::cos(orbit.rate * time) + orbit.sin * std::sin(orbit.rate * time);
}

/// The farthest that an orbit takes an object along each axis.
glm::dvec3 amplitude(const Orbit& orbit) { return glm::sqrt(orbit.cos * orbit.cos + orbit.sin * orbit.sin); }

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

double largest(glm::dvec3 v) { return std::max({v.x, v.y, v.z}); }

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
    glm::dvec3 middle() const { return 0.5 * (low + high); }
    double reach() const { return largest(0.5 * (high - low)); }
};

/// Every object's shape where `swing` of its orbit is how far it has moved from where it rests.
template<typename Swing>
std::vector<Shape> placed(const Scene& scene, Swing swing) {
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
            if (object.motion) shapes[i] = translated(shapes[i], swing(*object.motion));
            // Only a circle, which the reader refuses, leaves the centre unplaced here.
            if (around >= 0 && states[std::size_t(around)] == State::Placed)
                shapes[i] = translated(shapes[i], referencePoint(shapes[std::size_t(around)]));
            states[i] = State::Placed;
        }
    }
    return shapes;
}

/// All that bounded objects, large spheres aside, ever touch; empty, with a reach of -infinity, where there are none.
Box bounded(const Scene& scene) {
    Box box;
    const std::vector<ShapeKind> kinds = drawnKinds(scene);
    for (const double way : {-1.0, 1.0}) {
        const auto shapes = placed(scene, [way](const Orbit& orbit) { return way * amplitude(orbit); });
        for (std::size_t i = 0; i < shapes.size(); ++i)
            if (const auto extent = shapeRow(kinds[i]).extent) {
                const Extent own = extent(shapes[i]);
                box.low = glm::min(box.low, own.low);
                box.high = glm::max(box.high, own.high);
            }
    }
    return box;
}

/// The least power of two above x > 0; 0 of 0.
double powerOfTwoAbove(double x) {
    int exponent = 0;
    return std::frexp(x, &exponent) > 0 ? std::ldexp(1.0, exponent) : 0;
}

} // namespace

bool Material::showsImages() const {
    const auto* coat = std::get_if<Coat>(&optics);
    return texture || normalMap || (coat && !coat->mask.empty());
}

std::vector<Shape> shapesAt(const Scene& scene, double time) {
    return placed(scene, [time](const Orbit& orbit) { return swing(orbit, time); });
}

bool changesWithTime(const Scene& scene) {
    const auto scrolls = [](const std::optional<TextureUse>& use) { return use && use->scroll != glm::dvec2(0); };
    return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
        const Material& material = scene.materials[std::size_t(object.material)];
        return object.motion || scrolls(material.texture) || scrolls(material.normalMap);
    });
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
        kinds.push_back(huge ? ShapeKind::LargeSphere : shape.kind);
    }
    return kinds;
}

glm::dvec3 originOf(const Scene& scene) {
    const CameraPose& camera = scene.camera;
    const Box box = bounded(scene);
    const bool any = box.reach() >= 0;
    const glm::dvec3 middle = any ? box.middle() : camera.eye;
    const glm::dvec3 other = any ? camera.eye : camera.target;
    const double step = powerOfTwoAbove(std::max(8 * box.reach(), 2 * largest(glm::abs(other - middle))));
    if (step == 0) return glm::dvec3(0);
    return glm::trunc(middle / step) * step + 0.0; // + 0: never -0, which would turn a coordinate of -0 into 0
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
