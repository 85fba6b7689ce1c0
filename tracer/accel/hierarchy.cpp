#include "tracer/accel/hierarchy.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

namespace gnomon {
namespace {

/// Up to here every split is tried.
constexpr int kSweepCount = 64;
constexpr int kBins = 32;

/// Splits closer in cost than this fraction are equal but for rounding.
constexpr double kEqual = 1e-6;

struct Range {
    int first, count;
};

/// A cut of a range into `left` primitives and the rest. `cost` is what asking them takes, each weighed by its side's
/// area.
struct Split {
    double cost;
    int axis, left;
};

class Builder {
  public:
    explicit Builder(std::span<const Bounds> bounds) : bounds_(bounds) {
        const std::size_t count = bounds.size();
        centers_.reserve(count);
        for (const Bounds& box : bounds) centers_.push_back(0.5f * box.low + 0.5f * box.high);
        for (std::size_t i = 0; i < count; ++i) order_.push_back(int(i));
        result_.nodes.reserve(2 * count);
        areas_.resize(std::min(count, std::size_t(kSweepCount)));
    }

    Hierarchy run() {
        if (bounds_.empty()) return {};
        std::vector<Task> tasks{{{0, int(bounds_.size())}, kRoot}};
        while (!tasks.empty()) {
            const Task task = tasks.back();
            tasks.pop_back();
            const int node = int(result_.nodes.size());
            if (task.before != kRoot) result_.nodes[std::size_t(task.before)].skip = node;
            result_.nodes.push_back({boxOf(task.range), 0, -1});
            if (task.range.count == 1) {
                result_.nodes.back().primitive = *begin(task.range);
                continue;
            }
            const int left = leftOf(task.range);
            tasks.push_back({{task.range.first + left, task.range.count - left}, node + 1});
            tasks.push_back({{task.range.first, left}, kRoot});
        }
        passSkipsDown();
        result_.builtCost = result_.cost();
        return std::move(result_);
    }

  private:
    static constexpr int kRoot = -1;
    struct Task {
        Range range;
        int before; ///< the sibling whose skip leads here; kRoot for the root and for first children
    };
    using Order = std::vector<int>::iterator;

    Order begin(Range range) { return order_.begin() + range.first; }
    Order end(Range range) { return begin(range) + range.count; }

    Bounds boxOf(Range range) {
        Bounds box;
        for (Order i = begin(range); i != end(range); ++i) box = merged(box, bounds_[std::size_t(*i)]);
        return box;
    }

    /// A first child has its skip from its sibling; a second child, like the root, goes on where its parent does.
    void passSkipsDown() {
        std::vector<HierarchyNode>& nodes = result_.nodes;
        nodes[0].skip = int(nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (!nodes[i].isLeaf()) nodes[std::size_t(nodes[i + 1].skip)].skip = nodes[i].skip;
    }

    /// Sorts the range so that its first ones become the first child; answers how many.
    int leftOf(Range range) { return (range.count <= kSweepCount ? swept(range) : binned(range)).left; }

    void sort(Range range, int axis) {
        std::sort(begin(range), end(range), [&](int a, int b) {
            const float x = centers_[std::size_t(a)][axis], y = centers_[std::size_t(b)][axis];
            return x != y ? x < y : a < b;
        });
    }

    /// The best of all cuts of the primitives sorted along one axis, if better than `best`.
    void sweep(Range range, int axis, Split& best) {
        Bounds right;
        for (int i = range.count - 1; i > 0; --i) {
            right = merged(right, bounds_[std::size_t(begin(range)[i])]);
            areas_[std::size_t(i)] = halfArea(right);
        }
        Bounds left;
        for (int i = 1; i < range.count; ++i) {
            left = merged(left, bounds_[std::size_t(begin(range)[i - 1])]);
            const double cost = halfArea(left) * i + areas_[std::size_t(i)] * (range.count - i);
            if (cost < best.cost * (1 - kEqual)) best = {cost, axis, i};
        }
    }

    /// Half of the primitives, which is as good as any other cut where all lie at one position.
    Split halved(Range range) {
        const int left = range.count / 2;
        const double cost = halfArea(boxOf({range.first, left})) * left +
                            halfArea(boxOf({range.first + left, range.count - left})) * (range.count - left);
        return {cost, -1, left};
    }

    Split swept(Range range) {
        sort(range, 0);
        Split best = halved(range);
        best.axis = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (axis > 0) sort(range, axis);
            sweep(range, axis, best);
        }
        if (best.axis != 2) sort(range, best.axis);
        return best;
    }

    struct Bin {
        Bounds bounds;
        int count = 0;
    };

