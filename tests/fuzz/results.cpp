/// Any bytes as a file of results: what is read is written, read again as the same, and held against itself.
#include "lab/results/compare.h"
#include "lab/results/read_results.h"
#include "tests/fuzz/fuzz.h"

#include <cstdint>

using namespace gnomon;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Problems problems;
    const auto results = readResults({reinterpret_cast<const char*>(data), size}, "results.json", problems);
    fuzz::requireTold(!results, problems);
    if (!results) return 0;
    const std::string text = toJson(*results);
    const auto again = readResults(text, "again.json", problems);
    fuzz::require(again.has_value(), "what is written is read", problems);
    fuzz::require(toJson(*again) == text, "results that were read again are the same");
    for (const Table& table : results->tables) toMarkdown(table);
    compareRuns(*results, *again, 0.05, problems);
    return 0;
}
