/// Results as a page for people: one file that loads nothing.
#pragma once

#include "lab/results/results.h"
#include "tracer/problem.h"

#include <span>
#include <string>

namespace gnomon {

/// Tables that sort, charts, environment and command, of one run or of several.
std::string toHtml(std::span<const Results>);

/// False, with a problem, where the file's folder is missing or the name is a folder's: to be asked before long work.
bool checkTextFile(const std::string& file, Problems&);
/// False, with a problem, where the file cannot be written.
bool writeText(const std::string& file, const std::string& text, Problems&);

} // namespace gnomon
