// The viewer for page/tracer.js: scene and images, settings, events, frames.
#include "tracer/gl/gl.h"
#include "tracer/image_header.h"
#include "tracer/scene/read_scene.h"
#include "tracer/settings/settings.h"
#include "web/viewer_host.h"

#include <cstdint>
#include <optional>
#include <utility>

// clang-format off
EM_JS(void, reportToPage, (const char* text), { Module['report'](UTF8ToString(text)); });
// clang-format on

using namespace gnomon;

ViewerHost host;

void onContextLost() {}
void onContextRestored() { host.viewer->contextRestored(); }

extern "C" {

/// Makes the viewer with the settings in lines `key=value`; the problems are of those that were skipped.
EMSCRIPTEN_KEEPALIVE const char* createViewer(const char* lines, const char* source) {
    Settings settings;
    Problems problems;
    gl::load(nullptr, problems);
    for (const auto& [key, value] : pairsOf(lines)) setFromText(settings, key, value, source, problems);
    host.viewer = std::make_unique<Viewer>(settings, [](const std::string& line) { reportToPage(line.c_str()); });
    return give(toString(problems));
}

// --- scene and images ---

/// Takes a scene file's text. With problems the old scene stays.
EMSCRIPTEN_KEEPALIVE const char* loadScene(const char* text, const char* name) {
    Problems problems;
    std::optional<Scene> scene = readScene(text, std::string(name) + ".json", problems, givenFiles());
    if (scene) {
        scene->name = name;
        host.viewer->setScene(std::move(*scene), problems);
    }
    return give(toString(problems));
}

/// Names of the images of the scene in view, one a line.
EMSCRIPTEN_KEEPALIVE const char* imageNames() { return give(inLines(imagesOf(host.viewer->scene()))); }

/// Takes a file's bytes, or texels where there is a width.
EMSCRIPTEN_KEEPALIVE const char* giveImage(const char* name, const std::uint8_t* bytes, int size, int width) {
    Problems problems;
    if (std::optional<Image> image = imageFrom(name, {bytes, std::size_t(size)}, width, problems))
        host.viewer->setImage(name, std::move(*image));
    if (const std::string note = width > 0 ? "" : colorNote({bytes, std::size_t(size)}); !note.empty())
        problems.push_back({name, 0, {}, note, "convert it to sRGB"});
    return give(toString(problems));
}

// --- settings ---

EMSCRIPTEN_KEEPALIVE const char* settingsTableJson() { return give(settingsJson()); }

EMSCRIPTEN_KEEPALIVE const char* setSetting(const char* key, const char* text, const char* source) {
    Problems problems;
    host.viewer->set(key, text, source, problems);
    return give(toString(problems));
}

/// All settings as they stand, in lines `key=value`.
EMSCRIPTEN_KEEPALIVE const char* settingsText() {
    const Settings settings = host.viewer->settings();
    std::string lines;
    for (const SettingRow& row : settingsTable()) lines += std::string(row.key) + '=' + textOf(row, settings) + '\n';
    return give(std::move(lines));
}

EMSCRIPTEN_KEEPALIVE const char* urlQuery() { return give(toUrlQuery(host.viewer->settings())); }

// --- events ---

EMSCRIPTEN_KEEPALIVE void keyDown(const char* key) { host.viewer->keyDown(key); }
EMSCRIPTEN_KEEPALIVE void keyUp(const char* key) { host.viewer->keyUp(key); }
EMSCRIPTEN_KEEPALIVE void releaseAllKeys() { host.viewer->releaseAllKeys(); }
EMSCRIPTEN_KEEPALIVE void drag(double dx, double dy, double height) { host.viewer->drag(dx, dy, height); }
EMSCRIPTEN_KEEPALIVE void pinch(double ratio, double dx, double dy, double height) {
    host.viewer->pinch(ratio, dx, dy, height);
}

EMSCRIPTEN_KEEPALIVE void resize(int width, int height) { host.viewer->resize(width, height); }

// --- frames ---

/// One animation frame; `now` in seconds. 1: drawn; 0: nothing to draw yet.
EMSCRIPTEN_KEEPALIVE int frame(double now) { return host.viewer->frame(now, 0, host.problems); }
/// The picture shown has its full resolution.
EMSCRIPTEN_KEEPALIVE int sharp() { return host.viewer->sharp(); }
/// The resolution of the picture shown over that of the canvas.
EMSCRIPTEN_KEEPALIVE double shownScale() { return host.viewer->shownScale(); }
EMSCRIPTEN_KEEPALIVE double framesPerSecond() { return host.viewer->framesPerSecond(); }
EMSCRIPTEN_KEEPALIVE const char* title() { return give(host.viewer->title()); }
/// Problems that frames had since the last call.
EMSCRIPTEN_KEEPALIVE const char* takeProblems() { return give(toString(std::exchange(host.problems, {}))); }

} // extern "C"
