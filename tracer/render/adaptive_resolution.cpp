#include "tracer/render/adaptive_resolution.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gnomon {
namespace {

constexpr double kScales[] = {1, 0.75, 0.5, 0.375, 0.25, 0.1875};
constexpr int kCoarsest = int(std::size(kScales)) - 1;
constexpr double kLongest = 0.15;  // seconds a moving picture may take
constexpr double kQuick = 0.075;   // what takes less may be drawn finer
constexpr int kMostPatience = 256; // pictures
constexpr double kBand = 0.1;      // seconds a band of a still picture should take

} // namespace

double AdaptiveResolution::scale() const { return kScales[level_]; }

void AdaptiveResolution::tookPicture(double seconds) {
    if (seconds > kLongest && level_ < kCoarsest) {
        // How much too long says how much coarser, at least by one step.
        const double wanted = scale() * std::sqrt(kLongest / seconds);
        do ++level_;
        while (level_ < kCoarsest && scale() > wanted);
        wait_ = patience_;
        patience_ = std::min(2 * patience_, kMostPatience);
    } else if (seconds < kQuick && level_ > 0 && --wait_ < 0) {
        --level_;
        wait_ = 0;
    }
}

void AdaptiveResolution::tookBand(double seconds) {
    band_ = std::clamp(band_ * std::clamp(kBand / seconds, 0.5, 2.0), 1e-4, 1.0);
}

int AdaptiveResolution::rows(int height) const { return std::clamp(int(std::lround(height * band_)), 1, height); }

} // namespace gnomon
