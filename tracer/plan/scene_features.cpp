#include "tracer/plan/scene_features.h"

#include "tracer/plan/shape_texels.h"
#include "tracer/plan/solid_texels.h"

namespace gnomon {
namespace {

bool ofOneForm(const std::shared_ptr<const Solid>& a, const std::shared_ptr<const Solid>& b) {
    return a == b || (a && b && formOf(a->root) == formOf(b->root));
}

} // namespace

std::string KindCount::type() const { return glslTypeOf(kind) + (solid ? std::to_string(form) : ""); }

int KindCount::texels() const {
    if (solid) return texelsOf(*solid);
    return texelsOf(kind) + netTexelsOf(kind);
}

bool KindCount::operator==(const KindCount& other) const {
    return kind == other.kind && count == other.count && casters == other.casters && lattice == other.lattice &&
           search == other.search && grid.count == other.grid.count && grid.continued == other.grid.continued &&
           images == other.images && form == other.form && ofOneForm(solid, other.solid);
}

int SceneFeatures::objects() const {
    int sum = 0;
    for (const KindCount& kind : shapes) sum += kind.count;
    return sum;
}

} // namespace gnomon
