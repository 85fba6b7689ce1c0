/// The point of a height patch that is nearest to a given one, by branch and bound: certified, in double.
///
/// The squared distance to q is a polynomial of degree 6 in u and in v. Over any part of the square it is no less than
/// its least Bernstein coefficient there. Parts are halved, the one of the least bound first, until that bound and the
/// least distance found agree. Nothing is sampled and nothing is assumed about how many minima there are. A part is
/// dropped, too, where the distance rises or falls throughout and the patch does not end there, and needs no halving
/// where the distance is convex: a point at which its slope is all but 0, or leads out of the part, bounds it from
/// below.
///
/// It shares no code with the tracer. Rounding is in the certificate, as 1e-15 of how far the patch reaches from q.
/// 140 000 points a second about patches of the source's recipe, 27 parts each. A whole curve of nearest points, as the
/// axis of a bowl has, takes a tenth of a second.
#pragma once

#include "tracer/scene/height_patch.h"

namespace gnomon::oracle {

struct Foot {
    double distance = 0; ///< from q to the point of the patch at (u, v)
    double u = 0, v = 0;
    double slack = 0; ///< no point of the patch is nearer than distance - slack
    int parts = 0;    ///< looked at
};

class PatchDistance {
  public:
    /// The patch as tracer/scene/height_patch.h has it.
    PatchDistance(const Heights&, glm::dvec3 center, glm::dvec3 size);

    /// The slack is at most tolerance(), or 5e-15 of how far the patch reaches from q.
    Foot nearest(glm::dvec3 q) const;
    /// Positive above the surface, negative below; beside the rectangle, where there is no side, never negative.
    double signedDistance(glm::dvec3 q) const;
    /// 1e-10 of the patch's largest extent, its control points' in y.
    double tolerance() const { return tolerance_; }

  private:
    Heights heights_; ///< in world units, about the centre
    glm::dvec3 center_, size_;
    double tolerance_;
};

/// For one point.
inline Foot nearestOn(const Heights& heights, glm::dvec3 center, glm::dvec3 size, glm::dvec3 q) {
    return PatchDistance(heights, center, size).nearest(q);
}

} // namespace gnomon::oracle
