/// Time for measuring.
#pragma once

#include <chrono>
#include <ctime>

namespace gnomon {

/// Seconds on a clock that never goes back.
inline double monotonicSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// CPU seconds of the process, all threads together: measures a GL in software even on a busy machine.
inline double processSeconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

} // namespace gnomon
