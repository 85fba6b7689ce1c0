#include "lab/progress.h"

#include "lab/interruption.h"
#include "tracer/clock.h"
#include "tracer/gl/gl.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>
#include <utility>

namespace gnomon {

namespace {

constexpr double kPlainSeconds = 10; // between lines, where there is no terminal

} // namespace

bool softwareRasterised() { return gl::drawnByProcessor(gl::info().renderer); }

double (*labClock())() { return softwareRasterised() ? processSeconds : monotonicSeconds; }

std::string labClockName() { return softwareRasterised() ? "CPU time of the process, all threads" : "wall clock"; }

LabProgress::LabProgress(std::size_t all, std::string done, double deadline)
    : all_(all), what_(std::move(done)), started_(monotonicSeconds()), told_(started_), deadline_(deadline) {
    deferInterruption();
}

LabProgress::~LabProgress() {
    if (isatty(STDERR_FILENO)) std::fputs("\r\x1b[K", stderr);
}

bool LabProgress::step() {
    ++done_;
    const bool terminal = isatty(STDERR_FILENO);
    const double now = monotonicSeconds();
    if (now - told_ < (terminal ? 0.1 : kPlainSeconds)) return !interrupted();
    told_ = now;
    const double left = (now - started_) / double(done_) * double(all_ - std::min(done_, all_));
    std::fprintf(stderr, "%s%s %zu of %zu, %.0f s left%s", terminal ? "\r" : "gnomon: ", what_.c_str(), done_, all_,
                 std::max(0.0, std::min(left, deadline_ - now)), terminal ? "\x1b[K" : "\n");
    return !interrupted();
}

bool LabProgress::interrupted() { return gnomon::interrupted(); }

} // namespace gnomon
