#include "lab/results/quartiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace gnomon {

Quartiles quartilesOf(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto at = [&](double fraction) {
        const double position = fraction * double(values.size() - 1);
        const std::size_t below = std::size_t(position), above = std::min(below + 1, values.size() - 1);
        return values[below] + (position - double(below)) * (values[above] - values[below]);
    };
    return {at(0.25), at(0.5), at(0.75)};
}

Quartiles ratioOf(const std::vector<double>& times, const std::vector<double>& base) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(times.size(), base.size()); ++i) ratios.push_back(times[i] / base[i]);
    return quartilesOf(std::move(ratios));
}

namespace {

/// k where it misses with the odds of 5 %, and with a fifth of the odds from column to column, for 2 to 9 rounds. What
/// nine need is enough for more. That four rounds need less than five is no slip: the quartiles of five are two of its
/// values, those of four lie between values.
constexpr std::array<std::array<double, 6>, 8> kNotches{{{4.85, 11.2, 25.2, 56.0, 124, 283},
                                                         {2.37, 3.81, 5.83, 8.81, 13.2, 20.0},
                                                         {2.03, 3.14, 4.44, 6.03, 7.97, 10.6},
                                                         {2.23, 3.75, 5.97, 9.29, 14.3, 22.4},
                                                         {1.79, 2.73, 3.89, 5.34, 7.25, 9.75},
                                                         {1.70, 2.46, 3.30, 4.27, 5.40, 6.72},
                                                         {1.61, 2.32, 3.08, 3.93, 4.90, 6.04},
                                                         {1.68, 2.44, 3.29, 4.29, 5.51, 6.98}}};

} // namespace

double notchOf(const Spread& spread, std::size_t rows) {
    if (spread.independent < 2) return std::numeric_limits<double>::infinity();
    const auto& kOf = kNotches[std::min(std::size_t(spread.independent) - 2, kNotches.size() - 1)];
    // Each of m rows may miss with the odds of 5 % / m. Tails are powers, straight lines of both logarithms.
    const double fifths = std::log(double(rows)) / std::log(5.0);
    const std::size_t before = std::min(std::size_t(fifths), kOf.size() - 2);
    const double k = kOf[before] * std::pow(kOf[before + 1] / kOf[before], fifths - double(before));
    return k * (spread.quartiles.high - spread.quartiles.low) / std::sqrt(spread.independent);
}

Ratio ratioOfMedians(const Spread& times, const Spread& base, std::size_t rows) {
    const double median = times.quartiles.median, baseMedian = base.quartiles.median;
    const double notch = notchOf(times, rows), baseNotch = notchOf(base, rows), least = baseMedian - baseNotch;
    return {median / baseMedian, std::max(0.0, median - notch) / (baseMedian + baseNotch),
            least > 0 ? (median + notch) / least : std::numeric_limits<double>::infinity()};
}

} // namespace gnomon