    struct Bins {
        std::array<Bin, kBins> all;
        int axis;
        float low, perUnit;

        int of(glm::vec3 center) const { return std::min(int((center[axis] - low) * perUnit), kBins - 1); }
    };

    Bins fill(Range range, int axis, float low, float high) {
        Bins bins{{}, axis, low, float(kBins) / (high - low)};
        for (Order i = begin(range); i != end(range); ++i) {
            Bin& bin = bins.all[std::size_t(bins.of(centers_[std::size_t(*i)]))];
            bin.bounds = merged(bin.bounds, bounds_[std::size_t(*i)]);
            ++bin.count;
        }
        return bins;
    }

    /// Lowers `best` to the best cut between two bins; says the last bin of its first part, or -1 where none is better.
    static int cut(const Bins& bins, int total, Split& best) {
        std::array<double, kBins> right{};
        Bounds box;
        for (std::size_t i = kBins - 1; i > 0; --i) {
            box = merged(box, bins.all[i].bounds);
            right[i] = box.low.x <= box.high.x ? halfArea(box) : 0;
        }
        int count = 0, found = -1;
        box = {};
        for (std::size_t i = 0; i + 1 < kBins; ++i) {
            if (bins.all[i].count == 0) continue;
            box = merged(box, bins.all[i].bounds);
            count += bins.all[i].count;
            const double cost = halfArea(box) * count + right[i + 1] * (total - count);
            if (count == total || cost >= best.cost * (1 - kEqual)) continue;
            best = {cost, bins.axis, count};
            found = int(i);
        }
        return found;
    }

    Split binned(Range range) {
        Bounds centers;
        for (Order i = begin(range); i != end(range); ++i) {
            const glm::vec3 center = centers_[std::size_t(*i)];
            centers = merged(centers, {center, center});
        }
        Split best = halved(range);
        Bins chosen{};
        int last = -1;
        for (int axis = 0; axis < 3; ++axis) {
            const float low = centers.low[axis], high = centers.high[axis];
            if (!(float(kBins) / (high - low) < std::numeric_limits<float>::max())) continue; // at one position
            const Bins bins = fill(range, axis, low, high);
            const int found = cut(bins, range.count, best);
            if (found < 0) continue;
            chosen = bins;
            last = found;
        }
        if (last >= 0)
            std::stable_partition(begin(range), end(range),
                                  [&](int i) { return chosen.of(centers_[std::size_t(i)]) <= last; });
        return best;
    }

    std::span<const Bounds> bounds_;
    std::vector<glm::vec3> centers_;
    std::vector<double> areas_;
    std::vector<int> order_; ///< the primitives, those of a node side by side
    Hierarchy result_;
};

/// A sum of areas as what a ray that meets the root's box meets on average.
double overRoot(const Hierarchy& hierarchy, double areas) {
    const double whole = hierarchy.nodes.empty() ? 0 : halfArea(hierarchy.nodes[0].bounds);
    return whole > 0 ? areas / whole : 0;
}

} // namespace

double Hierarchy::cost() const {
    if (nodes.empty()) return 0;
    double sum = 0;
    for (const HierarchyNode& node : nodes)
        if (!node.isLeaf()) sum += 2 * halfArea(node.bounds);
    return 1 + overRoot(*this, sum);
}

double Hierarchy::primitivesAsked() const {
    double sum = 0;
    for (const HierarchyNode& node : nodes)
        if (node.isLeaf()) sum += halfArea(node.bounds);
    return overRoot(*this, sum);
}

Hierarchy build(std::span<const Bounds> bounds) { return Builder(bounds).run(); }

void refit(Hierarchy& hierarchy, std::span<const Bounds> bounds) {
    std::vector<HierarchyNode>& nodes = hierarchy.nodes;
    assert(int(nodes.size()) == nodesFor(int(bounds.size())));
    for (std::size_t i = nodes.size(); i-- > 0;) {
        HierarchyNode& node = nodes[i];
        node.bounds = node.isLeaf() ? bounds[std::size_t(node.primitive)]
                                    : merged(nodes[i + 1].bounds, nodes[std::size_t(nodes[i + 1].skip)].bounds);
    }
}

void update(Hierarchy& hierarchy, std::span<const Bounds> bounds) {
    constexpr double kSpoilt = 1.5;
    if (int(hierarchy.nodes.size()) == nodesFor(int(bounds.size()))) {
        refit(hierarchy, bounds);
        if (hierarchy.spoilt() <= kSpoilt) return;
    }
    hierarchy = build(bounds);
}

} // namespace gnomon
