/// Two runs of the same measurement, held against each other row by row.
///
/// Rows are the same where their key columns are (Table::keys); compared is every column in ms that has quartiles.
/// Where a column KEY_yards tells the same in yardsticks, the ratio is that of yardsticks, from which the machine's
/// other work cancels, and columns without are passed over. The ratio's interval is that of quartiles.h, with the rows'
/// `rounds`, or one where they are not told. A row is faster or slower where the interval does not hold 1 and the ratio
/// is farther from it than a tolerance: runs of one and the same program differ by more than their spreads tell
/// (docs/bench.md).
#pragma once

#include "tracer/lab/results.h"
#include "tracer/problem.h"

namespace gnomon {

/// A table for each column that both runs measured: old, new, ratio, and a word for it. The environment says what
/// differs as `OLD → NEW`, and how many rows only one run has. Problems where rows cannot be told apart, or where there
/// is nothing to compare.
Results compareRuns(const Results& before, const Results& after, double tolerance, Problems&);

/// `frame: 3 faster, 1 slower, 8 the same within noise`, a line for each table of a comparison.
std::string comparisonSummary(const Results&);

} // namespace gnomon
