/// Where a line passes into a solid, from nothing but its field.
///
/// A field never changes faster than the way: where it is f, the surface is no nearer than |f|. So steps of the field
/// pass nothing over, but for what is thinner than a quarter of the slack.
#pragma once

#include "lab/reference/exact/solid.h"

#include <limits>

namespace gnomon::oracle {

struct Passage {
    static constexpr double kNever = std::numeric_limits<double>::infinity();

    double from = kNever; ///< along the line: the surface is first as near as the slack
    double by = kNever;   ///< first as deep beyond it as the slack
    /// Between the two, or never, it is within the slack of the surface; else it grazes some of it, or takes too many
    /// steps to tell.
    bool decided = true;
    bool inside = false; ///< as the line begins, where it goes out, not in
};

/// Of the line p + s d from `first` to `last`.
Passage passageInto(const SolidField&, glm::dvec3 p, glm::dvec3 d, double first, double last, double slack);

} // namespace gnomon::oracle
