#include "native/context/context.h"

#include "native/crash.h"

namespace gnomon {

std::string_view nameOf(ContextKind kind) { return contextNames()[std::size_t(kind)]; }

const std::vector<std::string_view>& contextNames() {
    static const std::vector<std::string_view> names{"osmesa", "egl", "window"};
    return names;
}

std::optional<ContextKind> contextNamed(std::string_view name) {
    for (auto kind : {ContextKind::OsMesa, ContextKind::Egl, ContextKind::Window})
        if (nameOf(kind) == name) return kind;
    return std::nullopt;
}

namespace {

std::unique_ptr<Context> makeBare(ContextKind kind, Problems& problems) {
    switch (kind) {
    case ContextKind::OsMesa: return makeOsMesaContext(problems);
    case ContextKind::Egl: return makeEglContext(problems);
    case ContextKind::Window: break;
    }
    return makeWindowContext(problems);
}

} // namespace

std::unique_ptr<Context> makeContext(ContextKind kind, Problems& problems) {
    blameGl(nameOf(kind));
    auto context = makeBare(kind, problems);
    if (!context) return nullptr;
    if (!context->makeCurrent()) {
        problems.push_back({std::string(nameOf(kind)) + " context", 0, {}, "cannot be made current", {}});
        return nullptr;
    }
    return gl::load(context->resolver(), problems) ? std::move(context) : nullptr;
}

} // namespace gnomon
