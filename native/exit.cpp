#include "native/exit.h"

#include <cstdio>

namespace gnomon {

int fail(ExitCode code, const Problems& problems) {
    for (const auto& problem : problems) std::fprintf(stderr, "gnomon: error: %s\n", toString(problem).c_str());
    return code;
}

} // namespace gnomon
