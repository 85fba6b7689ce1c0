/// Lattices of objects: equal ones at the points of a grid along the axes.
///
/// A ray finds them by walking from cell to cell (shaders/accel/lattice.glsl): no box is read on the way, and their
/// number changes nothing but the way.
#pragma once

#include "tracer/scene/shapes.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <vector>

namespace gnomon {

/// Texels (vec4) of a block: {corner, radius of the ball about each object}, {size of a cell, 0}.
inline constexpr int kLatticeTexels = 2;

struct Lattice {
    glm::ivec3 cells{0};      ///< along x, y and z
    std::vector<int> members; ///< indices of shapes, one a cell, x fastest
};

/// The largest block among those of `shapes`, which have an extent, that `candidates` name; none where no
/// kSmallestLattice of them make one.
std::optional<Lattice> findLattice(std::span<const Shape> shapes, std::span<const int> candidates);
inline constexpr int kSmallestLattice = 8;

/// Appends the texels of a block, given its first and its last member.
void appendTexels(glm::ivec3 cells, const Shape& first, const Shape& last, std::vector<glm::vec4>&);

} // namespace gnomon
