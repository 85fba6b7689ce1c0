/// GL contexts for drawing without a visible window. What is drawn goes into framebuffer objects; the context's own
/// framebuffer is a token of a few pixels, or missing.
#pragma once

#include "tracer/gl/generation.h"
#include "tracer/gl/gl.h"
#include "tracer/problem.h"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace gnomon {

enum class ContextKind {
    OsMesa, ///< drawn in memory by the processor; needs neither display nor GPU
    Egl,    ///< the GPU's driver without a display (EGL surfaceless), GLES 3
    Window, ///< the display's driver through a hidden window (GLFW)
};

/// As on the command line: osmesa, egl, window.
std::string_view nameOf(ContextKind);
std::optional<ContextKind> contextNamed(std::string_view);
const std::vector<std::string_view>& contextNames();

class Context {
  public:
    virtual ~Context() { gl::contextLost(); } ///< what was made in it is gone
    virtual bool makeCurrent() = 0;
    virtual gl::Resolver resolver() const = 0;
};

/// A context that is current and whose GL functions are loaded. Null, with a problem that says what to try instead,
/// where this machine has none of that kind or one older than GL 3.3 / GLES 3.0.
std::unique_ptr<Context> makeContext(ContextKind, Problems&);

/// The kinds behind makeContext(); the GL functions are not loaded yet.
std::unique_ptr<Context> makeOsMesaContext(Problems&);
std::unique_ptr<Context> makeEglContext(Problems&);
std::unique_ptr<Context> makeWindowContext(Problems&);

} // namespace gnomon
