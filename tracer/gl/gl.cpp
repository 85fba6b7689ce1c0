#ifndef __EMSCRIPTEN__
#define GLAD_GL_IMPLEMENTATION // the loader's functions are compiled here
#endif
#include "tracer/gl/gl.h"

#include <algorithm>
#include <string_view>
#include <vector>

#ifdef __EMSCRIPTEN__
#include <emscripten/html5.h>
#endif

namespace gnomon::gl {
namespace {

std::string text(GLenum name) {
    const auto* bytes = reinterpret_cast<const char*>(glGetString(name));
    return bytes ? bytes : "";
}

int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

std::vector<std::string> extensions() {
    std::vector<std::string> names;
    const int count = integer(GL_NUM_EXTENSIONS);
    for (int i = 0; i < count; ++i) {
        const auto* bytes = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, GLuint(i)));
        if (bytes) names.emplace_back(bytes);
    }
    return names;
}

const char* nameOfError(GLenum error) {
    switch (error) {
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    default: return "an unknown GL error";
    }
}

#ifndef __EMSCRIPTEN__
bool oldContext(int version, Problems& problems) {
    const bool es = text(GL_VERSION).find("OpenGL ES") != std::string::npos;
    const int number = GLAD_VERSION_MAJOR(version) * 10 + GLAD_VERSION_MINOR(version);
    if (number >= (es ? 30 : 33)) return false;
    problems.push_back({{},
                        0,
                        {},
                        "this GL is " + text(GL_VERSION) + "; GL 3.3 or GLES 3.0 is needed",
                        "update the graphics driver, or use Mesa's software renderer"});
    return true;
}
#endif

} // namespace

#ifdef __EMSCRIPTEN__
bool load(Resolver, Problems&) { return true; }
#else
bool load(Resolver resolver, Problems& problems) {
    // Resolvers of some libraries answer non-null for names they do not have: the version decides, not the pointers.
    const int gl = gladLoadGL(reinterpret_cast<GLADloadfunc>(resolver));
    if (gl == 0) {
        problems.push_back({{}, 0, {}, "the GL functions cannot be loaded", "check the graphics driver"});
        return false;
    }
    const bool es = text(GL_VERSION).find("OpenGL ES") != std::string::npos;
    const int version = es ? gladLoadGLES2(reinterpret_cast<GLADloadfunc>(resolver)) : gl;
    return !oldContext(version, problems);
}
#endif

Info info() {
    Info info;
    info.version = text(GL_VERSION);
    info.renderer = text(GL_RENDERER);
    info.vendor = text(GL_VENDOR);
    info.shadingLanguage = text(GL_SHADING_LANGUAGE_VERSION);
    info.es = info.version.find("OpenGL ES") != std::string::npos;
    const std::vector<std::string> names = extensions();
    const auto has = [&](std::string_view wanted) {
        return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
            return name == wanted || (name.starts_with("GL_") && std::string_view(name).substr(3) == wanted);
        });
    };
    info.essl300 = info.es || has("ARB_ES3_compatibility");
#ifdef __EMSCRIPTEN__
    // WebGL gives an extension only to who asks for it.
    const auto enable = [](const char* name) {
        return emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(), name) == EM_TRUE;
    };
    constexpr GLenum kUnmaskedRenderer = 0x9246;
    if (info.renderer == "WebKit WebGL" && enable("WEBGL_debug_renderer_info")) info.renderer = text(kUnmaskedRenderer);
    info.floatTargets = enable("EXT_color_buffer_float");
    info.floatFilter = enable("OES_texture_float_linear");
    info.parallelCompile = enable("KHR_parallel_shader_compile");
#else
    info.floatTargets = !info.es || has("EXT_color_buffer_float");
    info.floatFilter = !info.es || has("OES_texture_float_linear");
    info.parallelCompile = has("KHR_parallel_shader_compile") || has("ARB_parallel_shader_compile");
#endif
    info.maxTextureSize = integer(GL_MAX_TEXTURE_SIZE);
    info.maxVolumeSize = integer(GL_MAX_3D_TEXTURE_SIZE);
    info.maxLayers = integer(GL_MAX_ARRAY_TEXTURE_LAYERS);
    info.maxUniformBlockSize = integer(GL_MAX_UNIFORM_BLOCK_SIZE);
    float pointSizes[2] = {1, 1};
    glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, pointSizes);
    info.maxPointSize = pointSizes[1];
    return info;
}

bool drawnByProcessor(const std::string& renderer) {
    for (const char* name : {"llvmpipe", "softpipe", "SwiftShader", "Microsoft Basic Render"})
        if (renderer.find(name) != std::string::npos) return true;
    return false;
}

bool drawnBySwiftShader(const std::string& renderer) { return renderer.find("SwiftShader") != std::string::npos; }

bool check(const char* where, Problems& problems) {
    bool clean = true;
    // A lost context may answer with errors for ever: look at a few only.
    for (int i = 0; i < 8; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) break;
        clean = false;
        problems.push_back({{}, 0, {}, std::string(nameOfError(error)) + " in " + where, {}});
    }
    return clean;
}

void finish() {
#ifdef __EMSCRIPTEN__
    unsigned char pixel[4];
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
#else
    glFinish();
#endif
}

} // namespace gnomon::gl
