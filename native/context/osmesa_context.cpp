/// GL in memory, by Mesa's processor renderer: the same on every machine, so that tests and `gnomon render` need no
/// display.
#include "native/context/context.h"
#include "native/context/shared_library.h"

#include <GL/osmesa.h>

#include <cstdint>

namespace gnomon {

namespace {

struct OsMesa {
    SharedLibrary library{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    decltype(OSMesaCreateContextAttribs)* createContextAttribs = nullptr;
    decltype(OSMesaDestroyContext)* destroyContext = nullptr;
    decltype(OSMesaMakeCurrent)* makeCurrent = nullptr;
    decltype(OSMesaGetProcAddress)* getProcAddress = nullptr;
    bool complete = library.get(createContextAttribs, "OSMesaCreateContextAttribs") &&
                    library.get(destroyContext, "OSMesaDestroyContext") &&
                    library.get(makeCurrent, "OSMesaMakeCurrent") &&
                    library.get(getProcAddress, "OSMesaGetProcAddress");
};

const OsMesa& osMesa() {
    static const OsMesa mesa;
    return mesa;
}

constexpr int kSide = 4; ///< of its own framebuffer, which nobody draws to

class OsMesaContext : public Context {
  public:
    explicit OsMesaContext(OSMesaContext context) : context_(context) {}
    ~OsMesaContext() override { osMesa().destroyContext(context_); }
    bool makeCurrent() override {
        return osMesa().makeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, kSide, kSide) == GL_TRUE;
    }
    gl::Resolver resolver() const override { return osMesa().getProcAddress; }

  private:
    OSMesaContext context_;
    std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(kSide * kSide * 4);
};

} // namespace

std::unique_ptr<Context> makeOsMesaContext(Problems& problems) {
    if (!osMesa().complete) {
        const std::string& error = osMesa().library.error();
        problems.push_back({"osmesa context",
                            0,
                            {},
                            error.empty() ? "libOSMesa is not installed" : "libOSMesa cannot be loaded: " + error,
                            error.empty() ? "install libosmesa6, or use --context=egl or --context=window"
                                          : "use --context=egl or --context=window"});
        return nullptr;
    }
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    if (OSMesaContext context = osMesa().createContextAttribs(attributes, nullptr))
        return std::make_unique<OsMesaContext>(context);
    problems.push_back({"osmesa context",
                        0,
                        {},
                        "libOSMesa gives no GL 3.3 core context",
                        "use --context=egl or --context=window, or a newer Mesa"});
    return nullptr;
}

} // namespace gnomon
