#include "tracer/plan/field_layout.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

constexpr int kFewest = 8; ///< samples along an axis

/// Room above and below the surface, so that distances near it are interpolated between samples of either sign.
constexpr double kMargin = 0.05; ///< of the longest side

glm::dvec3 fieldSize(const Shape& shape) {
    glm::dvec3 size = pointOf(shape, "size");
    size.y += 2 * kMargin * std::max({size.x, size.y, size.z});
    return size;
}

bool sameSurface(const Shape& a, const Shape& b) {
    return a.heights == b.heights && pointOf(a, "size") == pointOf(b, "size");
}

} // namespace

FieldLayout fieldLayoutOf(const Scene& scene, int samples, int mostSide, double mostTexels) {
    FieldLayout layout;
    layout.slotOf.assign(scene.objects.size(), -1);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Shape& shape = scene.objects[i].shape;
        if (shape.kind != ShapeKind::HeightPatch) continue;
        const auto known = std::find_if(layout.slots.begin(), layout.slots.end(), [&](const FieldSlot& slot) {
            return sameSurface(scene.objects[std::size_t(slot.object)].shape, shape);
        });
        layout.slotOf[i] = int(known - layout.slots.begin());
        if (known == layout.slots.end()) layout.slots.push_back({int(i), {}, fieldSize(shape)});
    }
    const double count = double(layout.slots.size());
    if (count == 0) return layout;
    const int room = int(std::cbrt(mostTexels / count)), rows = int(std::ceil(std::cbrt(count)));
    layout.samples = std::max(std::min({samples, room, mostSide / rows}), kFewest);
    const int across = std::max(mostSide / layout.samples, 1);
    for (int i = 0; i < int(layout.slots.size()); ++i) {
        glm::ivec3& at = layout.slots[std::size_t(i)].at;
        at = layout.samples * glm::ivec3(i % across, i / across % across, i / (across * across));
        layout.size = glm::max(layout.size, at + layout.samples);
    }
    return layout;
}

} // namespace gnomon
