/// Time for measuring.
#pragma once

#include <chrono>

namespace gnomon {

/// Seconds on a clock that never goes back.
inline double monotonicSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace gnomon
