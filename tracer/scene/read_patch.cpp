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

} // namespace

Shape readPatch(const ObjectReader& reader, SceneReport& report) {
    Heights heights{};
    double seed = 0;
    glm::dvec3 center{0}, size{1};
    if (reader.read("random", seed)) heights = randomHeights(std::uint32_t(seed));
    reader.read("heights", heights);
    reader.read("center", center);
    reader.read("size", size);
    const Shape shape = heightPatch(heights, center, size);
    if (!reader.sound()) return shape;
    if (const auto [what, remedy] = shapeRow(shape.kind).check(shape); !what.empty())
        report.add(reader.line(), reader.path(), what, remedy);
    return shape;
}

} // namespace gnomon
