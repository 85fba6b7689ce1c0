/// Specialises the shader library: one text that holds only what the plan needs, and a map from its lines to files.
///
/// The library is GLSL with four directives that the builder resolves, so that the result has no trace of what is left
/// out:
///   #include "primitive/sphere.glsl"    each file once; $name in the path is replaced
///   #if NAME … #elif … #else … #endif   over the builder's own names; !, &&, ||, parentheses and comparisons with
///   integers #for Shape in SHAPES … #endfor      repeats the lines for every row of a list, with $Shape, $shape,
///   $SHAPE replaced
/// Other preprocessor lines are not used in the library.
#pragma once

#include "tracer/plan/plan.h"
#include "tracer/problem.h"
#include "tracer/shader/library.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

struct SourceLine {
    std::string_view file; ///< as in shaderLibrary(); `(generated)` for constants
    int line = 0;
};

struct ShaderSource {
    std::string text;
    std::vector<SourceLine> lines;         ///< where each line of `text` comes from
    std::vector<std::string_view> modules; ///< files included, in order
};

/// The fragment shader of entry point `pass`, as `pass/trace.frag`. `overrides` take the place of the library's files
/// of the same name, one that the library does not have is a problem; their names and texts must outlive the source.
ShaderSource buildShader(std::string_view pass, const Plan&, Problems&, std::span<const ShaderFile> overrides = {});
/// Shaders that this process has built: a test holds it against the plans that it has made.
int builtShaders();
/// The vertex shader that covers the canvas, or what is left of it.
ShaderSource buildCanvas(const Plan&, Problems&);

/// A driver's compile log with its line numbers (`0:12(3):`, `ERROR: 0:12:`, `0(12) :`) turned into file and line of
/// the library; lines without a number are kept as they are.
Problems mapLog(std::string_view log, const ShaderSource&);

} // namespace gnomon
