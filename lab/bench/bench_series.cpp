#include "lab/bench/bench_series.h"

#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace gnomon {
namespace {

/// A line is `drawn passes bytes buildMs compileMs firstSeconds`, then each series with its length before it.
constexpr std::vector<double> BenchCost::*kSeries[] = {&BenchCost::wall, &BenchCost::cpu, &BenchCost::gpu,
                                                       &BenchCost::calibrated};

void append(double number, std::string& line) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g ", number); // as many digits as tell every double apart
    line += text;
}

/// Reads one number after the other; `good` ends where something else stands.
struct Numbers {
    const char* at;
    bool good = true;

    double next() {
        char* end = nullptr;
        const double number = std::strtod(at, &end);
        good = good && end != at;
        at = end;
        return number;
    }
};

BenchCost readCost(Numbers& numbers, std::size_t most) {
    BenchCost cost;
    cost.drawn = numbers.next() != 0;
    cost.passes = int(numbers.next());
    cost.program.sourceBytes = std::size_t(numbers.next());
    cost.program.buildMs = numbers.next();
    cost.program.compileMs = numbers.next();
    cost.firstSeconds = numbers.next();
    for (const auto series : kSeries) {
        const double count = numbers.next();
        numbers.good = numbers.good && count >= 0 && count <= double(most); // a number needs room in the text
        for (double i = 0; numbers.good && i < count; ++i) (cost.*series).push_back(numbers.next());
    }
    return cost;
}

} // namespace

std::string seriesText(const std::vector<BenchCost>& costs) {
    std::string text;
    for (const BenchCost& cost : costs) {
        for (const double number : {double(cost.drawn), double(cost.passes), double(cost.program.sourceBytes),
                                    cost.program.buildMs, cost.program.compileMs, cost.firstSeconds})
            append(number, text);
        for (const auto series : kSeries) {
            append(double((cost.*series).size()), text);
            for (const double seconds : cost.*series) append(seconds, text);
        }
        text.back() = '\n';
    }
    return text;
}

std::vector<BenchCost> readSeries(const std::string& text) {
    std::vector<BenchCost> costs;
    for (Numbers numbers{text.c_str()}; *numbers.at != '\0';) {
        costs.push_back(readCost(numbers, text.size()));
        if (!numbers.good || *numbers.at != '\n') return {};
        ++numbers.at;
    }
    return costs;
}

} // namespace gnomon
