#include "lab/interruption.h"

#include "tracer/clock.h"

#include <atomic>
#include <csignal>
#include <unistd.h>

namespace gnomon {

namespace {

/// Some programs send their signal to a process and then to its group: that is one interruption, not two.
constexpr double kOneInterruption = 0.5; // seconds

std::atomic<int> exitCode{130};
std::atomic<bool> deferred{false}, came{false};
std::atomic<double> cameAt{0};

extern "C" void interrupt(int) {
    const double now = monotonicSeconds();
    if (came && now - cameAt < kOneInterruption) return;
    if (!deferred || came) _exit(exitCode);
    cameAt = now;
    came = true;
}

} // namespace

void endWhenInterrupted(int code) {
    exitCode = code;
    struct sigaction action {};
    action.sa_handler = interrupt;
    action.sa_flags = SA_RESTART; // reading and writing go on: a measurement ends between them
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

void deferInterruption() { deferred = true; }

bool interrupted() { return came; }

} // namespace gnomon
