#include "tracer/plan/screen_split.h"

#include <algorithm>

namespace gnomon {

bool ScreenSplit::anyUncommon() const {
    return refraction || normalMaps ||
           std::any_of(kinds.begin(), kinds.end(), [](const Kind& k) { return k.shape || k.images; });
}

bool ScreenSplit::fallsBack(std::size_t i, const Material& material) const {
    return kind(i).shape || (refraction && material.refracts()) || (normalMaps && material.normalMap) ||
           (kind(i).images && material.showsImages());
}

} // namespace gnomon
