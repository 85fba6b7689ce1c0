/// The media of a scene: its dielectric bodies, ranked, so that of all that a point lies in the highest rank is its
/// medium.
///
/// Priority     the higher stated one; of equals the smaller body by the diagonal of the box about it, which so wins
///              over what contains it; then the first of the file
/// Bodies       closed shapes, solids, and a plane, which is the half space behind its normal. Discs and triangles are
///              the skin of a body, all that are of one material of the same one; what lies in it is not known from a
///              point, only by passing through the skin
/// Source       C. Schmidt and B. Budge, Simple Nested Dielectrics in Ray Traced Images, 2002
#pragma once

#include "tracer/scene/scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace gnomon {

struct Media {
    std::vector<int> ranks;     ///< of each object, from 1 up; 0: it is no dielectric; negative: skin of that rank
    std::vector<int> materials; ///< of each rank; [0] is not used, it stands for air
    bool tracked = false;       ///< rays have to know what they are inside of: bodies may overlap or contain others or
                                ///< what reflects by its index, a medium absorbs, or is thinner than air
    bool absorbing = false;
};

Media mediaOf(const Scene&);

/// The four highest ranks of the bodies that a point lies in, in order, 0 where there are fewer. `shapes` are where the
/// objects are.
glm::ivec4 mediaAt(const Media&, const std::vector<Shape>& shapes, glm::dvec3 point);

} // namespace gnomon
