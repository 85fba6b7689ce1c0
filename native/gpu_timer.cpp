#include "native/gpu_timer.h"

#include "native/lab_command.h"

#include <cstring>

namespace gnomon {
namespace {

bool hasExtension(const char* wanted) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i)
        if (std::strcmp(reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, GLuint(i))), wanted) == 0)
            return true;
    return false;
}

/// Desktop GL 3.3 has timers; GLES by an extension, under another name.
PFNGLGETQUERYOBJECTUI64VPROC resultFunction(const Context& context) {
    if (drawnByProcessor()) return nullptr;
    const bool es = gl::info().es;
    if (es && !hasExtension("GL_EXT_disjoint_timer_query")) return nullptr;
    GLint bits = 0;
    glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    if (bits == 0) return nullptr;
    const char* name = es ? "glGetQueryObjectui64vEXT" : "glGetQueryObjectui64v";
    return reinterpret_cast<PFNGLGETQUERYOBJECTUI64VPROC>(context.resolver()(name));
}

} // namespace

GpuTimer::GpuTimer(const Context& context) : getResult_(resultFunction(context)) {
    if (getResult_) glGenQueries(1, &query_);
}

GpuTimer::~GpuTimer() {
    if (getResult_) glDeleteQueries(1, &query_);
}

void GpuTimer::begin() {
    if (getResult_) glBeginQuery(GL_TIME_ELAPSED, query_);
}

void GpuTimer::end() {
    if (getResult_) glEndQuery(GL_TIME_ELAPSED);
}

std::optional<double> GpuTimer::seconds() {
    if (!getResult_) return std::nullopt;
    GLuint64 nanoseconds = 0;
    getResult_(query_, GL_QUERY_RESULT, &nanoseconds);
    return nanoseconds > 0 ? std::optional(1e-9 * double(nanoseconds)) : std::nullopt;
}

} // namespace gnomon
