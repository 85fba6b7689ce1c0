// The WebGL2 context on a canvas of the page: made once, lost and given back by the browser whenever it likes.
#include "tracer/gl/generation.h"
#include "tracer/gl/gl.h"
#include "web/host.h"

#include <emscripten/html5.h>

namespace {

using namespace gnomon;

EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;

EMSCRIPTEN_WEBGL_CONTEXT_HANDLE makeContext(const char* canvas) {
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.alpha = attributes.depth = attributes.stencil = attributes.antialias = false;
    attributes.enableExtensionsByDefault = false;
    attributes.powerPreference = EM_WEBGL_POWER_PREFERENCE_HIGH_PERFORMANCE;
    return emscripten_webgl_create_context(canvas, &attributes);
}

/// WebGL forgets which extensions are on when the context is lost.
void enableExtensions() {
    for (const char* extension : {"EXT_color_buffer_float", "KHR_parallel_shader_compile"})
        emscripten_webgl_enable_extension(context, extension);
}

} // namespace

extern "C" {

/// Makes the context on the canvas that the CSS selector names. False where there is no WebGL2.
EMSCRIPTEN_KEEPALIVE int createContext(const char* canvas) {
    context = makeContext(canvas);
    if (context <= 0 || emscripten_webgl_make_context_current(context) != EMSCRIPTEN_RESULT_SUCCESS) return 0;
    enableExtensions();
    return 1;
}

EMSCRIPTEN_KEEPALIVE void contextLost() {
    gl::contextLost();
    onContextLost();
}

EMSCRIPTEN_KEEPALIVE void contextRestored() {
    enableExtensions();
    onContextRestored();
}

/// GL objects that are alive: flat from one lost context to the next.
EMSCRIPTEN_KEEPALIVE int liveGlObjects() { return gl::liveObjects(); }

EMSCRIPTEN_KEEPALIVE const char* glRenderer() { return give(gl::info().renderer); }

} // extern "C"
