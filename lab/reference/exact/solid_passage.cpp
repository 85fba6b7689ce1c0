#include "lab/reference/exact/solid_passage.h"

#include <algorithm>
#include <cmath>

namespace gnomon::oracle {

Passage passageInto(const SolidField& field, glm::dvec3 p, glm::dvec3 d, double first, double last, double slack) {
    constexpr int kMostSteps = 4000;
    Passage passage;
    const double least = slack / 4, start = field.at(p + first * d);
    passage.inside = start < 0;
    const double side = passage.inside ? -1 : 1;
    bool near = false;
    double s = first;
    for (int i = 0; i < kMostSteps; ++i) {
        const double free = side * field.at(p + s * d);
        if (free < -slack) {
            passage.by = s;
            passage.from = std::min(passage.from, s);
            return passage;
        }
        if (free <= slack) {
            passage.from = std::min(passage.from, s);
            near = true;
        } else if (near) {
            passage.decided = false; // it has grazed
            near = false;
        }
        if (s >= last) {
            passage.decided = passage.decided && !near;
            return passage;
        }
        s = std::min(s + std::max(free <= slack ? free + slack : free - slack, least), last);
    }
    passage.from = std::min(passage.from, s);
    passage.decided = false;
    return passage;
}

} // namespace gnomon::oracle
