/// The table as others read it: URL, JSON, Markdown.
#include "tracer/settings/settings.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace gnomon {

namespace {

using Json = nlohmann::ordered_json;

struct ToJson {
    Json& row;
    const std::string standard; ///< the default as text
    const Settings defaults{};

    void operator()(const BoolType& type) { put("bool", defaults.*type.at); }
    void operator()(const IntType& type) {
        put("int", defaults.*type.at);
        limits(type.min, type.max);
    }
    void operator()(const RealType& type) {
        put("real", defaults.*type.at);
        limits(type.min, type.max);
    }
    void operator()(const OptionalRealType& type) {
        put("real", nullptr);
        limits(type.min, type.max);
    }
    void operator()(const OptionalPointType& type) {
        put("point", nullptr);
        limits(-type.limit, type.limit);
    }
    void operator()(const SizeType& type) {
        put("size", standard);
        limits(type.min, type.max);
    }
    void operator()(const ChoiceType& type) {
        put("choice", standard);
        row["names"] = type.names;
        for (const auto& [was, is] : type.renamed) row["renamed"][std::string(was)] = is;
    }

  private:
    template<class T>
    void put(const char* name, T value) {
        row["type"] = name;
        row["default"] = value;
    }
    template<class T>
    void limits(T min, T max) {
        row["min"] = min;
        row["max"] = max;
    }
};

const char* effectName(Effect effect) {
    switch (effect) {
    case Effect::Uniform: return "uniform";
    case Effect::Rebuild: return "rebuild";
    case Effect::Resize: return "resize";
    case Effect::Host: break;
    }
    return "host";
}

std::vector<std::string_view> hotkeysOf(const SettingRow& row) {
    std::vector<std::string_view> keys;
    for (auto key : {row.next, row.previous})
        if (!key.empty()) keys.push_back(key);
    return keys;
}

/// Letters, digits and what a URL's query lets stand (RFC 3986) stay; all else becomes %XX.
std::string percentEncoded(std::string_view text) {
    std::string encoded;
    for (unsigned char c : text) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           std::string_view("-._~,").find(char(c)) != std::string_view::npos;
        char code[4];
        std::snprintf(code, sizeof code, "%%%02X", unsigned(c));
        encoded += plain ? std::string(1, char(c)) : std::string(code);
    }
    return encoded;
}

std::string joined(const std::vector<std::string_view>& words) {
    std::string all;
    for (const auto word : words) all.append(all.empty() ? "" : " ").append(word);
    return all;
}

} // namespace

std::string toUrlQuery(const Settings& settings) {
    const Settings defaults;
    std::string query;
    for (const auto& row : settingsTable()) {
        const std::string text = textOf(row, settings);
        if (text == textOf(row, defaults)) continue;
        query.append(query.empty() ? "" : "&").append(row.key).append("=").append(percentEncoded(text));
    }
    return query;
}

std::string settingsJson() {
    Json table = Json::array();
    for (const auto& row : settingsTable()) {
        Json entry;
        entry["key"] = row.key;
        if (!row.aliases.empty()) entry["aliases"] = row.aliases;
        std::visit(ToJson{entry, textOf(row, {})}, row.type);
        entry["range"] = rangeOf(row);
        if (row.step > 0) entry["step"] = row.step;
        entry["group"] = row.group;
        entry["help"] = row.help;
        entry["hotkeys"] = hotkeysOf(row);
        entry["effect"] = effectName(row.effect);
        table.push_back(std::move(entry));
    }
    return table.dump(2);
}

std::string settingsMarkdown() {
    std::string text = "| setting | values | default | keys | what it does |\n|---|---|---|---|---|\n";
    for (const auto& row : settingsTable()) {
        std::string range = rangeOf(row);
        for (std::size_t bar = range.find('|'); bar != std::string::npos; bar = range.find('|', bar + 3))
            range.replace(bar, 1, " · "); // a bar would end the cell
        const std::string standard = textOf(row, Settings{});
        text.append("| `").append(row.key).append("` | ").append(range).append(" | ");
        text.append(standard.empty() ? "–" : standard).append(" | ").append(joined(hotkeysOf(row))).append(" | ");
        text.append(row.help).append(" |\n");
    }
    return text;
}

} // namespace gnomon
