/// What shaders/accel/hierarchy.glsl does, in the same float32 operations in the same order.
#pragma once

#include "tracer/accel/node_texels.h"

#include "tests/support/clouds.h"

#include <span>

namespace gnomon::test {

/// How many boxes a walk has asked, and how many primitives.
struct Visits {
    double boxes = 0, primitives = 0;
};

struct QuantisedRay {
    glm::vec3 beforeLow, beforeHigh, perCell;
};

inline QuantisedRay quantisedRay(std::span<const glm::vec4> grid, const Ray& ray) {
    const glm::vec3 cells(grid[1]);
    const glm::vec3 away = ray.origin - glm::vec3(grid[0]), size = glm::abs(away);
    const glm::vec3 room = 9.5e-7f * (std::max(size.x, std::max(size.y, size.z)) + grid[0].w) * cells;
    const glm::vec3 origin = away * cells;
    glm::vec3 direction = ray.direction * cells;
    for (int i = 0; i < 3; ++i)
        if (std::abs(direction[i]) < 1e-18f) direction[i] = 1e-18f;
    return {origin + room, origin - room, 1.0f / direction};
}

inline bool meets(const QuantisedRay& ray, glm::vec4 box, float t) {
    const glm::vec3 both(box), high = glm::floor(both * (1.0f / 4096.0f));
    const glm::vec3 toLow = (both - 4096.0f * high - ray.beforeLow) * ray.perCell;
    const glm::vec3 toHigh = (high - ray.beforeHigh) * ray.perCell;
    const glm::ivec3 a = glm::floatBitsToInt(toLow), b = glm::floatBitsToInt(toHigh);
    const glm::ivec3 enter = glm::min(a, b), leave = glm::max(a, b);
    return std::max(std::max(enter.x, enter.y), std::max(enter.z, 0)) <=
           std::min(std::min(leave.x, leave.y), std::min(leave.z, glm::floatBitsToInt(t)));
}

inline int nextLeaf(const QuantisedRay& ray, std::span<const glm::vec4> nodes, float t, int& node, Visits& visits) {
    while (node < int(nodes.size())) {
        const glm::vec4 box = nodes[std::size_t(node)];
        ++visits.boxes;
        const bool met = meets(ray, box, t), leaf = box.w < 0;
        node = met || leaf ? node + 1 : int(box.w);
        if (met && leaf) return -1 - int(box.w);
    }
    return -1;
}

/// Calls `ask(primitive)` for what the walk comes to. `t` is what ask() may lower.
template<typename Ask>
Visits walkTexels(std::span<const glm::vec4> texels, const Ray& ray, const double& t, Ask ask) {
    Visits visits;
    if (texels.empty()) return visits;
    const QuantisedRay gridded = quantisedRay(texels, ray);
    const auto nodes = texels.subspan(kQuantisationTexels);
    for (int node = 0, leaf; (leaf = nextLeaf(gridded, nodes, float(t), node, visits)) >= 0;) {
        ++visits.primitives;
        ask(leaf);
    }
    return visits;
}

/// The nearest sphere.
inline Nearest walked(std::span<const glm::vec4> texels, const Spheres& balls, const Ray& ray, Visits& sum) {
    Nearest nearest;
    const auto ask = [&](int i) { nearest.offer(i, distanceTo(balls[std::size_t(i)], ray)); };
    const Visits visits = walkTexels(texels, ray, nearest.t, ask);
    sum.boxes += visits.boxes;
    sum.primitives += visits.primitives;
    return nearest;
}

inline std::vector<glm::vec4> texelsOf(const Hierarchy& hierarchy, glm::vec3 eye) {
    std::vector<glm::vec4> texels;
    appendTexels(hierarchy, eye, texels);
    return texels;
}

} // namespace gnomon::test
