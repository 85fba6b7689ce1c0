#include "tracer/scene/scene.h"

#include <algorithm>
#include <cmath>

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

void addOnce(std::vector<std::string>& names, const std::string& name) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

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

} // namespace

bool Material::showsImages() const {
    const auto* coat = std::get_if<Coat>(&optics);
    return texture || normalMap || checker || (coat && !coat->mask.empty());
}

std::vector<Shape> shapesAt(const Scene& scene, double time) {
    return placed(scene, [time](const Orbit& orbit) { return swing(orbit, time); });
}

std::array<std::vector<Shape>, 2> outermostShapes(const Scene& scene) {
    return {placed(scene, [](const Orbit& orbit) { return -amplitude(orbit); }),
            placed(scene, [](const Orbit& orbit) { return amplitude(orbit); })};
}

bool changesWithTime(const Scene& scene) {
    const auto scrolls = [](const std::optional<TextureUse>& use) { return use && use->scroll != glm::dvec2(0); };
    return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
        const Material& material = scene.materials[std::size_t(object.material)];
        return object.motion || scrolls(material.texture) || scrolls(material.normalMap);
    });
}

std::vector<std::string> imagesOf(const Scene& scene) {
    std::vector<std::string> names;
    if (!scene.background.cubemap.empty())
        for (const char* face : {"-px", "-nx", "-py", "-ny", "-pz", "-nz"})
            addOnce(names, scene.background.cubemap + face);
    addOnce(names, scene.background.image);
    for (const Material& material : scene.materials) {
        if (material.texture) addOnce(names, material.texture->image);
        if (material.normalMap) addOnce(names, material.normalMap->image);
        if (const Coat* coat = std::get_if<Coat>(&material.optics)) addOnce(names, coat->mask);
    }
    return names;
}

} // namespace gnomon
