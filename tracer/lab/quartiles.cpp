#include "tracer/lab/quartiles.h"

#include <algorithm>
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

double notchOf(const Quartiles& quartiles, double rounds) {
    return 1.57 * (quartiles.high - quartiles.low) / std::sqrt(std::max(1.0, rounds));
}

Ratio ratioOfMedians(const Quartiles& times, double rounds, const Quartiles& base, double baseRounds) {
    const double notch = notchOf(times, rounds), baseNotch = notchOf(base, baseRounds);
    const double least = base.median - baseNotch;
    return {times.median / base.median, std::max(0.0, times.median - notch) / (base.median + baseNotch),
            least > 0 ? (times.median + notch) / least : std::numeric_limits<double>::infinity()};
}

} // namespace gnomon
