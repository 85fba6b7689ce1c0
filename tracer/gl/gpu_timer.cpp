#include "tracer/gl/gpu_timer.h"

#ifdef __EMSCRIPTEN__
#include <emscripten/html5.h>
#else
#include <cstring>
#endif

namespace gnomon::gl {
namespace {

#ifdef __EMSCRIPTEN__

constexpr GLenum kTimeElapsed = 0x88BF, kDisjoint = 0x8FBB; // of EXT_disjoint_timer_query_webgl2

bool hasTimers(Resolver, Function&) {
    return emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(),
                                             "EXT_disjoint_timer_query_webgl2") == EM_TRUE;
}

bool hasResult(GLuint query) {
    GLuint available = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &available);
    return available != 0;
}

/// 0 where the GPU did something else meanwhile.
double nanoseconds(GLuint query, Function) {
    GLint disjoint = 0;
    glGetIntegerv(kDisjoint, &disjoint);
    GLuint result = 0; // 32 bits hold four seconds
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &result);
    return disjoint ? 0 : double(result);
}

#else

constexpr GLenum kTimeElapsed = GL_TIME_ELAPSED;

bool hasExtension(const char* wanted) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i)
        if (std::strcmp(reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, GLuint(i))), wanted) == 0)
            return true;
    return false;
}

/// Desktop GL 3.3 has timers; GLES by an extension, under another name.
bool hasTimers(Resolver resolver, Function& getResult) {
    const bool es = info().es;
    if (es && !hasExtension("GL_EXT_disjoint_timer_query")) return false;
    GLint bits = 0;
    glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    if (bits == 0) return false;
    getResult = resolver(es ? "glGetQueryObjectui64vEXT" : "glGetQueryObjectui64v");
    return getResult != nullptr;
}

bool hasResult(GLuint) { return true; }

double nanoseconds(GLuint query, Function getResult) {
    GLuint64 result = 0;
    reinterpret_cast<PFNGLGETQUERYOBJECTUI64VPROC>(getResult)(query, GL_QUERY_RESULT, &result);
    return double(result);
}

#endif

} // namespace

GpuTimer::GpuTimer(Resolver resolver) {
    if (!hasTimers(resolver, function_)) return;
    GLuint name = 0;
    glGenQueries(1, &name);
    query_ = Query(name);
}

void GpuTimer::begin() {
    if (query_) glBeginQuery(kTimeElapsed, query_.get());
}

void GpuTimer::end() {
    if (query_) glEndQuery(kTimeElapsed);
}

bool GpuTimer::ready() { return !query_ || hasResult(query_.get()); }

std::optional<double> GpuTimer::seconds() {
    if (!query_) return std::nullopt;
    const double result = nanoseconds(query_.get(), function_);
    return result > 0 ? std::optional(1e-9 * result) : std::nullopt;
}

} // namespace gnomon::gl
