#include "native/exit.h"

#include "tracer/printable.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

namespace gnomon {

namespace {

void tell(const char* kind, const Problems& problems) {
    std::fflush(stdout); // what was printed before stands before them
    for (const auto& problem : screenful(problems))
        std::fprintf(stderr, "gnomon: %s: %s\n", kind, printable(toString(problem)).c_str());
}

} // namespace

int fail(ExitCode code, const Problems& problems) {
    tell("error", problems);
    return code;
}

void note(const Problems& problems) { tell("note", problems); }

void holdStandardStreams() {
    // Opened the wrong way round, so that they still cannot be used.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int finish(int code) {
    errno = 0;
    std::cout.flush();
    const bool written = std::fflush(stdout) == 0 && !std::ferror(stdout) && std::cout.good();
    if (written || code != kDone) return code;
    const std::string reason = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
    return fail(kInputWrong, {{"standard output", 0, {}, "cannot be written" + reason, "check where it goes"}});
}

} // namespace gnomon
