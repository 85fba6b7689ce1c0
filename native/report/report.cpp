#include "native/report/report.h"

#include "native/report/report_page.h"

namespace gnomon {
namespace {

/// As text of an element it must neither end it nor open a comment that swallows the end. In JSON < stands in strings
/// alone.
std::string inScript(const std::string& json) {
    std::string text;
    for (const char c : json)
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text;
}

} // namespace

std::string toHtml(std::span<const Results> runs) {
    std::string list;
    for (const Results& run : runs) list += (list.empty() ? "[" : ",\n") + toJson(run);
    const std::string_view page = reportPage(), mark = "/*results*/";
    const std::size_t at = page.find(mark);
    return std::string(page.substr(0, at)) + inScript(list + "]") + std::string(page.substr(at + mark.size()));
}

} // namespace gnomon
