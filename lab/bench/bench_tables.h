/// What `gnomon bench` and the page's compare() show of their measurements.
#pragma once

#include "lab/bench/bench_run.h"
#include "lab/results/results.h"

#include <string>
#include <utility>
#include <vector>

namespace gnomon {

/// What was measured in one context, as `--context` or the page names it; `costs` as the plan's entries.
struct ContextCosts {
    std::string context;
    Environment environment;
    std::vector<BenchCost> costs;
    int rounds = 0;
};

/// A row for each entry that was drawn in each context.
Table benchTable(const BenchPlan&, const std::vector<ContextCosts>&);
/// What of it fits a terminal.
Table briefTable(const Table& benchTable);
/// FPS over depth, a line for each shadow model, a small chart for each scene, one such row of charts for all else that
/// varies. Bars where there is one depth only.
std::vector<Chart> benchCharts(const BenchPlan&, const std::vector<std::string>& contexts);
/// One environment for all: what is not the same in every context stands as `osmesa: …; egl: …`.
Environment mergedEnvironment(const std::vector<ContextCosts>&);

/// All of it; `contexts` are all that the charts are of.
Results benchResults(const BenchPlan&, const std::vector<ContextCosts>&, const std::vector<std::string>& contexts,
                     const std::string& command);

} // namespace gnomon
