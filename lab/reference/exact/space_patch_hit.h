/// All that a ray meets of a bicubic Bézier patch in space, in double.
///
/// Parts of the parameter square are halved until one is certain: its net's hull, seen along the ray, misses 0, or its
/// slopes differ by less than half from their mean, so that it holds one crossing at most, which the mean's inverse
/// contracts to. Parts that neither holds for at 2^-40 of the square hold a crossing within 1e-12 of tangency.
#pragma once

#include "tracer/scene/space_patch.h"

#include <glm/glm.hpp>

#include <vector>

namespace gnomon::oracle {

struct PatchCrossing {
    double t = 0;
    glm::dvec2 uv{0};
    bool tangent = false; ///< the two sheets there are one
};

struct PatchPoint {
    glm::dvec3 place{0}, alongU{0}, alongV{0};
    glm::dvec3 normal{0}; ///< unit; where an edge is one point, the limit
};

class ExactPatch {
  public:
    /// `net` as its numbers are; the ray's places are relative to its anchor.
    explicit ExactPatch(const SpaceNet& net);

    /// By t, of both signs.
    std::vector<PatchCrossing> crossings(glm::dvec3 origin, glm::dvec3 direction) const;
    PatchPoint at(glm::dvec2 uv) const;
    /// The surface's point nearest to `p`, from a start near it.
    glm::dvec2 footNear(glm::dvec3 p, glm::dvec2 start) const;

  private:
    std::array<glm::dvec4, 16> points_;
};

} // namespace gnomon::oracle
