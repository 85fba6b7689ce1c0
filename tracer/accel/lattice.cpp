#include "tracer/accel/lattice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon {
namespace {

/// How far an object may be from its lattice point, and how much room to its cell's walls it needs, in cells.
constexpr double kStray = 1.0 / 1024;
constexpr double kRoom = 1.0 / 64;
/// Farther from 0, in cells, float32 does not place the walls well enough.
constexpr double kFarthest = 1 << 14;

glm::dvec3 middleOf(const Extent& box) { return 0.5 * (box.low + box.high); }
glm::dvec3 halfSizeOf(const Extent& box) { return 0.5 * (box.high - box.low); }
Extent extentOf(const Shape& shape) { return shapeRow(shape.kind).extent(shape); }

/// Of the ball about an object's middle that holds it.
double ballOf(const Shape& shape) {
    return shape.kind == ShapeKind::Sphere ? lengthOf(shape, "radius") : glm::length(halfSizeOf(extentOf(shape)));
}

/// The same shape at one position: what makes two objects equal.
Shape atHome(const Shape& shape) { return translated(shape, -middleOf(extentOf(shape))); }

bool equal(const Shape& a, const Shape& b) {
    constexpr double kEqual = 1e-5;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        if (std::abs(a.values[i] - b.values[i]) > kEqual * sizeOf(a)) return false;
    return true;
}

/// The lattice along one axis: where it begins, its step, how many points.
struct Row {
    double first = 0, step = 0;
    int count = 0;

    int pointAt(double position) const { return step > 0 ? int(std::lround((position - first) / step)) : 0; }
};

/// Of positions that may repeat; count is 0 where they are not evenly spaced. A row of one point steps by its own size.
Row rowOf(std::vector<double> positions, double size) {
    std::sort(positions.begin(), positions.end());
    Row row{positions.front(), 2 * size, 1};
    const double length = positions.back() - positions.front();
    if (length <= kStray * size) return row;
    const auto second = std::upper_bound(positions.begin(), positions.end(), positions.front() + 0.5 * size);
    if (second == positions.end()) return {};
    row.count = int(std::lround(length / (*second - row.first))) + 1;
    row.step = length / (row.count - 1);
    for (const double position : positions)
        if (std::abs(row.first + row.pointAt(position) * row.step - position) > kStray * row.step) return {};
    return row;
}

/// Along each axis; what is flat gets some thickness.
glm::dvec3 sizeForCell(const Shape& shape) {
    const glm::dvec3 size = 2.0 * halfSizeOf(extentOf(shape));
    return glm::max(size, glm::dvec3(1e-3 * std::max({size.x, size.y, size.z})));
}

/// The lattice that all of `members` make; none where they do not fill one.
std::optional<Lattice> latticeOf(std::span<const Shape> shapes, const std::vector<int>& members) {
    const glm::dvec3 size = sizeForCell(shapes[std::size_t(members[0])]);
    std::array<Row, 3> rows;
    Lattice lattice;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> positions;
        for (const int i : members) positions.push_back(middleOf(extentOf(shapes[std::size_t(i)]))[axis]);
        Row& row = rows[std::size_t(axis)] = rowOf(positions, size[axis]);
        const double farthest = std::max(std::abs(row.first), std::abs(row.first + row.count * row.step));
        if (row.count == 0 || size[axis] > (1 - 2 * (kRoom + kStray)) * row.step || farthest > kFarthest * row.step)
            return std::nullopt;
        lattice.cells[axis] = row.count;
    }
    if (std::size_t(lattice.cells.x) * std::size_t(lattice.cells.y) * std::size_t(lattice.cells.z) != members.size())
        return std::nullopt;
    lattice.members.assign(members.size(), -1);
    for (const int i : members) {
        const glm::dvec3 middle = middleOf(extentOf(shapes[std::size_t(i)]));
        const int x = rows[0].pointAt(middle.x), y = rows[1].pointAt(middle.y), z = rows[2].pointAt(middle.z);
        lattice.members[std::size_t((z * lattice.cells.y + y) * lattice.cells.x + x)] = i;
    }
    const bool full = std::find(lattice.members.begin(), lattice.members.end(), -1) == lattice.members.end();
    return full ? std::optional(lattice) : std::nullopt;
}

} // namespace

std::optional<Lattice> findLattice(std::span<const Shape> shapes, std::span<const int> candidates) {
    std::vector<std::vector<int>> groups; // of equal objects
    std::vector<Shape> homes;
    constexpr std::size_t kMostGroups = 16; // scenes of objects of all sizes have no lattice worth the search
    for (const int i : candidates) {
        const Shape home = atHome(shapes[std::size_t(i)]);
        const auto known = std::find_if(homes.begin(), homes.end(), [&](const Shape& h) { return equal(h, home); });
        if (known != homes.end()) {
            groups[std::size_t(known - homes.begin())].push_back(i);
        } else if (homes.size() < kMostGroups) {
            homes.push_back(home);
            groups.push_back({i});
        }
    }
    std::optional<Lattice> best;
    for (const std::vector<int>& members : groups) {
        if (members.size() < std::max(std::size_t(kSmallestLattice), best ? best->members.size() + 1 : 0)) continue;
        if (auto lattice = latticeOf(shapes, members)) best = std::move(lattice);
    }
    return best;
}

void appendTexels(glm::ivec3 cells, const Shape& first, const Shape& last, std::vector<glm::vec4>& texels) {
    const glm::dvec3 start = middleOf(extentOf(first)), end = middleOf(extentOf(last));
    glm::dvec3 size = (end - start) / glm::max(glm::dvec3(cells - 1), glm::dvec3(1));
    for (int axis = 0; axis < 3; ++axis)
        if (cells[axis] == 1) size[axis] = 2 * sizeForCell(first)[axis];
    // The balls are told about the points of the lattice, from which the objects stray a little.
    const double radius = ballOf(first) + glm::length(size) * 2 * kStray;
    texels.emplace_back(glm::vec3(start - 0.5 * size), float(radius));
    texels.emplace_back(glm::vec3(size), 0.0f);
}

} // namespace gnomon
