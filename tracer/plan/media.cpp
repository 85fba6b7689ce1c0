#include "tracer/plan/media.h"

#include "tracer/scene/signed_distance.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace gnomon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Body {
    int object = 0, material = 0; ///< the first object of a skin
    bool skin = false;
    bool clear = true;             ///< a dielectric; else it reflects as what lies about it has it
    double priority = 0, size = 0; ///< size: of the box about it at rest
    std::optional<Extent> swept;   ///< all that it ever touches; none for what has no end
};

Extent hull(const Extent& a, const Extent& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

std::optional<Extent> extentOf(const Shape& shape) {
    const auto extent = shapeRow(shape.kind).extent;
    return extent ? std::optional(extent(shape)) : std::nullopt;
}

/// The diagonal of the box about it. Of those that just fit into one box a box contains the others, and then a
/// cylinder.
double sizeOfBody(const Shape& shape) {
    const auto extent = extentOf(shape);
    const double fills = shape.kind == ShapeKind::Box ? 2 : shape.kind == ShapeKind::Cylinder ? 1 : 0;
    return extent ? glm::distance(extent->low, extent->high) * (1 + 1e-6 * fills) : kInfinity;
}

/// `slack` is the room for rounding.
bool meet(const Extent& a, const Extent& b, double slack) {
    const glm::dvec3 room = slack * (glm::max(glm::abs(a.low), glm::abs(a.high)) + (a.high - a.low) + (b.high - b.low));
    if (glm::any(glm::greaterThan(a.low, b.high + room)) || glm::any(glm::greaterThan(b.low, a.high + room)))
        return false;
    return true;
}

/// The ball about a box's middle that holds the body: of a resting sphere the sphere itself.
double ballRadius(const Body& body, const Scene& scene) {
    const Object& object = scene.objects[std::size_t(body.object)];
    if (object.shape.kind == ShapeKind::Sphere && !object.motion) return lengthOf(object.shape, "radius");
    return 0.5 * glm::distance(body.swept->low, body.swept->high);
}

bool reachesBehind(const Extent& box, const Shape& plane, double slack) {
    const glm::dvec3 normal = pointOf(plane, "normal"), middle = 0.5 * (box.low + box.high) - pointOf(plane, "point");
    const double reach = glm::dot(glm::abs(normal), 0.5 * (box.high - box.low));
    return glm::dot(normal, middle) <= (1 + slack) * reach;
}

/// Whether two bodies may ever have a point in common. Surfaces of dielectrics that touch may be met in either order;
/// what only stands on another thing is not inside of it.
bool mayMeet(const Body& a, const Body& b, const Scene& scene) {
    const double slack = a.clear && b.clear ? 1e-5 : -1e-5;
    if (!a.swept && !b.swept) return true;
    if (!a.swept || !b.swept) {
        const Object& endless = scene.objects[std::size_t((a.swept ? b : a).object)];
        const Extent& box = a.swept ? *a.swept : *b.swept;
        return endless.shape.kind != ShapeKind::Plane || endless.motion || reachesBehind(box, endless.shape, slack);
    }
    if (!meet(*a.swept, *b.swept, slack)) return false;
    const double reach = ballRadius(a, scene) + ballRadius(b, scene);
    return glm::distance(a.swept->low + a.swept->high, b.swept->low + b.swept->high) <= 2 * (1 + 1e-5) * reach;
}

/// Whether a dielectric meets another one, or what it may be around. By a sweep along x: few boxes of a scene lie one
/// behind the other there.
bool anyMeet(std::vector<Body> bodies, const Scene& scene) {
    const auto low = [](const Body& body) { return body.swept ? body.swept->low.x : -kInfinity; };
    const auto high = [](const Body& body) { return body.swept ? body.swept->high.x : kInfinity; };
    std::sort(bodies.begin(), bodies.end(), [&](const Body& a, const Body& b) { return low(a) < low(b); });
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t k = i + 1; k < bodies.size(); ++k) {
            if (low(bodies[k]) > high(bodies[i]) + 1e-5 * (std::abs(high(bodies[i])) + 1)) break;
            if ((bodies[i].clear || bodies[k].clear) && mayMeet(bodies[i], bodies[k], scene)) return true;
        }
    return false;
}

