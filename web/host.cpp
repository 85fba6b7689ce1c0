// The browser host: a WebGL2 context on the page's canvas and a plain C interface over Viewer for page/tracer.js.
//
// Text goes in and out as UTF-8. A `const char*` that comes out stays valid until the next call; where it tells of
// problems, empty means that there are none. The page owns events, time and loading; what they mean is decided in
// Viewer.
#include "tracer/gl/gl.h"
#include "tracer/image.h"
#include "lab/batch/numerics_self_test.h"
#include "lab/batch/ray_batch.h"
#include "tracer/settings/settings.h"
#include "tracer/render/viewer.h"
#include "tracer/scene/read_scene.h"
#include "tracer/shader/library.h"
#include "web/bench_host.h"

#include <emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// clang-format off
EM_JS(void, reportToPage, (const char* text), { Module['report'](UTF8ToString(text)); });
// clang-format on

namespace {

using namespace gnomon;

struct Host {
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;
    std::unique_ptr<Viewer> viewer;
    Problems problems;               ///< of frames, until the page takes them
    std::string answer;              ///< the text handed out last
    Image picture;                   ///< the pixels handed out last
    FloatImage output;               ///< the output handed out last
    std::vector<BatchHit> hits;      ///< of the rays traced last
    std::vector<ShaderFile> shaders; ///< of the page's own, not yet used
    int readback[4] = {};            ///< width, height, channels, address: how the page finds them
};
Host host;

const char* give(std::string text) {
    host.answer = std::move(text);
    return host.answer.c_str();
}

/// Calls `use(key, value)` for each line `key=value`.
template<class Use>
void eachLine(std::string_view lines, Use use) {
    while (!lines.empty()) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        lines.remove_prefix(std::min(line.size() + 1, lines.size()));
        const std::size_t equals = line.find('=');
        if (equals != std::string_view::npos) use(line.substr(0, equals), line.substr(equals + 1));
    }
}

/// WebGL forgets which extensions are on when the context is lost.
void enableExtensions() {
    for (const char* extension : {"EXT_color_buffer_float", "KHR_parallel_shader_compile"})
        emscripten_webgl_enable_extension(host.context, extension);
}

EMSCRIPTEN_WEBGL_CONTEXT_HANDLE makeContext(const char* canvas) {
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.alpha = attributes.depth = attributes.stencil = attributes.antialias = false;
    attributes.enableExtensionsByDefault = false;
    attributes.powerPreference = EM_WEBGL_POWER_PREFERENCE_HIGH_PERFORMANCE;
    return emscripten_webgl_create_context(canvas, &attributes);
}

const int* hand(int width, int height, int channels, const void* pixels) {
    host.readback[0] = width;
    host.readback[1] = height;
    host.readback[2] = channels;
    host.readback[3] = int(reinterpret_cast<std::uintptr_t>(pixels));
    return host.readback;
}

constexpr int kRayFloats = 8; ///< a ray: origin, side, direction, tMin; its answer: object, t, point, normal
static_assert(sizeof(BatchRay) == kRayFloats * sizeof(float));

std::vector<BatchRay> raysFrom(const float* numbers, int count) {
    std::vector<BatchRay> rays(std::size_t(count), BatchRay{});
    std::memcpy(rays.data(), numbers, rays.size() * sizeof(BatchRay));
    return rays;
}

/// Float32 pictures are an extension here, and the library's advice is the desktop's.
bool hasFloatTargets(Problems& problems) {
    if (gl::info().floatTargets) return true;
    problems.push_back({{},
                        0,
                        {},
                        "this browser's WebGL cannot draw float32 pictures (EXT_color_buffer_float is missing)",
                        "use another browser or graphics driver"});
    return false;
}

} // namespace

