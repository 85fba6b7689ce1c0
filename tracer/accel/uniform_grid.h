/// Cells: a grid over objects, each cell with a list of those that reach into it. A ray walks from cell to cell
/// (shaders/accel/uniform_grid.glsl): where objects lie evenly scattered it reads less than of a hierarchy, and
/// neighbouring rays take about as many steps.
///
/// planGrid    how many cells cost a ray least, among grids of cubes of several sizes; none where objects lie too far
///              from 0 for float32 to place the walls, or all over one another
/// appendGrid  the grid over the objects as they lie now: what moving objects need each frame. As many cells as
///              planned, and as many texels, wherever the objects have gone: where lists outgrow their room, the grid
///              is stretched until they fit
/// Texels       {corner, 0}, {size of a cell, 0}, a list for each cell, x fastest, then `continued` for what goes on.
///              A list: three objects, -1 for none, and the texel where it goes on, counted from the first list, -1 at
///              its end
/// Error        an object is listed in every cell that it comes nearer to than 1/64 of a cell; the ray knows the walls
///              to 2^-20 (shaders/accel/walk.glsl; tests/unit/uniform_grid_test.cpp)
/// Source       A. Fujimoto, T. Tanaka, K. Iwata, ARTS: Accelerated Ray-Tracing System, 1986; the choice by the
/// surfaces
///              of cells as for hierarchies
#pragma once

#include "tracer/accel/bounds.h"

#include <optional>
#include <span>
#include <vector>

namespace gnomon {

inline constexpr int kGridHeadTexels = 2;
inline constexpr int kCellListed = 3; ///< objects in one texel of a list

struct GridPlan {
    glm::ivec3 count{0};   ///< cells along each axis
    int continued = 0;     ///< texels for lists that go on
    double iterations = 0; ///< of the loop in the shader, for a line that meets the grid, on average

    bool operator==(const GridPlan&) const = default;
    int cells() const { return count.x * count.y * count.z; }
    int texels() const { return cells() > 0 ? kGridHeadTexels + cells() + continued : 0; }
};

std::optional<GridPlan> planGrid(std::span<const Bounds> objects);

/// As many objects as it was planned for.
void appendGrid(const GridPlan&, std::span<const Bounds> objects, std::vector<glm::vec4>&);

} // namespace gnomon
