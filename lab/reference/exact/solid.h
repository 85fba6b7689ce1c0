/// A solid's field in double, as its tree says: what the shader's generated code is held against.
#pragma once

#include "lab/reference/exact/exact_shape.h"
#include "tracer/scene/solid.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace gnomon::oracle {

/// Signed distance as the operations define it (tracer/scene/solid.h). Closed analytic shapes by
/// lab/reference/exact/exact_shape.h; a Mandelbulb's estimate by its own formula. What does not depend on the point is
/// worked out once.
class SolidField {
  public:
    explicit SolidField(const SolidNode&);
    double at(glm::dvec3 p) const;

  private:
    double ofShape(glm::dvec3 p) const;
    double ofCopies(glm::dvec3 p) const;

    SolidNode node_; ///< its own values; the parts lie in of_
    std::optional<ExactShape<double>> shape_;
    glm::dmat3 back_{1}; ///< of a Transform: undoes rotation and scale
    std::vector<SolidField> of_;
};

/// For one point.
inline double fieldOf(const SolidNode& node, glm::dvec3 p) { return SolidField(node).at(p); }

} // namespace gnomon::oracle
