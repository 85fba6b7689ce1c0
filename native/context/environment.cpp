#include "native/context/environment.h"

#include "tracer/gl/gl.h"
#include "tracer/version.h"

#include <ctime>
#include <fstream>
#include <string>
#include <sys/utsname.h>
#include <thread>

namespace gnomon {
namespace {

std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string system() {
    utsname name{};
    return uname(&name) == 0 ? std::string(name.sysname) + " " + name.release + " " + name.machine : "unknown";
}

std::string now() {
    const std::time_t time = std::time(nullptr);
    char text[40];
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", std::gmtime(&time));
    return text;
}

} // namespace

Environment environmentOf(ContextKind kind) {
    const gl::Info info = gl::info();
    return {{"date", now()},
            {"gnomon", version()},
            {"commit", commit()},
            {"context", std::string(nameOf(kind))},
            {"renderer", info.renderer},
            {"gl", info.version},
            {"processor", processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " threads"},
            {"system", system()}};
}

} // namespace gnomon
