#include "tracer/plan/plan.h"

#include <algorithm>

namespace gnomon {
namespace {

std::string inScene(const SceneFeatures& s) {
    if (s.reflection != reflects(s)) return "reflection without a material that reflects";
    if (s.cubemap + s.panorama + s.gradient > 1) return "more than one background";
    if (s.shadows != ShadowModel::Off && s.lights == 0) return "shadows without a light";
    if (s.fromLight && s.shadows == ShadowModel::Off) return "shadow cones from the light without shadows";
    if (s.fromLight && s.directional) return "shadow cones from a light without a place";
    if (s.directional && !shadowRow(s.shadows).parallel) return "a shadow model that takes no directional light";
    if (shadowRow(s.shadows).distances && !s.distances) return "a shadow model without the distances it asks for";
    for (const KindCount& kind : s.shapes) {
        if (kind.casters > kind.count) return "more casters than objects of a kind";
        if (kind.latticeMembers() > kind.count) return "a lattice of more objects than there are";
        if ((kind.search == Search::Grid) != (kind.grid.cells() > 0)) return "a uniform grid that is not the search";
        if ((kind.kind == ShapeKind::Solid) != (kind.solid != nullptr)) return "a solid without its tree";
    }
    return {};
}

std::string inTarget(const CodegenTarget& t) {
    if (t.tile > 0 && !t.fallback) return "a target with tiles but without fallback";
    return {};
}

std::string inSplit(const Plan& plan) {
    const ScreenSplit& split = plan.split;
    if (!split.kinds.empty() && split.kinds.size() != plan.scene.shapes.size()) return "a split of other kinds";
    if (split.anyUncommon() && !split.on) return "uncommon features without a split";
    if (split.on && plan.scene.output != Aov::Color) return "a split of an output that is no colour";
    if (split.fallback && !split.anyUncommon()) return "fallback without an uncommon feature";
    if (split.fallback && split.refraction && plan.scene.refraction) return "a base variant that refracts";
    if (split.fallback && split.normalMaps && plan.scene.normalMaps > 0) return "a base variant with normal maps";
    if (split.tile > 0 && !split.anyUncommon()) return "tiles without an uncommon feature";
    if (split.coverageMask && split.tile > 0) return "a variant that both marks and reads the coverage mask";
    if (split.tile > 0 && split.fallback) return "tiles of the base variant";
    return {};
}

} // namespace

std::string contradictionIn(const Plan& plan) {
    for (const std::string& found : {inScene(plan.scene), inTarget(plan.target), inSplit(plan)})
        if (!found.empty()) return found;
    return {};
}

} // namespace gnomon
