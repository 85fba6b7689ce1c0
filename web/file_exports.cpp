// Files that a scene names and images that the browser decodes, before the scene is taken.
#include "tracer/image_header.h"
#include "web/host.h"

#include <cstdint>
#include <map>

namespace {

using namespace gnomon;

std::map<std::string, std::string> files; ///< by path; kept, each the latest of its path

} // namespace

SceneFiles givenFiles() {
    return [](const std::string& path, Problems&) {
        const auto file = files.find(path);
        return file == files.end() ? std::nullopt : std::optional(file->second);
    };
}

extern "C" {

/// Paths of the files that a scene's text names, one a line: what giveFile() is to give before the scene is taken.
EMSCRIPTEN_KEEPALIVE const char* sceneFiles(const char* text) { return give(inLines(filesOf(text))); }

EMSCRIPTEN_KEEPALIVE void giveFile(const char* path, const char* bytes, int size) {
    files[path].assign(bytes, std::size_t(size));
}

/// Problems of a file that the browser is to decode.
EMSCRIPTEN_KEEPALIVE const char* measureImageFile(const char* name, const std::uint8_t* bytes, int size) {
    Problems problems;
    measureImage(name, {bytes, std::size_t(size)}, problems);
    return give(toString(problems));
}

} // extern "C"
