#include "tracer/printable.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace gnomon {

namespace {

struct Span {
    std::uint32_t first, last;
};

constexpr std::array kSteering{
    Span{0x00, 0x1f},     Span{0x7f, 0x9f},     Span{0x61c, 0x61c},   Span{0x200e, 0x200f},
    Span{0x2028, 0x202e}, Span{0x2060, 0x206f}, Span{0xfeff, 0xfeff}, Span{0xfff9, 0xfffb},
};

bool steers(std::uint32_t character) {
    return std::any_of(kSteering.begin(), kSteering.end(),
                       [&](const Span& span) { return character >= span.first && character <= span.last; });
}

/// One character in UTF-8; of length 0 where there is none.
struct Character {
    std::uint32_t value = 0;
    std::size_t length = 0;
};

Character characterAt(std::string_view text) {
    const auto byte = [&](std::size_t i) { return std::uint32_t(static_cast<unsigned char>(text[i])); };
    if (byte(0) < 0x80) return {byte(0), 1};
    const std::size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
    if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < length) return {};
    std::uint32_t value = byte(0) & (0x7fU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {};
        value = value << 6 | (byte(i) & 0x3f);
    }
    constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = value >= 0xd800 && value <= 0xdfff;
    return value < kLeast[length] || value > 0x10ffff || surrogate ? Character{} : Character{value, length};
}

} // namespace

std::string printable(std::string_view text, bool lines) {
    std::string shown;
    char escape[16];
    while (!text.empty()) {
        const auto [value, length] = characterAt(text);
        if (length == 0) {
            std::snprintf(escape, sizeof escape, "\\x%02x", unsigned(static_cast<unsigned char>(text[0])));
            shown += escape;
        } else if (steers(value) && !(lines && value == '\n')) {
            std::snprintf(escape, sizeof escape, "\\u%04x", unsigned(value));
            shown += escape;
        } else {
            shown += text.substr(0, length);
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return shown;
}

} // namespace gnomon
