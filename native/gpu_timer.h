/// Seconds of the GPU, by the GL's timer queries where it has them. llvmpipe has some, but what they tell is a share of
/// the frame that changes with its length: where the processor draws, there is no GPU to time.
#pragma once

#include "native/context.h"

#include <optional>

namespace gnomon {

class GpuTimer {
  public:
    /// In the current context, which has to outlive it.
    explicit GpuTimer(const Context&);
    ~GpuTimer();
    GpuTimer(const GpuTimer&) = delete;
    GpuTimer& operator=(const GpuTimer&) = delete;

    void begin();
    void end();
    /// Between the last begin() and end(), whose work is finished. None where this GL cannot tell.
    std::optional<double> seconds();

  private:
    GLuint query_ = 0;
    PFNGLGETQUERYOBJECTUI64VPROC getResult_ = nullptr; ///< null: there are no timers
};

} // namespace gnomon
