/// Results as a page for people: one file that loads nothing.
#pragma once

#include "tracer/lab/results.h"
#include "tracer/problem.h"

#include <string>

namespace gnomon {

/// Tables that sort, charts, environment and command.
std::string toHtml(const Results&);

/// False, with a problem, where the file cannot be written.
bool writeText(const std::string& file, const std::string& text, Problems&);

} // namespace gnomon
