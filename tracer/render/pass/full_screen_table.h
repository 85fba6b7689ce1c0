/// The passes over the whole picture, in the order it goes through them after it is traced: one row each. Each reads
/// the linear picture that the one before left (shaders/pass/linear_input.glsl) and leaves another
/// (linear_output.glsl); the last leaves what is shown or read back.
#pragma once

#include "tracer/settings/settings.h"

#include <array>
#include <string_view>

namespace gnomon {

struct FullScreenRow {
    std::string_view shader;
    bool (*wanted)(const Settings&); ///< the pass takes part
};

inline constexpr std::array kFullScreenTable{
    FullScreenRow{"pass/resolve.frag", [](const Settings&) { return true; }},
};

} // namespace gnomon
