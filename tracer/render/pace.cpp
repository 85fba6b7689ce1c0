#include "tracer/render/pace.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

constexpr double kPatience = 0.1;  // seconds a moving picture may take
constexpr double kToGoFiner = 0.7; // of it: else the scale would swing between two steps
constexpr double kStep = 0.05;     // seconds of a still picture's band
constexpr double kScales[] = {1, 0.75, 0.5, 0.375, 0.25, 0.1875, 0.125};

} // namespace

void Pace::took(double seconds, double scale) {
    fullSeconds_ = seconds / (scale * scale);
    for (double next : kScales) {
        const double expected = fullSeconds_ * next * next;
        scale_ = next;
        if (expected <= (next > scale ? kToGoFiner * kPatience : kPatience)) return;
    }
}

int Pace::rows(int height) const {
    if (fullSeconds_ <= 0) return height;
    return std::clamp(int(std::lround(height * kStep / fullSeconds_)), 1, height);
}

} // namespace gnomon
