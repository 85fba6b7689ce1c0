/// The one place that includes GL: the GLES 3.0 subset of it, which desktop GL 3.3 and WebGL2 share.
#pragma once

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
#else
#include <glad/gl.h>
#endif

#include "tracer/problem.h"

#include <string>

namespace gnomon::gl {

using Function = void (*)();
/// Gives the address of a GL function by name: GLFW's, SDL's, EGL's or OSMesa's.
using Resolver = Function (*)(const char* name);

/// Loads the functions of the current context. False, with a problem, where it is older than GL 3.3 or GLES 3.0.
/// In a browser there is nothing to load.
bool load(Resolver, Problems&);

struct Info {
    std::string version, renderer, vendor, shadingLanguage;
    bool es = false;              ///< GLES or WebGL: else desktop core
    bool essl300 = false;         ///< accepts `#version 300 es`
    bool floatTargets = false;    ///< can draw to RGBA32F
    bool floatFilter = false;     ///< can filter textures of float32
    bool parallelCompile = false; ///< compiling can be polled
    int maxTextureSize = 0, maxVolumeSize = 0, maxLayers = 0, maxUniformBlockSize = 0;
    float maxPointSize = 1;
};
/// Of the current context.
Info info();

/// A driver of that name draws with the processor.
bool drawnByProcessor(const std::string& renderer);
bool drawnBySwiftShader(const std::string& renderer);

/// Says of a GL error since the last call what it was and `where`; adds no problem where there is none.
bool check(const char* where, Problems&);

/// Waits for the last pixel of what was asked for. A framebuffer has to be bound that can be read as RGBA8: a browser
/// waits for nothing else.
void finish();

} // namespace gnomon::gl
