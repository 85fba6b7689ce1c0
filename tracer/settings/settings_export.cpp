/// The table as others read it: URL, JSON, Markdown.
#include "tracer/settings/settings.h"

#include <cstdio>

namespace gnomon {

namespace {

// Written by hand: a JSON library's writer would be 3 KB of what each visitor of the page downloads.

/// No control characters: there are none in the table.
std::string jsonText(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
}

std::string listOf(const std::vector<std::string_view>& words) {
    std::string list;
    for (const auto word : words) list.append(list.empty() ? "" : ", ").append(jsonText(word));
    return '[' + list + ']';
}

/// A JSON object, member by member.
class ObjectText {
  public:
    void put(std::string_view key, std::string_view json) {
        text_.append(text_.empty() ? "{" : ",").append("\n    ").append(jsonText(key)).append(": ").append(json);
    }
    std::string text() const { return text_ + "\n  }"; }

  private:
    std::string text_;
};

struct PutType {
    ObjectText& row;
    const std::string standard; ///< the default as text
    const Settings defaults{};

    void operator()(const BoolType& type) { put("bool", defaults.*type.at ? "true" : "false"); }
    void operator()(const IntType& type) {
        put("int", standard);
        limits(type.min, type.max);
    }
    void operator()(const RealType& type) {
        put("real", standard);
        limits(type.min, type.max);
    }
    void operator()(const OptionalRealType& type) {
        put("real", "null");
        limits(type.min, type.max);
    }
    void operator()(const OptionalPointType& type) {
        put("point", "null");
        limits(-type.limit, type.limit);
    }
    void operator()(const SizeType& type) {
        put("size", jsonText(standard));
        limits(type.min, type.max);
    }
    void operator()(const ChoiceType& type) {
        put("choice", jsonText(standard));
        row.put("names", listOf(type.names));
        std::string renamed;
        for (const auto& [was, is] : type.renamed)
            renamed.append(renamed.empty() ? "{" : ", ").append(jsonText(was)).append(": ").append(jsonText(is));
        if (!renamed.empty()) row.put("renamed", renamed + '}');
    }

  private:
    void put(std::string_view name, std::string_view json) {
        row.put("type", jsonText(name));
        row.put("default", json);
    }
    void limits(double min, double max) {
        row.put("min", numberText(min));
        row.put("max", numberText(max));
    }
};

const char* effectName(Effect effect) {
    switch (effect) {
    case Effect::Uniform: return "uniform";
    case Effect::Rebuild: return "rebuild";
    case Effect::Bake: return "bake";
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
    std::string table;
    for (const auto& row : settingsTable()) {
        ObjectText entry;
        entry.put("key", jsonText(row.key));
        if (!row.aliases.empty()) entry.put("aliases", listOf(row.aliases));
        std::visit(PutType{entry, textOf(row, {})}, row.type);
        entry.put("range", jsonText(rangeOf(row)));
        if (row.step > 0) entry.put("step", numberText(row.step));
        entry.put("group", jsonText(row.group));
        entry.put("help", jsonText(row.help));
        entry.put("hotkeys", listOf(hotkeysOf(row)));
        entry.put("effect", jsonText(effectName(row.effect)));
        table.append(table.empty() ? "[\n  " : ",\n  ").append(entry.text());
    }
    return table + "\n]";
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
