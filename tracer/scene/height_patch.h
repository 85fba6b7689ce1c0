/// A bicubic Bézier surface over a rectangle, told by the heights of its control net: the surface of the third source.
///
/// At (u, v) in [0, 1]² lies center + ((u - ½) size.x, height(u, v) size.y, (v - ½) size.z), with
/// height(u, v) = Σ B_i(u) B_j(v) heights[4 j + i] and B the cubic Bernstein polynomials.
#pragma once

#include <glm/glm.hpp>

#include <array>

namespace gnomon {

using Heights = std::array<double, 16>; ///< row by row along u

/// The control heights of a seed, by the source's recipe: each uniform in [-1, 1] over the maxima of its two Bernstein
/// polynomials, so that no control point moves the surface more than another. The same on every machine.
Heights randomHeights(unsigned seed);

/// Of the surface at (u, v), by de Casteljau.
double heightAt(const Heights&, double u, double v);

/// The part over [low, high] of the square, as a net over a square of its own. `high` may be below `low`: turned round.
Heights partOf(const Heights&, glm::dvec2 low, glm::dvec2 high);

/// Least and greatest height: bounds that are met to 1e-3 of the range that the control heights have.
std::array<double, 2> heightRange(const Heights&);

} // namespace gnomon
