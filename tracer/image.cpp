#include "tracer/image.h"

#include <climits>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS 16384
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wshadow"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace gnomon {

std::optional<Image> decodeImage(const std::string& name, std::span<const std::uint8_t> bytes, Problems& problems) {
    int width = 0, height = 0, channels = 0;
    stbi_uc* texels = nullptr;
    if (bytes.size() <= INT_MAX)
        texels = stbi_load_from_memory(bytes.data(), int(bytes.size()), &width, &height, &channels, 4);
    if (!texels) {
        const char* reason = bytes.empty() ? "the file is empty" : stbi_failure_reason();
        problems.push_back({name,
                            0,
                            {},
                            std::string("cannot be read as a picture (") + (reason ? reason : "too large") + ")",
                            "use a PNG or JPEG file of at most 16384 x 16384"});
        return std::nullopt;
    }
    Image image{width, height, {texels, texels + std::size_t(width) * height * 4}};
    stbi_image_free(texels);
    return image;
}

} // namespace gnomon
