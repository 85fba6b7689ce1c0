/// What `gnomon lab shadows` measured, as tables and charts.
#pragma once

#include "lab/results/results.h"
#include "lab/shadows/shadow_lab.h"

#include <vector>

namespace gnomon {

/// Every way under every light: cost, evaluations, errors.
Table shadowTable(const std::vector<ShadowCosts>&);
/// As the source document's tables 6.1 to 6.3: epsilon by variant and cone origin, frame times without shadows = 1.
Table variantTable(const std::vector<ShadowCosts>&);
/// The best of ours beside the source's linear variant at epsilon 1/30 and Monte Carlo at equal time.
Table rivalTable(const std::vector<ShadowCosts>&);
/// Speed against error with its front for each radius, and the time over epsilon.
std::vector<Chart> shadowCharts(const std::vector<ShadowCosts>&);
/// What each way draws, beside the reference of that title.
void addShadowPictures(const std::vector<ShadowCosts>&, const std::string& reference, Results&);

} // namespace gnomon
