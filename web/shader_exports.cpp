// The shader program for page/tracer.js: how far it is, what it cost, its text, and files of the page's own in place of
// the library's.
#include "tracer/shader/library.h"
#include "web/host.h"

#include <deque>

namespace {

using namespace gnomon;

std::vector<ShaderFile> added; ///< since the last useShaders()

} // namespace

extern "C" {

/// How far all is: Progress (tracer/render/progress.h) as JSON.
EMSCRIPTEN_KEEPALIVE const char* progress() {
    host.viewer->poll(host.problems);
    const Progress progress = host.viewer->progress();
    std::string json = "{";
    const auto add = [&json](const char* name, double share) {
        json += (json.size() > 1 ? ",\"" : "\"") + std::string(name) + "\":" + std::to_string(share);
    };
    add("compiled", progress.compiled);
    add("images", progress.images);
    add("baked", progress.baked);
    add("samples", progress.samples);
    add("compiling", progress.compiling());
    add("ready", progress.ready());
    add("failed", progress.failed);
    return give(json + "}");
}
EMSCRIPTEN_KEEPALIVE double compileMs() { return host.viewer->renderer().stats().compileMs; }
EMSCRIPTEN_KEEPALIVE int sourceBytes() { return int(host.viewer->renderer().stats().sourceBytes); }
EMSCRIPTEN_KEEPALIVE const char* shaderSource() { return give(host.viewer->renderer().source()); }

/// A shader file of the page's own, to be used from the next useShaders() on.
EMSCRIPTEN_KEEPALIVE void addShader(const char* name, const char* text) {
    // Kept for good: the line maps of programs point into them.
    static std::deque<std::string> kept;
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
