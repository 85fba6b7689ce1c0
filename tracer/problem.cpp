#include "tracer/problem.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <utility>

namespace gnomon {

namespace {

constexpr std::size_t kLongestQuote = 48;
constexpr std::size_t kLongestWord = 64; ///< longer words are not misspellings of anything we know

char lower(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

/// Optimal string alignment: insert, delete, replace, swap neighbours, each at cost 1.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t(0));
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
        beforeLast.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

/// How many slips still leave a word of this length recognisable: a third of its letters, and never all of them.
std::size_t allowedSlips(std::size_t length) {
    return length < 2 ? 0 : std::min(std::max<std::size_t>(1, length / 3), length - 1);
}

Problem more(std::string file, std::size_t count) {
    return {std::move(file), 0, {}, "and " + std::to_string(count) + " more problem" + (count == 1 ? "" : "s"), {}};
}

} // namespace

Problems screenful(Problems problems) {
    if (problems.size() <= kMostProblems) return problems;
    const std::size_t rest = problems.size() - (kMostProblems - 1);
    problems.resize(kMostProblems - 1);
    problems.push_back(more({}, rest));
    return problems;
}

ProblemCounter::ProblemCounter(std::string file, Problems& kept) : file_(std::move(file)), kept_(kept) {}

ProblemCounter::~ProblemCounter() {
    if (count_ >= kMostProblems) kept_.push_back(more(file_, count_ - (kMostProblems - 1)));
}

void ProblemCounter::add(int line, std::string path, std::string what, std::string remedy) {
    if (keeps()) kept_.push_back({file_, line, std::move(path), std::move(what), std::move(remedy)});
    countOne();
}

std::string toString(const Problem& problem) {
    std::string text = problem.file;
    if (problem.line > 0) text += (text.empty() ? "line " : ":") + std::to_string(problem.line);
    if (!text.empty()) text += ": ";
    if (!problem.path.empty()) text += problem.path + ": ";
    text += problem.what;
    if (!problem.remedy.empty()) text += "; " + problem.remedy;
    return text;
}

std::string toString(const Problems& problems) {
    std::string text;
    for (const Problem& problem : screenful(problems)) text += toString(problem) + "\n";
    return text;
}

std::string toString(double value) {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.10g", value);
    return digits;
}

std::string inQuotes(std::string_view text) {
    std::string result = "\"";
    for (char c : text.substr(0, kLongestQuote)) result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    if (text.size() > kLongestQuote) {
        // Cut before a UTF-8 sequence, not inside one.
        std::size_t end = kLongestQuote;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
        result.resize(end + 1);
        result += "...";
    }
    return result + "\"";
}

std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates) {
    std::string_view best;
    std::size_t bestDistance = kLongestWord;
    if (word.size() > kLongestWord) return best;
    for (std::string_view candidate : candidates) {
        const std::size_t shorter = std::min(word.size(), candidate.size());
        const std::size_t longer = std::max(word.size(), candidate.size());
        const std::size_t allowed = allowedSlips(longer);
        // The distance is at least the difference in length.
        if (longer > kLongestWord || longer - shorter > allowed) continue;
        const std::size_t distance = editDistance(word, candidate);
        if (distance > allowed || distance >= bestDistance) continue;
        best = candidate;
        bestDistance = distance;
    }
    return best;
}

} // namespace gnomon
