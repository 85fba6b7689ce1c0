/// Does float arithmetic of this GL keep the promises that docs/numerics.md makes? A driver that folds or re-orders it
/// breaks them silently: this measures it where the user is.
///
/// 2048 fixed rays from 10 000 units away, at a sphere and at a tilted torus about generic centres, half of them so
/// near to tangency that the answer hangs on the last bits of shaders/ray/split.glsl. Every answer of the GPU is
/// compared with a solution in double on the CPU, whose own error is below 2^-36 of the shapes' size.
#pragma once

#include "tracer/shader/library.h"

#include <span>
#include <string>

namespace gnomon {

struct NumericsSelfTest {
    bool measured = false;
    std::string problem;     ///< why it is not measured
    int rays = 0;            ///< all at least 2^-22 of the shape's size from tangency
    int wrong = 0;           ///< of them: missed, invented, on another sheet, or no number
    double worstPoint = 0;   ///< |signed distance of the surface point|, in 2^-23 of the shape's size
    double worstAlong = 0;   ///< |signed distance of o + t d|, in ulp of t
    double milliseconds = 0; ///< that it took, compiling included

    bool holds() const;
};

/// The bounds that docs/numerics.md states.
inline constexpr double kMostPoint = 4, kMostAlong = 1.5;

/// Measures the current context; needs float32 targets. Leaves framebuffer 0 bound and all GL state that a Renderer
/// relies on as it was. `overrides` take the place of library files: how tests show that it can fail.
NumericsSelfTest runNumericsSelfTest(std::span<const ShaderFile> overrides = {});

/// One line: what was found, and where it does not hold what that means.
std::string toString(const NumericsSelfTest&);
/// {"measured", "holds", "rays", "wrong", "worst_point", "worst_along", "milliseconds", "summary"}
std::string toJson(const NumericsSelfTest&);

} // namespace gnomon
