/// A hierarchy as shaders/accel/hierarchy.glsl reads it: two texels (vec4) for the grid, one for each node.
///
/// Grid   {low, longest side}, {cells a unit along x, y, z, 0}: the root's box in 4095 cells an axis
/// Node   {x, y, z, link}: low + 4096 * high of the box in cells, whole numbers below 2^24, which float32 holds;
///        link is the skip of an inner node, -1 - primitive for a leaf, whose skip is the next node
/// Error  boxes only grow, by less than two cells a side (tests/unit/node_texels_test.cpp)
/// Limits 2^24 nodes; a ray finds what it should where it allows for its own rounding, as the shader does
#pragma once

#include "tracer/accel/hierarchy.h"

namespace gnomon {

inline constexpr int kQuantisationTexels = 2;
inline constexpr int kQuantisationSteps = 4095;

/// Texels of a hierarchy of that many primitives.
inline int hierarchyTexels(int primitives) { return primitives > 0 ? kQuantisationTexels + nodesFor(primitives) : 0; }

/// Appends them, of two children the one nearer to `eye` first: rays from there meet first what lies first.
void appendTexels(const Hierarchy&, glm::vec3 eye, std::vector<glm::vec4>&);

} // namespace gnomon
