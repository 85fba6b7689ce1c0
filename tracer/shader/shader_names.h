/// What the directives of the shader library can ask about: values for `#if`, lists for `#for`.
#pragma once

#include "tracer/plan/plan.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

struct Names {
    std::map<std::string, int, std::less<>> values;
    std::map<std::string, std::vector<std::string>, std::less<>> lists;
};

Names namesOf(const Plan&);

/// `LargeSphere` as `large_sphere` (std::tolower) or `LARGE_SPHERE` (std::toupper).
std::string mapped(std::string_view text, int (*change)(int));

} // namespace gnomon
