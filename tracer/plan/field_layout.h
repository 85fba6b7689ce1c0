/// Where the fields of a scene's parametric surfaces lie in the one texture that holds them all, and over which boxes.
#pragma once

#include "tracer/scene/scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace gnomon {

struct FieldSlot {
    int object = 0; ///< whose surface it is; others may share it
    glm::ivec3 at{0};
    glm::dvec3 size{0}; ///< of the box, about the middle of the shape's and along its axes
};

struct FieldLayout {
    std::vector<FieldSlot> slots;
    std::vector<int> slotOf; ///< by object; -1: it has no field
    int samples = 0;         ///< along each side of every box, of which the first and the last lie on its faces
    glm::ivec3 size{0};      ///< of the texture
};

/// Fields of `samples` along each axis, or as many as `mostSide` of a texture and `mostTexels` in all leave room for.
FieldLayout fieldLayoutOf(const Scene&, int samples, int mostSide, double mostTexels);

} // namespace gnomon
