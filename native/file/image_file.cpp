#include "native/file/image_file.h"

#include "native/file/output_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>

#include <tinyexr.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace gnomon {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "PFM and EXR rows are copied as they lie in memory");

constexpr std::array<std::string_view, 3> kEndings{".png", ".pfm", ".exr"}; ///< in the order of ImageFormat

/// In small letters: `.PNG` is what some systems call it.
std::string extensionOf(const std::string& file) {
    std::string ending = fs::path(file).extension().string();
    for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

void append(void* bytes, void* data, int size) {
    static_cast<std::string*>(bytes)->append(static_cast<const char*>(data), std::size_t(size));
}

std::string encodePfm(const FloatImage& image) {
    std::string bytes = image.channels == 3 ? "PF\n" : "Pf\n";
    bytes += std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
    const std::size_t row = std::size_t(image.width) * image.channels * sizeof(float);
    for (int y = image.height - 1; y >= 0; --y) bytes.append(reinterpret_cast<const char*>(image.at(0, y)), row);
    return bytes;
}

std::string encodeExr(const FloatImage& image) {
    const std::size_t pixels = std::size_t(image.width) * image.height;
    const int count = image.channels;
    std::vector<std::vector<float>> planes(count, std::vector<float>(pixels));
    std::vector<unsigned char*> planePointers(count);
    std::vector<EXRChannelInfo> channels(count);
    std::vector<int> types(count, TINYEXR_PIXELTYPE_FLOAT);
    for (int i = 0; i < count; ++i) {
        const int source = count - 1 - i; // the format keeps channels in alphabetical order: B, G, R
        for (std::size_t p = 0; p < pixels; ++p) planes[i][p] = image.pixels[p * count + source];
        planePointers[i] = reinterpret_cast<unsigned char*>(planes[i].data());
        std::strcpy(channels[i].name, count == 3 ? std::array{"R", "G", "B"}[source] : "Y");
    }
    EXRImage exr;
    InitEXRImage(&exr);
    exr.images = planePointers.data();
    exr.num_channels = count;
    exr.width = image.width;
    exr.height = image.height;
    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = count;
    header.channels = channels.data();
    header.pixel_types = header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
    unsigned char* memory = nullptr;
    const char* error = nullptr;
    const std::size_t size = SaveEXRImageToMemory(&exr, &header, &memory, &error);
    if (error) FreeEXRErrorMessage(error);
    std::unique_ptr<unsigned char, decltype(&std::free)> owner(memory, std::free);
    return {reinterpret_cast<const char*>(memory), size};
}

bool writeEncoded(const std::string& file, const std::string& bytes, Problems& problems) {
    if (!bytes.empty()) return writeOutput(file, bytes, problems);
    problems.push_back({file, 0, {}, "the picture cannot be encoded", "try another format or a smaller size"});
    return false;
}

} // namespace

std::string toPng(const Image& image) {
    std::vector<std::uint8_t> rgb;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) rgb.insert(rgb.end(), &image.rgba[i], &image.rgba[i] + 3);
    std::string bytes;
    const bool done = stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, rgb.data(), image.width * 3);
    return done ? bytes : std::string();
}

std::optional<ImageFormat> checkImageFile(const std::string& file, std::string_view named, Aov aov,
                                          Problems& problems) {
    std::string ending = named.empty() ? extensionOf(file) : "." + std::string(named);
    if (named.empty() && isStream(file)) ending = ".png";
    const auto found = std::find(kEndings.begin(), kEndings.end(), ending);
    if (found == kEndings.end()) {
        if (named.empty())
            problems.push_back(
                {file, 0, {}, "the picture's format is unknown", "end the name with .png, .pfm or .exr"});
        else
            problems.push_back(
                {"command line", 0, "format", inQuotes(named) + " is none of png|pfm|exr", "use one of them"});
        return std::nullopt;
    }
    const auto format = ImageFormat(found - kEndings.begin());
    const bool shown = aov == Aov::Color || aov == Aov::Normal || aov == Aov::Visibility;
    if (format == ImageFormat::Png && !shown) {
        Settings settings;
        settings.aov = aov;
        problems.push_back(
            {file,
             0,
             {},
             "a PNG cannot hold " + textOf(*findSetting("aov"), settings) + ", whose values leave [0, 1]",
             "use .pfm or .exr"});
        return std::nullopt;
    }
    return prepareOutput(file, problems) ? std::optional(format) : std::nullopt;
}

bool writeImage(const std::string& file, ImageFormat format, const FloatImage& image, Problems& problems) {
    return writeEncoded(file, format == ImageFormat::Pfm ? encodePfm(image) : encodeExr(image), problems);
}

bool writeImage(const std::string& file, const Image& image, Problems& problems) {
    return writeEncoded(file, toPng(image), problems);
}

} // namespace gnomon
