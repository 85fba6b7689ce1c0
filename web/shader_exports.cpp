// The shader program for page/tracer.js: how far it is, what it cost, its text, and files of the page's own in place of
// the library's.
#include "tracer/shader/library.h"
#include "web/viewer_host.h"

#include <algorithm>
#include <iterator>
#include <list>

namespace {

using namespace gnomon;

std::vector<ShaderFile> added; ///< since the last useShaders()

} // namespace

extern "C" {

/// How far all is, as Progress (tracer/render/progress.h) tells: four shares, then whether it compiles, is ready,
/// failed.
EMSCRIPTEN_KEEPALIVE const double* progress() {
    static double values[7];
    host.viewer->poll(host.problems);
    const Progress is = host.viewer->progress();
    const double now[] = {is.compiled,        is.images,        is.baked, is.samples, double(is.compiling()),
                          double(is.ready()), double(is.failed)};
    std::copy(std::begin(now), std::end(now), values);
    return values;
}
EMSCRIPTEN_KEEPALIVE double compileMs() { return host.viewer->renderer().stats().compileMs; }
EMSCRIPTEN_KEEPALIVE int sourceBytes() { return int(host.viewer->renderer().stats().sourceBytes); }
EMSCRIPTEN_KEEPALIVE const char* shaderSource() { return give(host.viewer->renderer().source()); }

/// A shader file of the page's own, to be used from the next useShaders() on.
EMSCRIPTEN_KEEPALIVE void addShader(const char* name, const char* text) {
    // Kept for good: the line maps of programs point into them.
    static std::list<std::string> kept;
    const std::string& keptName = kept.emplace_back(name);
    added.push_back({keptName, kept.emplace_back(text)});
}

/// The files added since the last call take the place of the library's of the same name, and no others.
EMSCRIPTEN_KEEPALIVE const char* useShaders() {
    const std::vector<ShaderFile> files = std::exchange(added, {});
    Problems problems;
    for (const ShaderFile& file : files)
        if (shaderText(file.name).empty())
            problems.push_back({"shaders/" + std::string(file.name), 0, {}, "there is no such shader file", {}});
    if (problems.empty()) host.viewer->renderer().replaceShaders(files);
    return give(toString(problems));
}

} // extern "C"
