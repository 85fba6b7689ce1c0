/// The GLSL files of shaders/, embedded in the program when it is built.
#pragma once

#include <span>
#include <string_view>

namespace gnomon {

struct ShaderFile {
    std::string_view name; ///< relative to shaders/, as `primitive/sphere.glsl`
    std::string_view text;
};

/// All files, sorted by name.
std::span<const ShaderFile> shaderLibrary();
/// The file's text, or empty where there is no such file.
std::string_view shaderText(std::string_view name);

} // namespace gnomon
