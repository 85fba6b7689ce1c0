#include "native/report/report.h"

#include "native/report/report_files.h"

namespace gnomon {
namespace {

/// Script text must not end its element, nor open a comment that swallows the end.
std::string inScript(std::string text) {
    for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos; at += 3) text.insert(at + 1, "\\");
    for (std::size_t at = 0; (at = text.find("<!--", at)) != std::string::npos; at += 5) text.insert(at + 1, "\\");
    return text;
}

void put(std::string& page, const std::string& mark, const std::string& text) {
    page.replace(page.find(mark), mark.size(), text);
}

} // namespace

std::string toHtml(std::span<const Results> runs) {
    std::string list;
    for (const Results& run : runs) list += (list.empty() ? "[" : ",\n") + toJson(run);
    std::string page(reportFile("report.html"));
    put(page, "/*style*/", std::string(reportFile("report.css")));
    put(page, "/*chart*/", std::string(reportFile("chart.min.js")));
    put(page, "/*report*/", std::string(reportFile("report.js")));
    put(page, "/*results*/", inScript(list + "]"));
    return page;
}

} // namespace gnomon
