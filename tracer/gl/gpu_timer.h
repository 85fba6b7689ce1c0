/// Seconds of the GPU, by the GL's timer queries where it has them.
#pragma once

#include "tracer/gl/objects.h"

#include <optional>

namespace gnomon::gl {

class GpuTimer {
  public:
    /// In the current context, which has to outlive it.
    explicit GpuTimer(Resolver);

    void begin();
    void end();
    /// seconds() can be asked for. A browser answers only once the page has paused, the desktop waits for it.
    bool ready();
    /// Between the last begin() and end(), whose work is finished. None where this GL cannot tell.
    std::optional<double> seconds();

  private:
    Query query_; ///< empty: there are no timers
    Function function_ = nullptr;
};

} // namespace gnomon::gl
