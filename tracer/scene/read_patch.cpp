#include "tracer/scene/read_patch.h"

#include "tracer/scene/rotation.h"

#include <algorithm>
#include <cstdint>
#include <memory>

namespace gnomon {
namespace {

/// A surface that is flat has a box, too: of this height over the shorter side of its rectangle.
constexpr double kLeastHeight = 1e-3;

/// With the box about the surface for its rectangle, and heights told in that box.
Shape heightPatch(Heights heights, glm::dvec3 center, glm::dvec3 size) {
    const auto [least, greatest] = heightRange(heights);
    const double middle = 0.5 * (least + greatest);
    const double range = std::max(greatest - least, kLeastHeight * std::min(size.x, size.z) / size.y);
    for (double& height : heights) height = (height - middle) / range;
    Shape shape = makeShape(ShapeKind::HeightPatch,
                            {center + glm::dvec3(0, middle * size.y, 0), {size.x, range * size.y, size.z}, {}});
    shape.heights = std::make_shared<const Heights>(heights);
    return shape;
}

Shape readPoints(const ObjectReader& reader) {
    ControlPoints points{};
    if (!reader.read("points", points)) points.fill(glm::dvec4(0, 0, 0, 1)); // what is refused may have any weights
    glm::dvec3 low(points[0]), high = low;
    for (const glm::dvec4& p : points) low = glm::min(low, glm::dvec3(p)), high = glm::max(high, glm::dvec3(p));
    return spacePatch(points, 0.5 * (low + high));
}

Shape readHeights(const ObjectReader& reader) {
    Heights heights{};
    double seed = 0;
    glm::dvec3 center{0}, size{1};
    if (reader.read("random", seed)) heights = randomHeights(std::uint32_t(seed));
    reader.read("heights", heights);
    reader.read("center", center);
    reader.read("size", size);
    return heightPatch(heights, center, size);
}

} // namespace

Shape spacePatch(const ControlPoints& points, glm::dvec3 anchor) {
    return spacePatchOf(spaceNet(points, anchor), anchor);
}

Shape spacePatchOf(const SpaceNet& net, glm::dvec3 anchor) {
    const double radius = 0.5 * glm::distance(net.low, net.high);
    Shape shape = makeShape(ShapeKind::SpacePatch, {anchor, anchor + 0.5 * (net.low + net.high)}, {radius});
    shape.net = std::make_shared<const SpaceNet>(net);
    return shape;
}

Shape readPatch(const ObjectReader& reader, SceneReport& report) {
    const Shape shape = reader.has("points") ? readPoints(reader) : readHeights(reader);
    if (!reader.sound()) return shape;
    if (const auto [what, remedy] = shapeRow(shape.kind).check(shape); !what.empty())
        report.add(reader.line(), reader.path(), what, remedy);
    return shape;
}

} // namespace gnomon
