#include "tracer/plan/layout.h"

#include "tracer/accel/lattice.h"
#include "tracer/plan/drawn.h"
#include "tracer/scene/solid.h"

#include <algorithm>
#include <map>
#include <string>

namespace gnomon {
namespace {

/// Moves the lattice's members, if there is a lattice, to the front.
void separateLattice(const Scene& scene, const std::vector<Shape>& shapes, KindLayout& layout) {
    std::vector<int> resting;
    for (const int i : layout.objects) {
        const Object& object = scene.objects[std::size_t(i)];
        if (object.castsShadow && !object.motion) resting.push_back(i);
    }
    const auto lattice = findLattice(shapes, resting);
    if (!lattice) return;
    layout.lattice = lattice->cells;
    std::vector<int> order = lattice->members;
    std::vector<bool> member(shapes.size(), false);
    for (const int i : order) member[std::size_t(i)] = true;
    std::copy_if(layout.objects.begin(), layout.objects.end(), std::back_inserter(order),
                 [&](int i) { return !member[std::size_t(i)]; });
    layout.objects = std::move(order);
}

} // namespace

std::vector<KindLayout> layoutOf(const Scene& scene, const std::vector<Shape>& shapes) {
    const std::vector<ShapeKind> kinds = drawnKinds(scene);
    std::vector<KindLayout> layouts(kShapeKinds);
    std::map<std::string, std::size_t> forms; // of solids: where in layouts
    for (const bool casters : {true, false})
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (scene.objects[i].castsShadow != casters) continue;
            const Shape& shape = shapes[i];
            std::size_t at = std::size_t(kinds[i]);
            if (shape.solid) {
                at = forms.emplace(formOf(shape.solid->root), layouts.size()).first->second;
                if (at == layouts.size()) layouts.emplace_back();
            }
            KindLayout& layout = layouts[at];
            layout.kind = kinds[i];
            layout.solid = shape.solid;
            layout.objects.push_back(int(i));
            layout.casters += casters;
        }
    layouts.erase(std::remove_if(layouts.begin(), layouts.end(), [](const auto& l) { return l.objects.empty(); }),
                  layouts.end());
    for (KindLayout& layout : layouts)
        if (shapeRow(layout.kind).extent && !layout.solid) separateLattice(scene, shapes, layout);
    return layouts;
}

} // namespace gnomon
