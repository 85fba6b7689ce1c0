#include "tracer/shader/library.h"

#include <algorithm>

namespace gnomon {

std::string_view shaderText(std::string_view name) {
    const auto files = shaderLibrary();
    const auto found = std::ranges::lower_bound(files, name, {}, &ShaderFile::name);
    return found != files.end() && found->name == name ? found->text : std::string_view{};
}

} // namespace gnomon
