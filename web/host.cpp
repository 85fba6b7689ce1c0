#include "web/host.h"

#include <algorithm>
#include <cstdint>

const char* give(std::string text) {
    static std::string answer;
    answer = std::move(text);
    return answer.c_str();
}

const int* hand(int width, int height, int channels, const void* values) {
    static int readback[4];
    readback[0] = width;
    readback[1] = height;
    readback[2] = channels;
    readback[3] = int(reinterpret_cast<std::uintptr_t>(values));
    return readback;
}

std::optional<gnomon::Image> imageFrom(const std::string& name, std::span<const std::uint8_t> bytes, int width,
                                       gnomon::Problems& problems) {
    if (width <= 0) return gnomon::decodeImage(name, bytes, problems);
    return gnomon::Image{width, int(bytes.size() / 4 / std::size_t(width)), {bytes.begin(), bytes.end()}};
}

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        lines.emplace_back(line);
        text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
    return lines;
}

std::string inLines(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    return text;
}

std::vector<std::pair<std::string, std::string>> pairsOf(std::string_view text) {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const std::string& line : linesOf(text)) {
        const std::size_t equals = line.find('=');
        if (equals != std::string::npos) pairs.emplace_back(line.substr(0, equals), line.substr(equals + 1));
    }
    return pairs;
}
