#include "lab/results/result_pictures.h"

#include "native/file/image_file.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace gnomon {
namespace {

constexpr glm::dvec2 kMost(320, 240);
constexpr double kBytes = 750e3;    ///< of all PNGs; base64 makes four of three
constexpr double kPixelBytes = 1.5; ///< of a PNG: textured scenes take more, plain ones less

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < count ? std::uint8_t(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

double encoded(double color, bool linear) {
    const double c = std::clamp(color, 0.0, 1.0);
    if (!linear) return c;
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

} // namespace

glm::ivec2 pictureSize(glm::ivec2 frame, std::size_t count) {
    const glm::dvec2 size(frame);
    const double pixels = kBytes / kPixelBytes / double(std::max<std::size_t>(count, 1));
    const double scale = std::min({1.0, kMost.x / size.x, kMost.y / size.y, std::sqrt(pixels / (size.x * size.y))});
    return glm::max(glm::ivec2(size * scale), glm::ivec2(1));
}

Image shown(const FloatImage& colors, glm::ivec2 size, bool linear) {
    Image image{size.x, size.y, std::vector<std::uint8_t>(std::size_t(size.x) * std::size_t(size.y) * 4, 255)};
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const float* color = colors.at(x * colors.width / size.x, y * colors.height / size.y);
            std::uint8_t* to = &image.rgba[(std::size_t(y) * std::size_t(size.x) + std::size_t(x)) * 4];
            for (int c = 0; c < 3; ++c)
                to[c] = std::uint8_t(std::lround(255 * encoded(color[std::min(c, colors.channels - 1)], linear)));
        }
    return image;
}

std::size_t addImage(const Image& image, Results& results) {
    std::string url = "data:image/png;base64," + base64(toPng(image));
    const auto found = std::find(results.images.begin(), results.images.end(), url);
    const std::size_t index = std::size_t(found - results.images.begin());
    if (found == results.images.end()) results.images.push_back(std::move(url));
    return index;
}

void addPicture(Picture picture, const Image& image, const Image& reference, Results& results) {
    if (image.empty()) return;
    picture.image = addImage(image, results);
    if (reference.width == image.width && reference.height == image.height)
        picture.reference = addImage(reference, results);
    results.pictures.push_back(std::move(picture));
}

} // namespace gnomon
