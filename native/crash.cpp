#include "native/crash.h"

#include "native/exit.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>

#include <unistd.h>

namespace gnomon {

namespace {

std::array<char, 32> blamed{}; ///< the context; empty before there is one
std::array<char, 1 << 16> signalStack;

/// Without memory, locks and streams: none of them may be whole.
void tell(std::initializer_list<const char*> words) {
    for (const char* word : words)
        if (write(STDERR_FILENO, word, std::strlen(word)) < 0) return;
}

const char* nameOf(int signal) {
    switch (signal) {
    case SIGSEGV: return "SIGSEGV";
    case SIGABRT: return "SIGABRT";
    case SIGBUS: return "SIGBUS";
    case SIGFPE: return "SIGFPE";
    default: return "SIGILL";
    }
}

extern "C" void crash(int signal) {
    tell({"gnomon: error: ", blamed.data(), " context: the program crashed while GL was in use (", nameOf(signal),
          "); check GALLIUM_DRIVER and what else is set for the driver, free memory, or use another --context\n"});
    _exit(kNoGl);
}

[[noreturn]] void terminate() {
    const bool gl = blamed[0] != 0;
    try {
        if (const auto thrown = std::current_exception()) std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
        tell({"gnomon: error: ", gl ? blamed.data() : "", gl ? " context: " : "",
              "memory ran out; free some, or use a smaller scene or picture\n"});
        _exit(gl ? kNoGl : kInputWrong);
    } catch (const std::exception& error) {
        tell({"gnomon: internal error: ", error.what(), "\n"});
    } catch (...) {
    }
    std::abort();
}

/// Before the tables that are made before main(), which take memory, too.
[[gnu::constructor(101)]] void tellCrashes() { std::set_terminate(terminate); }

} // namespace

void blameGl(std::string_view context) {
    blamed = {};
    std::copy_n(context.begin(), std::min(context.size(), blamed.size() - 1), blamed.begin());
    stack_t stack{};
    stack.ss_sp = signalStack.data();
    stack.ss_size = signalStack.size();
    sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = crash;
    action.sa_flags = SA_ONSTACK | int(SA_RESETHAND);
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) sigaction(signal, &action, nullptr);
}

} // namespace gnomon
