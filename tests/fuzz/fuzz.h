/// What the fuzz targets share: a promise that does not hold ends the program, so that libFuzzer keeps the input.
#pragma once

#include "tracer/printable.h"
#include "tracer/problem.h"

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace gnomon::fuzz {

inline void require(bool holds, std::string_view promise, const Problems& problems = {}) {
    if (holds) return;
    std::fprintf(stderr, "broken promise: %.*s\n%s\n", int(promise.size()), promise.data(), toString(problems).c_str());
    std::abort();
}

/// What is refused is told, in a screenful of printable text, and what is told is refused.
inline void requireTold(bool refused, const Problems& problems) {
    require(refused == !problems.empty(), "a problem where, and only where, the input is refused", problems);
    require(problems.size() <= kMostProblems + 1, "no more problems than a screen holds", problems);
    for (const Problem& problem : problems) {
        require(!problem.what.empty(), "a problem says what is wrong", problems);
        for (const unsigned char c : printable(toString(problem)))
            require(c >= 0x20 && c != 0x7F, "no control character reaches a terminal", problems);
    }
}

} // namespace gnomon::fuzz
