/// What a BenchRun measured as text that another one continues from: a browser measures in several sessions, each of
/// which begins it anew.
#pragma once

#include "lab/bench/bench_run.h"

#include <string>
#include <vector>

namespace gnomon {

/// A line for each entry of the plan, all numbers whole.
std::string seriesText(const std::vector<BenchCost>&);

/// Empty where the text is not one of seriesText().
std::vector<BenchCost> readSeries(const std::string&);

} // namespace gnomon
