/// Two runs of the same measurement, held against each other row by row.
///
/// Rows are the same where their key columns are (Table::keys); what is compared says Column::kind.
/// Time, Ratio  where they have quartiles: what a single measurement says is chance. The interval of new to old is that
///              of quartiles.h, with the rows' `passes` or `rounds`; without bounds where neither is told. Those of all
///              rows of a column hold together with 95 %. A row is faster or slower where its interval does not hold 1,
///              which a column of one program twice has in one of twenty at most, and the ratio is farther from 1 than
///              a tolerance: what lasts for a run is in none of its spreads (docs/bench.md). Where a column
///              KEY_calibrated has a time over that of the calibration workload, the ratio is of these, from which the
///              machine's other work cancels, and times without are passed over.
/// Error        better or worse where its size changed by more than kErrorTolerance: there is no noise, but compilers
///              round in other orders.
/// Count        better or worse, or more or less where neither is, where it changed at all.
#pragma once

#include "lab/results/results.h"
#include "tracer/problem.h"

namespace gnomon {

inline constexpr double kErrorTolerance = 0.01; ///< of the greater one

/// The first table says of each compared column how many rows became what. Then a table for each column of times: old,
/// new, ratio, and a word for it; one for each table's errors and counts: those that changed; and one of the rows that
/// only one run has. The environment says what differs as `OLD → NEW`. Problems where rows cannot be told apart, or
/// where there is nothing to compare.
Results compareRuns(const Results& before, const Results& after, double tolerance, Problems&);

} // namespace gnomon
