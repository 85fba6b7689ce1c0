#include "native/file/image_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include <tinyexr.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include <unistd.h>

namespace gnomon {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "PFM and EXR rows are copied as they lie in memory");

std::string extensionOf(const std::string& file) { return fs::path(file).extension().string(); }

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

/// Through a temporary file beside it and a rename.
bool writeWhole(const std::string& file, const std::string& bytes, Problems& problems) {
    const fs::path draft = file + "." + std::to_string(getpid()) + ".part";
    bool written = false;
    if (!bytes.empty()) {
        std::ofstream out(draft, std::ios::binary);
        out.write(bytes.data(), std::streamsize(bytes.size()));
        out.close();
        written = !out.fail();
    }
    std::error_code error;
    if (written) fs::rename(draft, file, error);
    if (written && !error) return true;
    fs::remove(draft, error);
    problems.push_back({file, 0, {}, "cannot be written", "check the folder, its permissions and the free space"});
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

bool isPicture(const std::string& file) { return extensionOf(file) == ".png"; }

bool checkImageFile(const std::string& file, Aov aov, Problems& problems) {
    const std::string extension = extensionOf(file);
    const auto refuse = [&](const std::string& what, const char* remedy) {
        problems.push_back({file, 0, {}, what, remedy});
        return false;
    };
    if (extension != ".png" && extension != ".pfm" && extension != ".exr")
        return refuse("the picture's format is unknown", "end the name with .png, .pfm or .exr");
    const bool shown = aov == Aov::Color || aov == Aov::Normal || aov == Aov::Visibility;
    if (isPicture(file) && !shown) {
        Settings settings;
        settings.aov = aov;
        return refuse("a PNG cannot hold " + textOf(*findSetting("aov"), settings) + ", whose numbers leave [0, 1]",
                      "use .pfm or .exr");
    }
    const fs::path folder = fs::path(file).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !fs::is_directory(folder, ignored))
        return refuse("there is no folder " + folder.string(), "make it first");
    if (fs::is_directory(file, ignored)) return refuse("is a folder", "name a file");
    return true;
}

bool writeImage(const std::string& file, const FloatImage& image, Problems& problems) {
    return writeWhole(file, extensionOf(file) == ".pfm" ? encodePfm(image) : encodeExr(image), problems);
}

bool writeImage(const std::string& file, const Image& image, Problems& problems) {
    return writeWhole(file, toPng(image), problems);
}

} // namespace gnomon
