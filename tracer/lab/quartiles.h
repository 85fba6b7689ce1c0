/// Times that vary, told by their median and quartiles, which a few disturbed rounds do not move.
///
/// quartilesOf  linear between the sorted values that lie around the place
/// notchOf      half the width of the interval about a median in which it would be found again: k (q3 - q1) / sqrt(n).
///              Two medians whose notches do not overlap differ at about the 5 % level
/// Source       McGill, Tukey, Larsen: Variations of Box Plots, The American Statistician 32 (1978): k = 1.57 for many
///              rounds. Few have quartiles that are too close to one another by chance: their k are those with which 5
///              % of 200 000 pairs of normal samples of that size are told apart (with 1.57: 30 % of pairs, 15 % of
///              threes)
/// Limits       what disturbs a whole run is in no spread of it
#pragma once

#include <vector>

namespace gnomon {

struct Quartiles {
    double low = 0, median = 0, high = 0;
};
Quartiles quartilesOf(std::vector<double> values);
/// Of one series of times to another, round by round: what drifts from round to round cancels.
Quartiles ratioOf(const std::vector<double>& times, const std::vector<double>& base);

/// How the median of a measurement came about.
struct Spread {
    Quartiles quartiles;
    double rounds = 1;      ///< that the quartiles are of; 1: not told
    double independent = 1; ///< of those: rounds of one compilation share its luck
};
double notchOf(const Spread&);
/// So often are two medians of the same told apart by their notches.
inline constexpr double kNotchMiss = 0.05;

/// A ratio and the interval that noise leaves it.
struct Ratio {
    double value = 1, low = 1, high = 1;
};
/// Of two medians of different runs, from the notches of both. The interval ends at infinity where noise leaves the
/// base no certain size.
Ratio ratioOfMedians(const Spread& times, const Spread& base);

} // namespace gnomon
