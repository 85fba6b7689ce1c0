/// How the program ends: exit codes, and problems told on stderr.
#pragma once

#include "tracer/problem.h"

namespace gnomon {

enum ExitCode { kDone = 0, kInputWrong = 1, kCommandLineWrong = 2, kNoGl = 3, kInterrupted = 130 };

/// Every problem as `gnomon: error: …` on stderr, then `code`.
int fail(ExitCode code, const Problems&);

} // namespace gnomon
