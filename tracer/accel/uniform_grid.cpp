#include "tracer/accel/uniform_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon {
namespace {

/// Around an object, in cells; twice that around all of them.
constexpr double kRoom = 1.0 / 64;
/// Farther from 0, in cells, float32 does not place the walls well enough.
constexpr double kFarthest = 1 << 14;
/// Cells for each object, of the grids that are tried.
constexpr double kDensities[] = {0.25, 0.5, 1, 2, 4, 8};
/// Entries of all lists, for each cell and each object: beyond, a grid is not worth it.
constexpr double kMostEntries = 4;

struct Grid {
    glm::dvec3 low{0}, size{0}; ///< the corner; of a cell
    glm::ivec3 count{0};

    double cells() const { return double(count.x) * count.y * count.z; }
};

Bounds unionOf(std::span<const Bounds> objects) {
    Bounds all;
    for (const Bounds& object : objects) all = merged(all, object);
    return all;
}

/// What is flat gets some thickness.
glm::dvec3 sideOf(const Bounds& box) {
    const glm::dvec3 side = glm::dvec3(box.high) - glm::dvec3(box.low);
    return glm::max(side, glm::dvec3(1e-3 * std::max({side.x, side.y, side.z})));
}

/// So many cells over the box. Stretched far enough, one of them holds all of it.
Grid gridOver(const Bounds& box, glm::ivec3 count, double stretch = 1) {
    const glm::dvec3 middle = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high));
    const glm::dvec3 before = stretch > 1 ? glm::dvec3(count / 2) + 0.5 : 0.5 * glm::dvec3(count);
    Grid grid;
    grid.count = count;
    grid.size = stretch * sideOf(box) / (glm::dvec3(count) - 4 * kRoom);
    grid.low = middle - before * grid.size;
    return grid;
}

/// About so many cubes.
glm::ivec3 cubesIn(const Bounds& box, double wanted) {
    const glm::dvec3 side = sideOf(box);
    const double size = std::cbrt(side.x * side.y * side.z / wanted);
    return glm::max(glm::ivec3(glm::round(side / size)), glm::ivec3(1));
}

/// The cells that an object comes near, first and last.
struct Reach {
    glm::ivec3 from, to;

    Reach(const Grid& grid, const Bounds& object) {
        const glm::dvec3 last(grid.count - 1);
        const auto cellAt = [&](glm::dvec3 position, double room) {
            return glm::ivec3(glm::clamp(glm::floor((position - grid.low) / grid.size + room), glm::dvec3(0), last));
        };
        from = cellAt(object.low, -kRoom);
        to = cellAt(object.high, kRoom);
    }
    double size() const {
        const glm::dvec3 side(to - from + 1);
        return side.x * side.y * side.z;
    }
    template<class Visit>
    void each(const Grid& grid, Visit&& visit) const {
        for (int z = from.z; z <= to.z; ++z)
            for (int y = from.y; y <= to.y; ++y)
                for (int x = from.x; x <= to.x; ++x) visit((std::size_t(z) * grid.count.y + y) * grid.count.x + x);
    }
};

bool crowded(const Grid& grid, std::span<const Bounds> objects) {
    double entries = 0;
    for (const Bounds& object : objects) entries += Reach(grid, object).size();
    return entries > kMostEntries * (grid.cells() + double(objects.size()));
}

std::vector<int> listedIn(const Grid& grid, std::span<const Bounds> objects) {
    std::vector<int> listed(std::size_t(grid.cells()));
    for (const Bounds& object : objects) Reach(grid, object).each(grid, [&](std::size_t cell) { ++listed[cell]; });
    return listed;
}

/// A line that meets a box meets a convex body within it as often as their surfaces say. Each cell takes a turn, and
/// each object after the first in it one more.
double iterationsOf(const Grid& grid, const std::vector<int>& listed) {
    double iterations = 0;
    for (const int count : listed) iterations += std::max(count, 1);
    const auto half = [](glm::dvec3 side) { return side.x * side.y + side.y * side.z + side.z * side.x; };
    return iterations * half(grid.size) / half(grid.size * glm::dvec3(grid.count));
}

/// Twice what lists that go on take now, and enough for one list of all objects, into which a grid that is stretched
/// far enough iterations.
int continuedOf(const std::vector<int>& listed, std::size_t objects) {
    const auto texels = [](int count) { return (std::max(count, 1) - 1) / kCellListed; };
    int sum = 0;
    for (const int count : listed) sum += texels(count);
    return std::max(2 * sum, texels(int(objects)) + 1);
}

/// False where they do not fit.
bool writeLists(const Grid& grid, std::span<const Bounds> objects, std::span<glm::vec4> lists) {
    const auto cells = std::size_t(grid.cells());
    std::fill(lists.begin(), lists.end(), glm::vec4(-1));
    std::size_t end = cells;
    bool fits = true;
    for (std::size_t i = objects.size(); i-- > 0 && fits;) // the first object comes first in its lists
        Reach(grid, objects[i]).each(grid, [&](std::size_t cell) {
            glm::vec4& list = lists[cell];
            if (list[kCellListed - 1] >= 0) { // full: it goes on elsewhere
                fits = fits && end < lists.size();
                if (!fits) return;
                lists[end] = list;
                list = glm::vec4(-1, -1, -1, float(end++));
            }
            list = glm::vec4(float(i), list.x, list.y, list.w);
        });
    return fits;
}

} // namespace

std::optional<GridPlan> planGrid(std::span<const Bounds> objects) {
    if (objects.empty()) return std::nullopt;
    const Bounds box = unionOf(objects);
    GridPlan best;
    Grid grid;
    best.iterations = std::numeric_limits<double>::infinity();
    for (const double density : kDensities) {
        const Grid tried = gridOver(box, cubesIn(box, std::max(1.0, density * double(objects.size()))));
        if (crowded(tried, objects)) continue;
        const std::vector<int> listed = listedIn(tried, objects);
        if (const double iterations = iterationsOf(tried, listed); iterations < best.iterations) {
            best = {tried.count, continuedOf(listed, objects.size()), iterations};
            grid = tried;
        }
    }
    if (best.cells() == 0) return std::nullopt;
    const glm::dvec3 far =
        glm::max(glm::abs(grid.low / grid.size), glm::abs(grid.low / grid.size + glm::dvec3(grid.count)));
    return std::max({far.x, far.y, far.z}) < kFarthest ? std::optional(best) : std::nullopt;
}

void appendGrid(const GridPlan& plan, std::span<const Bounds> objects, std::vector<glm::vec4>& texels) {
    const std::size_t at = texels.size();
    texels.resize(at + std::size_t(plan.texels()));
    const std::span<glm::vec4> all = std::span(texels).subspan(at);
    const Bounds box = unionOf(objects);
    Grid grid = gridOver(box, plan.count);
    for (double stretch = 1.5; !writeLists(grid, objects, all.subspan(kGridHeadTexels)); stretch *= 1.5)
        grid = gridOver(box, plan.count, stretch);
    all[0] = glm::vec4(grid.low, 0);
    all[1] = glm::vec4(grid.size, 0);
}

} // namespace gnomon
