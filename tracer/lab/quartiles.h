/// Times that vary, told by their median and quartiles, which a few disturbed rounds do not move.
///
/// quartilesOf  linear between the sorted values that lie around the place
/// notchOf      half the width of the interval about a median in which it would be found again: 1.57 (q3 - q1) /
/// sqrt(n).
///              Two medians whose notches do not overlap differ at about the 5 % level
/// Source       McGill, Tukey, Larsen: Variations of Box Plots, The American Statistician 32 (1978)
/// Limits       rounds are taken to be independent; what disturbs a whole run is in no spread of it
#pragma once

#include <vector>

namespace gnomon {

struct Quartiles {
    double low = 0, median = 0, high = 0;
};
Quartiles quartilesOf(std::vector<double> values);
/// Of one series of times to another, round by round: what drifts from round to round cancels.
Quartiles ratioOf(const std::vector<double>& times, const std::vector<double>& base);

double notchOf(const Quartiles&, double rounds);

/// A ratio and the interval that noise leaves it.
struct Ratio {
    double value = 1, low = 1, high = 1;
};
/// Of two medians of different runs, from the notches of both. The interval ends at infinity where noise leaves the
/// base no certain size.
Ratio ratioOfMedians(const Quartiles& times, double rounds, const Quartiles& base, double baseRounds);

} // namespace gnomon