/// Conductors and coats, whose reflectance depends on the medium about them.
std::vector<Body> reflectorsOf(const Scene& scene) {
    std::vector<Body> reflectors;
    if (scene.fresnel != Fresnel::Exact) return reflectors;
    const auto outermost = outermostShapes(scene);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const auto& optics = scene.materials[std::size_t(object.material)].optics;
        if (!std::holds_alternative<Conductor>(optics) && !std::holds_alternative<Coat>(optics)) continue;
        Body body{.object = int(i), .clear = false, .swept = extentOf(outermost[0][i])};
        if (body.swept) body.swept = hull(*body.swept, *extentOf(outermost[1][i]));
        reflectors.push_back(body);
    }
    return reflectors;
}

/// All of a scene, those of a skin as one.
std::vector<Body> bodiesOf(const Scene& scene) {
    const auto outermost = outermostShapes(scene);
    std::vector<Body> bodies;
    std::map<int, std::size_t> skins; // by material
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const auto* dielectric = std::get_if<Dielectric>(&scene.materials[std::size_t(object.material)].optics);
        if (!dielectric) continue;
        Body body{int(i),
                  object.material,
                  !boundsBody(object.shape.kind),
                  true,
                  dielectric->priority,
                  sizeOfBody(object.shape),
                  extentOf(outermost[0][i])};
        if (body.swept) body.swept = hull(*body.swept, *extentOf(outermost[1][i]));
        if (body.skin) {
            const auto [at, isNew] = skins.emplace(object.material, bodies.size());
            if (!isNew) {
                Body& skin = bodies[at->second];
                skin.swept = hull(*skin.swept, *body.swept);
                skin.size = glm::distance(skin.swept->low, skin.swept->high);
                continue;
            }
        }
        bodies.push_back(body);
    }
    return bodies;
}

} // namespace

Media mediaOf(const Scene& scene) {
    Media media;
    std::vector<Body> bodies = bodiesOf(scene);
    if (!bodies.empty()) {
        std::vector<Body> all = reflectorsOf(scene);
        all.insert(all.end(), bodies.begin(), bodies.end());
        media.tracked = anyMeet(std::move(all), scene);
    }
    // From the least to the most important; of equals the first of the file comes last.
    std::sort(bodies.begin(), bodies.end(), [](const Body& a, const Body& b) {
        if (a.priority != b.priority) return a.priority < b.priority;
        return a.size != b.size ? a.size > b.size : a.object > b.object;
    });
    media.ranks.assign(scene.objects.size(), 0);
    media.materials = {0};
    std::map<int, int> skins;
    for (const Body& body : bodies) {
        const int rank = int(media.materials.size());
        media.materials.push_back(body.material);
        if (body.skin) skins[body.material] = -rank;
        media.ranks[std::size_t(body.object)] = rank;
        const auto& glass = std::get<Dielectric>(scene.materials[std::size_t(body.material)].optics);
        media.absorbing |= glass.absorption != glm::dvec3(0);
        media.tracked |= media.absorbing || glass.ior < 1;
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const auto skin = skins.find(object.material);
        if (skin != skins.end() && !boundsBody(object.shape.kind)) media.ranks[i] = skin->second;
    }
    return media;
}

glm::ivec4 mediaAt(const Media& media, const std::vector<Shape>& shapes, glm::dvec3 point) {
    std::vector<int> inside(4, 0);
    for (std::size_t i = 0; i < shapes.size(); ++i)
        if (media.ranks[i] > 0 && signedDistance(shapes[i], point) < 0) inside.push_back(media.ranks[i]);
    std::partial_sort(inside.begin(), inside.begin() + 4, inside.end(), std::greater<int>());
    return {inside[0], inside[1], inside[2], inside[3]};
}

} // namespace gnomon
