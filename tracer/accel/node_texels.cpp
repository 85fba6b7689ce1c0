#include "tracer/accel/node_texels.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

/// The cells that boxes are told in.
class Grid {
  public:
    explicit Grid(const Bounds& root) : low_(root.low) {
        const glm::vec3 side = root.high - root.low;
        // Flat boxes get cells, too, and none so small that cells a unit overflow.
        longest_ = std::max({side.x, side.y, side.z, 1e-18f});
        for (int axis = 0; axis < 3; ++axis)
            cellsPerUnit_[axis] = float(kQuantisationSteps - 1) / std::max(side[axis], 1e-6f * longest_);
    }

    void append(std::vector<glm::vec4>& texels) const {
        texels.emplace_back(low_, longest_);
        texels.emplace_back(cellsPerUnit_, 0.0f);
    }

    glm::vec4 node(const Bounds& box, int link) const {
        // An eighth of a cell for the rounding of the position below.
        const glm::vec3 low = glm::floor((box.low - low_) * cellsPerUnit_ - 0.125f);
        const glm::vec3 high = glm::ceil((box.high - low_) * cellsPerUnit_ + 0.125f);
        const glm::vec3 first = glm::max(low, 0.0f), last = glm::min(high, float(kQuantisationSteps));
        return {first + 4096.0f * last, float(link)};
    }

  private:
    glm::vec3 low_, cellsPerUnit_{0};
    float longest_;
};

glm::vec3 middleOf(const Bounds& box) { return 0.5f * box.low + 0.5f * box.high; }

} // namespace

void appendTexels(const Hierarchy& hierarchy, glm::vec3 eye, std::vector<glm::vec4>& texels) {
    const std::vector<HierarchyNode>& nodes = hierarchy.nodes;
    if (nodes.empty()) return;
    const Grid grid(nodes[0].bounds);
    grid.append(texels);
    const auto distance = [&](int node) {
        const glm::vec3 away = middleOf(nodes[std::size_t(node)].bounds) - eye;
        return glm::dot(away, away);
    };
    std::vector<int> waiting{0};
    for (int written = 0; !waiting.empty(); ++written) {
        const int at = waiting.back();
        waiting.pop_back();
        const HierarchyNode& node = nodes[std::size_t(at)];
        if (node.isLeaf()) {
            texels.push_back(grid.node(node.bounds, -1 - node.primitive));
            continue;
        }
        texels.push_back(grid.node(node.bounds, written + node.skip - at));
        int near = at + 1, far = nodes[std::size_t(near)].skip;
        if (distance(far) < distance(near)) std::swap(near, far);
        waiting.push_back(far);
        waiting.push_back(near);
    }
}

} // namespace gnomon
