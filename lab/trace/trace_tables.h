/// What `gnomon lab trace` shows of its measurements.
#pragma once

#include "lab/results/results.h"
#include "lab/trace/trace_lab.h"

#include <string>
#include <vector>

namespace gnomon {

/// Every view in every way.
Table viewTable(const std::vector<ViewCosts>&);
/// Spheres, beside the least number of them in the same arrangement and way.
Table growthTable(const std::vector<GrowthCosts>&);
/// The cost model against the clock: what `auto` takes beside the best of all ways.
Table choiceTable(const std::vector<ViewCosts>&, const std::vector<GrowthCosts>&);

std::vector<Chart> traceCharts();

/// How much longer a frame of the most spheres takes than one of the fewest, a line for each arrangement.
std::string growthSummary(const std::vector<GrowthCosts>&);

/// What each way draws, beside the first way of the same picture: a plain loop, where one is drawn.
void addTracePictures(const std::vector<ViewCosts>&, const std::vector<GrowthCosts>&, Results&);

} // namespace gnomon
