/// How the program begins and ends: its standard streams, exit codes, and problems told on stderr.
#pragma once

#include "tracer/problem.h"

namespace gnomon {

enum ExitCode { kDone = 0, kInputWrong = 1, kCommandLineWrong = 2, kNoGl = 3, kInterrupted = 130 };

/// A screenful of problems as `gnomon: error: …` on stderr; `code`.
int fail(ExitCode code, const Problems&);

/// What hinders nothing, as `gnomon: note: …` on stderr.
void note(const Problems&);

/// Streams that the program was started without are held: no file that is opened later takes their place and gets what
/// is printed.
void holdStandardStreams();

/// `code`, or a failure where what was printed could not be written.
int finish(int code);

} // namespace gnomon
