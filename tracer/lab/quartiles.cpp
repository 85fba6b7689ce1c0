#include "tracer/lab/quartiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace gnomon {

Quartiles quartilesOf(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        const double place = share * double(values.size() - 1);
        const std::size_t below = std::size_t(place), above = std::min(below + 1, values.size() - 1);
        return values[below] + (place - double(below)) * (values[above] - values[below]);
    };
    return {at(0.25), at(0.5), at(0.75)};
}

Quartiles ratioOf(const std::vector<double>& times, const std::vector<double>& base) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(times.size(), base.size()); ++i) ratios.push_back(times[i] / base[i]);
    return quartilesOf(std::move(ratios));
}

double notchOf(const Spread& spread) {
    constexpr std::array<double, 6> kOfFew{4.85, 2.37, 2.03, 2.24, 1.79, 1.70}; // of 2 to 7 rounds
    const bool few = spread.rounds >= 2 && spread.rounds < 8;
    const double k = few ? kOfFew[std::size_t(spread.rounds) - 2] : 1.57;
    return k * (spread.quartiles.high - spread.quartiles.low) / std::sqrt(std::max(1.0, spread.independent));
}

Ratio ratioOfMedians(const Spread& times, const Spread& base) {
    const double median = times.quartiles.median, baseMedian = base.quartiles.median;
    const double notch = notchOf(times), baseNotch = notchOf(base), least = baseMedian - baseNotch;
    return {median / baseMedian, std::max(0.0, median - notch) / (baseMedian + baseNotch),
            least > 0 ? (median + notch) / least : std::numeric_limits<double>::infinity()};
}

} // namespace gnomon
