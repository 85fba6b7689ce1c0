/// A setting's value as text and back.
#include "tracer/settings/settings.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace gnomon {

std::string numberText(double value) {
    char text[40];
    for (int digits = 7; digits <= 17; ++digits) {
        std::snprintf(text, sizeof text, "%.*g", digits, value);
        if (std::strtod(text, nullptr) == value) break;
    }
    std::string shortest = text;
    if (auto plus = shortest.find('+'); plus != std::string::npos) shortest.erase(plus, 1); // a blank in URLs
    return shortest;
}

namespace {

std::string quoted(std::string_view text) { return std::string("'").append(text).append("'"); }

/// What keeps a text from being a value; empty where nothing does.
struct Wrong {
    std::string what, remedy;
    explicit operator bool() const { return !what.empty(); }
};

Wrong outOfRange(std::string_view text, const std::string& range) {
    return {std::string(text) + " is out of range", "use " + range};
}

Wrong readInt(std::string_view text, int min, int max, int& value) {
    const std::string range = std::to_string(min) + "…" + std::to_string(max);
    const char* end = text.data() + text.size();
    int number = 0;
    auto [stop, error] = std::from_chars(text.data(), end, number);
    if (stop != end || error == std::errc::invalid_argument)
        return {quoted(text) + " is not a whole number", "use " + range};
    if (error != std::errc() || number < min || number > max) return outOfRange(text, range);
    value = number;
    return {};
}

bool isDecimalComma(std::string_view text) {
    const std::size_t comma = text.find(',');
    return comma != std::string_view::npos && text.find_first_not_of("+-.0123456789eE") == comma &&
           text.find_first_not_of("0123456789", comma + 1) == std::string_view::npos;
}

/// Decimal numbers only: what strtod takes besides (blanks, hexadecimal, inf, nan) is refused before.
Wrong readReal(std::string_view text, double min, double max, double& value) {
    const std::string range = numberText(min) + "…" + numberText(max), copy(text);
    char* stop = nullptr;
    const double number = std::strtod(copy.c_str(), &stop);
    if (copy.empty() || copy.find_first_not_of("+-.0123456789eE") != std::string::npos ||
        stop != copy.c_str() + copy.size())
        return {quoted(text) + " is not a number",
                isDecimalComma(text) ? "write a decimal point, as 0.8" : "use " + range};
    if (!(number >= min && number <= max)) return outOfRange(text, range);
    value = number;
    return {};
}

Wrong readChoice(std::string_view text, const std::vector<std::string_view>& names, const std::string& range,
                 int& index) {
    const auto found = std::find(names.begin(), names.end(), text);
    if (found != names.end()) {
        index = int(found - names.begin());
        return {};
    }
    const auto meant = closest(text, names);
    return {quoted(text) + " is none of " + range, meant.empty() ? "" : "did you mean " + quoted(meant) + "?"};
}

Wrong readPoint(std::string_view text, double limit, glm::dvec3& point) {
    const Wrong notPoint{quoted(text) + " is not a point", "use three numbers, as 0,1.5,-3"};
    for (int axis = 0; axis < 3; ++axis) {
        const auto comma = text.find(',');
        if ((comma == std::string_view::npos) != (axis == 2)) return notPoint;
        if (auto wrong = readReal(text.substr(0, comma), -limit, limit, point[axis])) return wrong;
        text.remove_prefix(axis == 2 ? text.size() : comma + 1);
    }
    return {};
}

Wrong readSize(std::string_view text, const SizeType& type, glm::ivec2& size) {
    const auto cross = text.find('x');
    if (cross == std::string_view::npos) return {quoted(text) + " is not a size", "use WIDTHxHEIGHT, as 800x600"};
    glm::ivec2 read;
    if (auto wrong = readInt(text.substr(0, cross), type.min, type.max, read.x)) return wrong;
    if (auto wrong = readInt(text.substr(cross + 1), type.min, type.max, read.y)) return wrong;
    if (std::int64_t(read.x) * read.y > std::int64_t(type.megapixels) << 20)
        return {quoted(text) + " is too large",
                "use at most " + std::to_string(type.megapixels) + " x 1024 x 1024 pixels"};
    size = read;
    return {};
}

/// Reads `text` into the row's member.
struct FromText {
    Settings& settings;
    std::string_view text;
    const SettingRow& row;

