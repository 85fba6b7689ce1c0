/// Reads back what toJson(Results) wrote (docs/results.md).
#pragma once

#include "lab/results/results.h"
#include "tracer/problem.h"

#include <optional>
#include <string>
#include <string_view>

namespace gnomon {

/// Nothing, with one problem that says where it stands, if the text is no results file that this program knows. Every
/// row then has a cell for every column, and every chart draws columns that there are. Members it does not know are
/// passed over. What an earlier version called otherwise has its present name (earlier_names.h).
std::optional<Results> readResults(std::string_view text, const std::string& file, Problems&);

} // namespace gnomon
