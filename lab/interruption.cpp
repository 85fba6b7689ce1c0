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
std::atomic<bool> noting{false}, noted{false};
std::atomic<double> notedAt{0};

extern "C" void interrupt(int) {
    const double now = monotonicSeconds();
    if (noted && now - notedAt < kOneInterruption) return;
    if (!noting || noted) _exit(exitCode);
    notedAt = now;
    noted = true;
}

} // namespace

void endWhenInterrupted(int code) {
    exitCode = code;
    struct sigaction action {};
    action.sa_handler = interrupt;
    action.sa_flags = SA_RESTART; // reading and writing go on: a measurement ends between them
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

void noteInterruption() { noting = true; }

bool interrupted() { return noted; }

} // namespace gnomon
