#include "tracer/shader/library.h"

#include <algorithm>

namespace gnomon {

std::string_view shaderText(std::string_view name) {
    const auto files = shaderLibrary();
    const auto found =
        std::lower_bound(files.begin(), files.end(), name,
                         [](const ShaderFile& file, std::string_view wanted) { return file.name < wanted; });
    return found != files.end() && found->name == name ? found->text : std::string_view{};
}

} // namespace gnomon
