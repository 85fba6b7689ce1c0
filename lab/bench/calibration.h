/// The calibration workload: a fixed picture drawn beside what is measured. Whatever slows the machine or its GPU slows
/// both, so that times over those of the workload can be compared with those of another day.
#pragma once

#include "tracer/gl/objects.h"
#include "tracer/problem.h"

#include <array>

namespace gnomon {

class CalibrationWorkload {
  public:
    /// In the current context, which has to outlive it; `clock` counts the seconds, and tells so many well. A problem
    /// where the GL does not take its shader.
    CalibrationWorkload(double (*clock)(), double leastSeconds, Problems&);

    /// Seconds of one picture, from asking for it to its last pixel: the mean of so many as take `leastSeconds` here,
    /// and those of the constructor.
    double draw(double leastSeconds = 0);

  private:
    double drawOften(int times);

    double (*clock_)();
    /// The same again and again: where a program's code comes to lie in memory changes its times, by up to a fifth for
    /// so small a one on llvmpipe. Their mean changes less.
    std::array<gl::Program, 8> programs_;
    gl::VertexArray vertexArray_;
    gl::Target target_;
    double leastSeconds_, onceSeconds_ = 1;
};

} // namespace gnomon
