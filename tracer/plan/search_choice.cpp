#include "tracer/plan/search_choice.h"

#include <algorithm>

namespace gnomon {
namespace {

/// Of asking an object, and its bounding sphere, in boxes of a hierarchy.
constexpr double kObjectCost = 2;
constexpr double kSphereCost = 0.3;
/// Of an iteration in a walk through a uniform grid, which reads a list and a bounding sphere; measured 1.5 to 2.1 in
/// clouds of 100 to 10 000.
constexpr double kGridStepCost = 1.75;
/// Bits of the bounding-sphere mask.
constexpr int kMostMasked = 24;

double costOf(Search search, const SearchCost& cost) {
    const double asked = kObjectCost * cost.primitives;
    switch (search) {
    case Search::Loop: return kObjectCost * cost.objects;
    case Search::SphereMask: return kSphereCost * cost.objects + asked;
    case Search::Grid: return kGridStepCost * cost.grid->iterations + asked;
    case Search::Hierarchy: break;
    }
    return cost.boxes + asked;
}

/// For the objects that make no lattice.
Search cheapestSearch(const SearchCost& cost, bool lattice, bool grids) {
    std::vector<Search> possible{Search::Hierarchy};
    if (cost.objects <= kMostMasked) possible.push_back(Search::SphereMask);
    if (!lattice) possible.push_back(Search::Loop);
    if (grids && cost.grid) possible.push_back(Search::Grid);
    return *std::min_element(possible.begin(), possible.end(),
                             [&](Search a, Search b) { return costOf(a, cost) < costOf(b, cost); });
}

void chooseSearch(const KindLayout& layout, const SearchCost& cost, Accel accel, bool grids, KindCount& kind) {
    if (accel == Accel::None || !shapeRow(kind.kind).extent) return;
    if (accel == Accel::Hierarchy) { // of all, whatever lattice some of them make
        if (kind.count >= 2) kind.search = Search::Hierarchy;
        return;
    }
    kind.lattice = layout.lattice;
    const bool lattice = kind.latticeMembers() > 0;
    if (cost.objects < (lattice ? 1 : 2)) return;
    kind.search = cheapestSearch(cost, lattice, grids);
    if (kind.search == Search::Grid) kind.grid = *cost.grid;
}

bool showsImages(const Scene& scene, int object) {
    return scene.materials[std::size_t(scene.objects[std::size_t(object)].material)].showsImages();
}

} // namespace

std::vector<KindCount> countKinds(const PreparedScene& prepared, Accel accel, bool grids) {
    std::vector<KindCount> kinds;
    int forms = 0;
    for (std::size_t k = 0; k < prepared.layout.size(); ++k) {
        const KindLayout& layout = prepared.layout[k];
        KindCount kind{layout.kind, int(layout.objects.size()), layout.casters};
        kind.solid = layout.solid;
        if (kind.solid) kind.form = forms++;
        kind.images = std::any_of(layout.objects.begin(), layout.objects.end(),
                                  [&](int i) { return showsImages(prepared.scene, i); });
        chooseSearch(layout, prepared.searches[k], accel, grids, kind);
        kinds.push_back(kind);
    }
    return kinds;
}

} // namespace gnomon
