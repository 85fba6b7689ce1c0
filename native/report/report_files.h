/// The files a report is made of, embedded when the program is built: web/report/* and Chart.js.
#pragma once

#include <string_view>

namespace gnomon {

/// report.html, report.css, report.js or chart.min.js.
std::string_view reportFile(std::string_view name);

} // namespace gnomon
