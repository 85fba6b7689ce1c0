/// The GPU's driver without any display: EGL's surfaceless platform with GLES 3.
#define EGL_NO_X11
#include <EGL/egl.h> // before GL, whose loader takes its macros away
#include <EGL/eglext.h>

#include "native/context/context.h"
#include "native/context/shared_library.h"

namespace gnomon {

namespace {

struct Egl {
    SharedLibrary library{"libEGL.so.1", "libEGL.so"};
    decltype(eglGetPlatformDisplay)* getPlatformDisplay = nullptr;
    decltype(eglInitialize)* initialize = nullptr;
    decltype(eglTerminate)* terminate = nullptr;
    decltype(eglBindAPI)* bindApi = nullptr;
    decltype(eglCreateContext)* createContext = nullptr;
    decltype(eglDestroyContext)* destroyContext = nullptr;
    decltype(eglMakeCurrent)* makeCurrent = nullptr;
    decltype(eglGetProcAddress)* getProcAddress = nullptr;
    bool complete = library.get(getPlatformDisplay, "eglGetPlatformDisplay") &&
                    library.get(initialize, "eglInitialize") && library.get(terminate, "eglTerminate") &&
                    library.get(bindApi, "eglBindAPI") && library.get(createContext, "eglCreateContext") &&
                    library.get(destroyContext, "eglDestroyContext") && library.get(makeCurrent, "eglMakeCurrent") &&
                    library.get(getProcAddress, "eglGetProcAddress");
};

const Egl& egl() {
    static const Egl library;
    return library;
}

class EglContext : public Context {
  public:
    EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
    ~EglContext() override {
        egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl().destroyContext(display_, context_);
        egl().terminate(display_);
    }
    bool makeCurrent() override {
        return egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
    }
    gl::Resolver resolver() const override { return egl().getProcAddress; }

  private:
    EGLDisplay display_;
    EGLContext context_;
};

} // namespace

std::unique_ptr<Context> makeEglContext(Problems& problems) {
    const auto refuse = [&](const std::string& what) {
        problems.push_back({"egl context", 0, {}, what, "use --context=osmesa"});
        return nullptr;
    };
    const std::string& error = egl().library.error();
    if (!egl().complete)
        return refuse(error.empty() ? "libEGL 1.5 is not installed" : "libEGL cannot be loaded: " + error);
    const EGLDisplay display = egl().getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !egl().initialize(display, nullptr, nullptr))
        return refuse("EGL has no surfaceless platform here");
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    EGLContext context = EGL_NO_CONTEXT;
    if (egl().bindApi(EGL_OPENGL_ES_API))
        context = egl().createContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context != EGL_NO_CONTEXT) return std::make_unique<EglContext>(display, context);
    egl().terminate(display);
    return refuse("EGL gives no GLES 3 context");
}

} // namespace gnomon
