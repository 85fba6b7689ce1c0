/// Results as a page for people: one file that loads nothing.
#pragma once

#include "lab/results/results.h"

#include <span>
#include <string>

namespace gnomon {

/// Tables that sort, charts, environment and command, of one run or of several.
std::string toHtml(std::span<const Results>);

} // namespace gnomon