extern "C" {

/// Makes the context on the canvas that the CSS selector names. False where there is no WebGL2.
EMSCRIPTEN_KEEPALIVE int createContext(const char* canvas) {
    host.context = makeContext(canvas);
    if (host.context <= 0 || emscripten_webgl_make_context_current(host.context) != EMSCRIPTEN_RESULT_SUCCESS) return 0;
    enableExtensions();
    return 1;
}

/// Makes the viewer with the settings in lines `key=value`; the problems are of those that were skipped.
EMSCRIPTEN_KEEPALIVE const char* createViewer(const char* lines, const char* place) {
    Settings settings;
    Problems problems;
    gl::load(nullptr, problems);
    eachLine(lines, [&](auto key, auto value) { setFromText(settings, key, value, place, problems); });
    host.viewer = std::make_unique<Viewer>(settings, [](const std::string& line) { reportToPage(line.c_str()); });
    return give(toString(problems));
}

EMSCRIPTEN_KEEPALIVE const char* settingsTableJson() { return give(settingsJson()); }

/// Takes a scene file's text. With problems the old scene stays.
EMSCRIPTEN_KEEPALIVE const char* loadScene(const char* text, const char* name) {
    Problems problems;
    std::optional<Scene> scene = readScene(text, std::string(name) + ".json", problems);
    if (scene) {
        scene->name = name;
        host.viewer->setScene(std::move(*scene), problems);
    }
    return give(toString(problems));
}

/// Names of the images of the scene in place, one a line.
EMSCRIPTEN_KEEPALIVE const char* imageNames() {
    std::string names;
    for (const std::string& name : imagesOf(host.viewer->scene())) names += name + '\n';
    return give(std::move(names));
}

EMSCRIPTEN_KEEPALIVE const char* giveImage(const char* name, const std::uint8_t* bytes, int size) {
    Problems problems;
    if (const std::optional<Image> image = decodeImage(name, {bytes, std::size_t(size)}, problems))
        host.viewer->setImage(name, *image);
    return give(toString(problems));
}

EMSCRIPTEN_KEEPALIVE const char* setSetting(const char* key, const char* text, const char* place) {
    Problems problems;
    host.viewer->set(key, text, place, problems);
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

EMSCRIPTEN_KEEPALIVE void keyDown(const char* key) { host.viewer->keyDown(key); }
EMSCRIPTEN_KEEPALIVE void keyUp(const char* key) { host.viewer->keyUp(key); }
EMSCRIPTEN_KEEPALIVE void releaseAllKeys() { host.viewer->releaseAllKeys(); }
EMSCRIPTEN_KEEPALIVE void drag(double dx, double dy, double height) { host.viewer->drag(dx, dy, height); }
EMSCRIPTEN_KEEPALIVE void pinch(double ratio, double dx, double dy, double height) {
    host.viewer->pinch(ratio, dx, dy, height);
}

EMSCRIPTEN_KEEPALIVE void resize(int width, int height) { host.viewer->resize(width, height); }

/// One animation frame; `now` in seconds. 1: drawn; 0: nothing to draw yet.
EMSCRIPTEN_KEEPALIVE int frame(double now) { return host.viewer->frame(now, 0, host.problems); }
/// The picture shown has its full resolution.
EMSCRIPTEN_KEEPALIVE int sharp() { return host.viewer->sharp(); }
/// The resolution of the picture shown over that of the canvas.
EMSCRIPTEN_KEEPALIVE double shownScale() { return host.viewer->shownScale(); }
/// Problems that frames had since the last call.
EMSCRIPTEN_KEEPALIVE const char* takeProblems() { return give(toString(std::exchange(host.problems, {}))); }

/// How far the program has come, a ProgramState.
EMSCRIPTEN_KEEPALIVE int programState() { return int(host.viewer->renderer().poll(host.problems)); }
EMSCRIPTEN_KEEPALIVE double compileMs() { return host.viewer->renderer().stats().compileMs; }
EMSCRIPTEN_KEEPALIVE int sourceBytes() { return int(host.viewer->renderer().stats().sourceBytes); }
EMSCRIPTEN_KEEPALIVE const char* shaderSource() { return give(host.viewer->renderer().source()); }

/// A shader file of the page's own, to be used from the next useShaders() on.
EMSCRIPTEN_KEEPALIVE void addShader(const char* name, const char* text) {
    // Kept for good: the line maps of programs point into them.
    static std::deque<std::string> kept;
    const std::string& keptName = kept.emplace_back(name);
    host.shaders.push_back({keptName, kept.emplace_back(text)});
}

/// The files added since the last call take the place of the library's of the same name, and no others.
EMSCRIPTEN_KEEPALIVE const char* useShaders() {
    const std::vector<ShaderFile> files = std::exchange(host.shaders, {});
    Problems problems;
    for (const ShaderFile& file : files)
        if (shaderText(file.name).empty())
            problems.push_back({"shaders/" + std::string(file.name), 0, {}, "there is no such shader file", {}});
    if (problems.empty()) host.viewer->renderer().replaceShaders(files);
    return give(toString(problems));
}

EMSCRIPTEN_KEEPALIVE double framesPerSecond() { return host.viewer->framesPerSecond(); }
EMSCRIPTEN_KEEPALIVE const char* title() { return give(host.viewer->title()); }
EMSCRIPTEN_KEEPALIVE const char* glRenderer() { return give(gl::info().renderer); }

/// Draws the view as it stands, without a step in time, and waits for the last pixel of it.
EMSCRIPTEN_KEEPALIVE void drawAndWait() {
    host.viewer->renderer().draw(host.viewer->view(), host.viewer->settings().scale, 0);
    std::uint8_t pixel[4];
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
}

/// Draws the view as it stands and reads the canvas back: width, height, 4, address of bytes, row 0 = top.
EMSCRIPTEN_KEEPALIVE const int* readPicture() {
    const View view = host.viewer->view();
    Image& picture = host.picture;
    picture = {view.width, view.height, std::vector<std::uint8_t>(std::size_t(view.width) * view.height * 4)};
    host.viewer->renderer().draw(view, host.viewer->settings().scale, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, view.width, view.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    const std::size_t row = std::size_t(view.width) * 4; // GL gives the bottom row first
    for (int y = 0; y < view.height / 2; ++y)
        std::swap_ranges(picture.rgba.begin() + y * row, picture.rgba.begin() + (y + 1) * row,
                         picture.rgba.end() - (y + 1) * row);
    return hand(view.width, view.height, 4, picture.rgba.data());
}

/// Reads the output the settings name: width, height, channels, address of floats, row 0 = top. Needs a ready program.
EMSCRIPTEN_KEEPALIVE const int* readOutput() {
    host.output = host.viewer->renderer().readOutput(host.viewer->view(), host.problems);
    return hand(host.output.width, host.output.height, host.output.channels, host.output.pixels.data());
}

/// How exact this GL's numbers are, measured now: JSON, see toJson(NumericsSelfTest).
EMSCRIPTEN_KEEPALIVE const char* measureNumerics() {
    Problems problems;
    NumericsSelfTest selfTest;
    if (hasFloatTargets(problems))
        selfTest = runNumericsSelfTest();
    else
        selfTest.problem = toString(problems);
    return give(toJson(selfTest));
}

/// Traces `count` rays of kRayFloats numbers each through the scene of the text, beside the viewer's own.
EMSCRIPTEN_KEEPALIVE const char* traceRays(const char* text, const float* numbers, int count) {
    Problems problems;
    host.hits.clear();
    const std::optional<Scene> scene = readScene(text, "traceRays", problems);
    if (scene && hasFloatTargets(problems)) {
        RayBatch batch(*scene, problems);
        if (batch.valid()) host.hits = batch.trace(raysFrom(numbers, count));
        gl::check("tracing rays", problems);
    }
    return give(toString(problems));
}

/// The answers to the rays traced last: kRayFloats, count, 1, address of floats.
EMSCRIPTEN_KEEPALIVE const int* tracedRays() {
    FloatImage& answers = host.output;
    answers = {kRayFloats, int(host.hits.size()), 1, {}};
    for (const BatchHit& hit : host.hits)
        for (const float number : {float(hit.object), hit.t, hit.point.x, hit.point.y, hit.point.z, hit.normal.x,
                                   hit.normal.y, hit.normal.z})
            answers.pixels.push_back(number);
    return hand(answers.width, answers.height, answers.channels, answers.pixels.data());
}

EMSCRIPTEN_KEEPALIVE void contextLost() {
    host.viewer->contextLost();
    benchLost();
}
EMSCRIPTEN_KEEPALIVE void contextRestored() {
    enableExtensions();
    host.viewer->contextRestored();
    benchRestored();
}

} // extern "C"
