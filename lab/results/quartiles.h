/// Times that vary, told by their median and quartiles, which a few disturbed rounds do not move.
///
/// quartilesOf  linear between the sorted values that lie around the position
/// notchOf      half the width of the interval about a median, k (q3 - q1) / sqrt(n) of n independent rounds. k grows
///              with the rows that are read together: of a column of so many rows that do not differ, one or more are
///              told apart, their notches not overlapping, in at most 5 % of columns, whatever the rows share
///              (Bonferroni). Infinite where n is 1, for one value says nothing of its noise
/// Source       McGill, Tukey, Larsen: Variations of Box Plots, The American Statistician 32 (1978). Their k, 1.57, is
///              for two medians of many rounds; few have quartiles that are too close to one another by chance, the
///              more so the rarer a chance is looked for. So ours are simulated: quantiles of |m - m'| sqrt(n) / (IQR +
///              IQR') over 20 million pairs of normal samples
/// Error        columns of 24 rows with a false one: 4.5 to 5 % of 2 to 9 rounds, .5 % of 15, whose k is that of 9; of
///              three rounds 4.9 % where noise is lognormal by .3, 3 % Laplacian, 6.5 % exponential, 11 % uniform
/// Limits       runs of unlike noise are told apart more often: of three rounds in 7 % of such columns where one has
///              twice the noise, 15 % where four times, half of them where one has none. What disturbs a whole run is
///              in no spread of it, nor luck of few kinds, where all rounds of one run met one and of the other another
#pragma once

#include <cstddef>
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
    double independent = 1; ///< rounds; compilations, where several rounds share the luck of one; 1: not told
};
/// One of so many rows.
double notchOf(const Spread&, std::size_t rows);

/// A ratio and the interval that noise leaves it.
struct Ratio {
    double value = 1, low = 1, high = 1;
};
/// Of two medians of different runs, from the notches of both: the intervals of so many rows hold together with 95 %.
/// They end at infinity where noise leaves the base no certain size.
Ratio ratioOfMedians(const Spread& times, const Spread& base, std::size_t rows);

} // namespace gnomon
