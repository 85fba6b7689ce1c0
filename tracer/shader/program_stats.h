/// What a program cost and is.
#pragma once

#include <cstddef>

namespace gnomon {

struct ProgramStats {
    std::size_t sourceBytes = 0;
    double buildMs = 0;   ///< specialising the source
    double compileMs = 0; ///< from handing it to GL to the first finished draw
};

} // namespace gnomon
