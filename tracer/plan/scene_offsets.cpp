#include "tracer/plan/scene_offsets.h"

#include "tracer/accel/lattice.h"
#include "tracer/accel/node_texels.h"

namespace gnomon {

SceneOffsets offsetsOf(const SceneFeatures& features) {
    SceneOffsets offsets;
    int texel = 0, object = 0;
    const auto take = [&](int texels) { return (texel += texels) - texels; };
    for (const KindCount& kind : features.shapes) {
        offsets.kinds.push_back({take(kind.texels() * kind.count), object});
        object += kind.count;
    }
    for (std::size_t k = 0; k < features.shapes.size(); ++k) {
        const KindCount& kind = features.shapes[k];
        KindOffsets& own = offsets.kinds[k];
        own.lattice = take(kind.latticeMembers() > 0 ? kLatticeTexels : 0);
        own.hierarchy = take(kind.search == Search::Hierarchy ? hierarchyTexels(kind.loose()) : 0);
        own.grid = take(kind.search == Search::Grid ? kind.grid.texels() : 0);
    }
    offsets.objects = take(object * kObjectTexels);
    offsets.materials = take(features.materials * kMaterialTexels);
    offsets.lights = take(features.lights * kLightTexels);
    offsets.glows = take(features.glows * kGlowTexels);
    offsets.metals = take(features.metals() ? features.materials * kMetalTexels : 0);
    offsets.media = take(features.media > 0 ? features.media + 2 : 0);
    offsets.checkers = take(features.checkers ? features.materials * kCheckerTexels : 0);
    offsets.profiles = take(features.lightProfiles ? features.lights * kProfileTexels : 0);
    offsets.gradient = take(features.gradient ? kGradientTexels : 0);
    offsets.end = texel;
    return offsets;
}

} // namespace gnomon
