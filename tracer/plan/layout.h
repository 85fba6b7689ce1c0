/// The order of a scene's objects in the shader: by kind, and within a kind those of a lattice first, then the others
/// that cast shadows, then those that do not. Neither the settings nor how rays search change it, so that of objects at
/// the same distance the same one is always met.
#pragma once

#include "tracer/scene/scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace gnomon {

struct KindLayout {
    ShapeKind kind = ShapeKind::Sphere;   ///< as drawn
    std::vector<int> objects;             ///< indices in the scene
    int casters = 0;                      ///< the first ones, lattice included, cast shadows
    glm::ivec3 lattice{0};                ///< its cells; 0 where there is none
    std::shared_ptr<const Solid> solid{}; ///< one of them, where they are solids: all are of one form

    int latticeMembers() const { return lattice.x * lattice.y * lattice.z; }
    int loose() const { return int(objects.size()) - latticeMembers(); }
};

/// The kinds present, in the order of ShapeKind; solids of each form are a kind of their own. `shapes` are those of the
/// scene at rest, relative to its origin: what is far from the world's makes lattices as well.
std::vector<KindLayout> layoutOf(const Scene&, const std::vector<Shape>& shapes);

} // namespace gnomon