    Wrong operator()(const BoolType& type) {
        int index = 0;
        static const std::vector<std::string_view> names{"off", "on", "false", "true", "0", "1"};
        auto wrong = readChoice(text, names, rangeOf(row), index);
        if (!wrong) settings.*type.at = index % 2 == 1;
        return wrong;
    }
    Wrong operator()(const IntType& type) { return readInt(text, type.min, type.max, settings.*type.at); }
    Wrong operator()(const RealType& type) { return readReal(text, type.min, type.max, settings.*type.at); }
    Wrong operator()(const OptionalRealType& type) {
        double number = 0;
        auto wrong = text.empty() ? Wrong{} : readReal(text, type.min, type.max, number);
        if (!wrong) settings.*type.at = text.empty() ? std::nullopt : std::optional(number);
        return wrong;
    }
    Wrong operator()(const OptionalPointType& type) {
        glm::dvec3 point{0};
        auto wrong = text.empty() ? Wrong{} : readPoint(text, type.limit, point);
        if (!wrong) settings.*type.at = text.empty() ? std::nullopt : std::optional(point);
        return wrong;
    }
    Wrong operator()(const SizeType& type) { return readSize(text, type, settings.*type.at); }
    Wrong operator()(const ChoiceType& type) {
        int index = 0;
        auto wrong = readChoice(renamed(text, type.renamed), type.names, rangeOf(row), index);
        if (!wrong) type.set(settings, index);
        return wrong;
    }
};

struct ToText {
    const Settings& settings;

    std::string operator()(const BoolType& type) const { return settings.*type.at ? "on" : "off"; }
    std::string operator()(const IntType& type) const { return std::to_string(settings.*type.at); }
    std::string operator()(const RealType& type) const { return numberText(settings.*type.at); }
    std::string operator()(const OptionalRealType& type) const {
        return settings.*type.at ? numberText(*(settings.*type.at)) : "";
    }
    std::string operator()(const OptionalPointType& type) const {
        const auto& point = settings.*type.at;
        return point ? numberText(point->x) + "," + numberText(point->y) + "," + numberText(point->z) : "";
    }
    std::string operator()(const SizeType& type) const {
        return std::to_string((settings.*type.at).x) + "x" + std::to_string((settings.*type.at).y);
    }
    std::string operator()(const ChoiceType& type) const { return std::string(type.names[type.get(settings)]); }
};

struct RangeText {
    std::string operator()(const BoolType&) const { return "on|off"; }
    std::string operator()(const IntType& type) const {
        return std::to_string(type.min) + "…" + std::to_string(type.max);
    }
    std::string operator()(const RealType& type) const { return numberText(type.min) + "…" + numberText(type.max); }
    std::string operator()(const OptionalRealType& type) const {
        return numberText(type.min) + "…" + numberText(type.max);
    }
    std::string operator()(const OptionalPointType&) const { return "X,Y,Z"; }
    std::string operator()(const SizeType& type) const {
        return "WIDTHxHEIGHT, each " + std::to_string(type.min) + "…" + std::to_string(type.max) + ", at most " +
               std::to_string(type.megapixels) + " Mi pixels";
    }
    std::string operator()(const ChoiceType& type) const {
        if (type.names.size() > 12) return std::string(type.names.front()) + "…" + std::string(type.names.back());
        std::string all;
        for (const auto name : type.names) all.append(all.empty() ? "" : "|").append(name);
        return all;
    }
};

/// The key that may be meant, in its present spelling; empty where none is close.
std::string_view closestKey(std::string_view key) {
    std::vector<std::string_view> keys;
    for (const auto& row : settingsTable()) {
        keys.push_back(row.key);
        keys.insert(keys.end(), row.aliases.begin(), row.aliases.end());
    }
    const auto meant = closest(key, keys);
    return meant.empty() ? meant : findSetting(meant)->key;
}

} // namespace

std::string_view renamed(std::string_view name, std::span<const Renamed> all) {
    for (const auto& [was, is] : all)
        if (was == name) return is;
    return name;
}

std::string textOf(const SettingRow& row, const Settings& settings) { return std::visit(ToText{settings}, row.type); }

std::string rangeOf(const SettingRow& row) { return std::visit(RangeText{}, row.type); }

bool setFromText(Settings& settings, std::string_view key, std::string_view text, std::string_view source,
                 Problems& problems) {
    const SettingRow* row = findSetting(key);
    if (!row) {
        const auto meant = closestKey(key);
        problems.push_back({std::string(source),
                            0,
                            {},
                            "there is no setting " + quoted(key),
                            meant.empty() ? "`gnomon settings` lists them" : "did you mean " + quoted(meant) + "?"});
        return false;
    }
    Settings changed = settings;
    const Wrong wrong = std::visit(FromText{changed, text, *row}, row->type);
    if (wrong)
        problems.push_back({std::string(source), 0, std::string(row->key), wrong.what, wrong.remedy});
    else
        settings = changed;
    return !wrong;
}

std::string spelled(std::string_view source, std::string_view key) {
    return (source == "command line" ? "--" : "") + std::string(key);
}

} // namespace gnomon
