/// A measurement's clock, and what is left of it to do.
#pragma once

#include <cstddef>
#include <string>

namespace gnomon {

/// The current context is a software rasteriser.
bool softwareRasterised();
/// The clock for the current context: CPU time of the process on a software rasteriser, else the wall clock.
double (*labClock())();
/// What labClock() counts, in words.
std::string labClockName();

/// Says what is left to do, on a terminal in one line, else a line every ten seconds; from the first one on an
/// interruption is put off (interruption.h).
class LabProgress {
  public:
    /// `done` stands before the counts. No time left is told beyond `deadline` on the monotonic clock.
    explicit LabProgress(std::size_t all, std::string done = "done", double deadline = 1e300);
    ~LabProgress();
    LabProgress(const LabProgress&) = delete;
    LabProgress& operator=(const LabProgress&) = delete;

    /// One more is done. False once the user wants no more: what is done is to be kept.
    bool step();
    static bool interrupted();

  private:
    std::size_t done_ = 0, all_;
    std::string what_;
    double started_, told_, deadline_;
};

} // namespace gnomon
