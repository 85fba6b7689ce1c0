/// The report's page, embedded when the program is built: web/report/* and Chart.js.
#pragma once

#include <string_view>

namespace gnomon {

/// With the mark `/*results*/` where they belong. Nothing but its own scripts and styles may run in it.
std::string_view reportPage();

} // namespace gnomon
