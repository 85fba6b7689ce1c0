/// Any bytes as settings, one `key=value` a line, or `#` and a byte that chooses the key: what is set has a text that
/// sets the same, what is refused changes nothing.
#include "tracer/settings/settings.h"
#include "tests/fuzz/fuzz.h"

#include <algorithm>
#include <cstdint>
#include <string>

using namespace gnomon;

namespace {

void set(Settings& settings, std::string_view line) {
    const std::size_t equals = std::min(line.find('='), line.size());
    std::string_view key = line.substr(0, equals);
    if (key.size() == 2 && key[0] == '#') key = settingsTable()[std::uint8_t(key[1]) % settingsTable().size()].key;
    const std::string_view value = equals < line.size() ? line.substr(equals + 1) : std::string_view();
    const Settings before = settings;
    Problems problems;
    const bool done = setFromText(settings, key, value, "URL", problems);
    fuzz::requireTold(!done, problems);
    fuzz::require(done || settings == before, "what is refused changes nothing", problems);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text(reinterpret_cast<const char*>(data), size);
    Settings settings;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        set(settings, text.substr(0, end));
        pressHotkey(settings, text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    Settings again;
    for (const SettingRow& row : settingsTable()) {
        const std::string value = textOf(row, settings);
        Problems problems;
        if (!value.empty()) setFromText(again, row.key, value, "URL", problems);
        fuzz::require(problems.empty(), "a setting's own text sets it", problems);
        fuzz::require(textOf(row, again) == value, "a text stands for one value");
    }
    toUrlQuery(settings);
    return 0;
}
