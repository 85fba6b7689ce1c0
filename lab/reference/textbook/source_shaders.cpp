#include "lab/reference/textbook/source_tracing.h"
#include "lab/reference/textbook/textbook.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace gnomon {

std::span<const ShaderFile> sourceShaders() {
    static const std::vector<ShaderFile> files = [] {
        const auto shapes = textbookShaders(), tracing = sourceTracing();
        std::vector<ShaderFile> all;
        std::merge(shapes.begin(), shapes.end(), tracing.begin(), tracing.end(), std::back_inserter(all),
                   [](const ShaderFile& a, const ShaderFile& b) { return a.name < b.name; });
        return all;
    }();
    return files;
}

} // namespace gnomon
