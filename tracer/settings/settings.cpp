#include "tracer/settings/settings.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace gnomon {

namespace {

constexpr double kFar = 1e6; ///< limit of coordinates and seconds: beyond, float has less than 1/16 left

std::vector<SettingRow> makeTable() {
    std::vector<std::string_view> models;
    for (const ShadowRow& row : kShadowModels) models.push_back(row.key);
    const ChoiceType shadows{models, [](const Settings& s) { return int(s.shadows); },
                             [](Settings& s, int i) { s.shadows = ShadowModel(i); }, true};
    const ChoiceType aov{{"color", "distance", "position", "normal", "object", "visibility", "work", "steps"},
                         [](const Settings& s) { return int(s.aov); },
                         [](Settings& s, int i) { s.aov = Aov(i); }};
    const ChoiceType direction{{"a", "b"},
                               [](const Settings& s) { return int(s.coneOrigin); },
                               [](Settings& s, int i) { s.coneOrigin = ConeOrigin(i); }};
    const ChoiceType march{{"steps", "sphere", "cone", "relaxed"},
                           [](const Settings& s) { return int(s.march); },
                           [](Settings& s, int i) { s.march = March(i); }};
    const ChoiceType data{{"auto", "block", "texture"},
                          [](const Settings& s) { return int(s.data); },
                          [](Settings& s, int i) { s.data = DataPath(i); }};
    const ChoiceType colorMode{{colorModes().begin(), colorModes().end()},
                               [](const Settings& s) { return s.colorMode; },
                               [](Settings& s, int i) { s.colorMode = i; }};
    const ChoiceType accel{{"auto", "none", "hierarchy"},
                           [](const Settings& s) { return int(s.accel); },
                           [](Settings& s, int i) { s.accel = Accel(i); }};
    const ChoiceType parts{{"auto", "on", "off"},
                           [](const Settings& s) { return int(s.parts); },
                           [](Settings& s, int i) { s.parts = Parts(i); }};
    using S = Settings;
    return {
        {"depth", IntType{&S::depth, 1, 8}, "Rays", "How many surfaces light may meet on its way to the eye", 1,
         "Right", "Left", Effect::Rebuild},
        {"threshold", RealType{&S::threshold, 0, 1}, "Rays",
         "Rays that carry less than this share of the picture are not followed", 1.0 / 512},
        {"shadows", shadows, "Light", "How shadows are found", 0, "1", {}, Effect::Rebuild},
        {"epsilon", RealType{&S::epsilon, 1.0 / 4096, 0.5}, "Light",
         "Error of the light fraction that shadow cones may make", 0.005},
        {"direction",
         direction,
         "Light",
         "Shadow cones go a: from the surface to the light, b: the other way",
         0,
         {},
         {},
         Effect::Rebuild},
        {"shadow-steps", IntType{&S::shadowSteps, 1, 4096}, "Light", "Steps after which a march to a light gives up",
         1},
        {"samples", IntType{&S::samples, 1, 65536}, "Light",
         "Points of each light that `shadows=montecarlo` and `montecarlo-march` look at", 1},
        {"first-sample", IntType{&S::firstSample, 0, 1 << 20}, "Light",
         "Where in their sequence the samples begin: pictures of stretches that follow one another average to that of "
         "all",
         1},
        {"light-radius", OptionalRealType{&S::lightRadius, 0, 1e4}, "Light",
         "Radius of all lights; the scene's own if unset", 0.05},
        {"march",
         march,
         "Rays",
         "How rays find distance objects: in equal steps, by spheres, by the cone of a pixel, by that in longer steps",
         0,
         {},
         {},
         Effect::Rebuild},
        {"march-steps", IntType{&S::marchSteps, 1, 4096}, "Rays", "Steps after which a ray gives up a distance object",
         1},
        {"glow", BoolType{&S::glow}, "Light", "Light in the air around objects that glow", 0, "G", {}, Effect::Rebuild},
        {"normal-maps", BoolType{&S::normalMaps}, "Light", "Fine relief from images", 0, "N", {}, Effect::Rebuild},
        {"color-mode", colorMode, "Picture", "Which of red, green and blue each channel of the picture shows", 0, "Up",
         "Down"},
        {"aov",
         aov,
         "Picture",
         "What the pixels hold: the colour, or a number of the surface they see",
         0,
         {},
         {},
         Effect::Rebuild},
        {"light", IntType{&S::light, 0, 15}, "Picture",
         "Which light `aov=visibility` asks for, as counted in the scene file", 1},
        {"time", RealType{&S::time, -kFar, kFar}, "Motion", "Seconds on the scene's clock", 0.1},
        {"pause", BoolType{&S::pause}, "Motion", "Stops the scene's clock", 0, "P"},
        {"eye", OptionalPointType{&S::eye, kFar}, "Camera",
         "Where the picture is taken from; the scene's own if unset"},
        {"target", OptionalPointType{&S::target, kFar}, "Camera", "What the camera looks at; the scene's own if unset"},
        {"fov", OptionalRealType{&S::fov, 1, 170}, "Camera",
         "Vertical angle of view in degrees; the scene's own if unset", 1},
        {"speed",
         RealType{&S::speed, 0.001, 1e4},
         "Camera",
         "Units a second that W, A, S and D move; half with Shift",
         1,
         {},
         {},
         Effect::Host},
        {"size", SizeType{&S::size, 1, 16384, 64}, "Canvas", "Width and height in pixels", 0, {}, {}, Effect::Resize},
        {"scale",
         RealType{&S::scale, 0.1, 1},
         "Canvas",
         "Resolution of the picture over that of the canvas",
         0.05,
         {},
         {},
         Effect::Host},
        {"adapt",
         BoolType{&S::adapt},
         "Canvas",
         "Draws coarser while the picture moves and takes too long",
         0,
         {},
         {},
         Effect::Host},
        {"vsync",
         BoolType{&S::vsync},
         "Canvas",
         "Waits for the screen before the next picture (desktop)",
         0,
         "V",
         {},
         Effect::Host},
        {"accel", accel, "Canvas", "How rays find the objects that they meet", 0, {}, {}, Effect::Rebuild},
        {"data", data, "Canvas", "Where the shader finds the scene's numbers", 0, {}, {}, Effect::Rebuild},
        {"parts", parts, "Canvas", "Smaller shaders draw what needs no more", 0, {}, {}, Effect::Rebuild},
    };
}

/// The shortest decimal text that reads back as `value`.
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

std::string quoted(std::string_view text) { return std::string("'").append(text).append("'"); }

std::string join(const std::vector<std::string_view>& words, std::string_view between) {
    std::string all;
    for (auto word : words) all.append(all.empty() ? "" : between).append(word);
    return all;
}

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

/// Decimal numbers only: what strtod takes besides (blanks, hexadecimal, inf, nan) is refused before.
Wrong readReal(std::string_view text, double min, double max, double& value) {
    const std::string range = numberText(min) + "…" + numberText(max), copy(text);
    char* stop = nullptr;
    const double number = std::strtod(copy.c_str(), &stop);
    if (copy.empty() || copy.find_first_not_of("+-.0123456789eE") != std::string::npos ||
        stop != copy.c_str() + copy.size())
        return {quoted(text) + " is not a number", "use " + range};
    if (!(number >= min && number <= max)) return outOfRange(text, range);
    value = number;
    return {};
}

Wrong readChoice(std::string_view text, const std::vector<std::string_view>& names, const std::string& range,
                 int& index) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == text) {
            index = int(i);
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
        auto wrong = readChoice(text, type.names, rangeOf(row), index);
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
        return join(type.names, "|");
    }
};

/// Goes one on or back; answers what stands in the way, as `the most`.
struct Step {
    Settings& settings;
    int by;

    std::string operator()(const BoolType& type) {
        settings.*type.at = !(settings.*type.at);
        return {};
    }
    std::string operator()(const IntType& type) {
        const int wanted = settings.*type.at + by;
        settings.*type.at = std::min(std::max(wanted, type.min), type.max);
        return wanted > type.max ? "the most" : wanted < type.min ? "the least" : "";
    }
    std::string operator()(const ChoiceType& type) {
        const int count = int(type.names.size());
        if (type.switches) return type.set(settings, type.get(settings) == 0), std::string();
        type.set(settings, (type.get(settings) + by + count) % count);
        return {};
    }
    template<class Other>
    std::string operator()(const Other&) {
        return {};
    } // numbers and points have no hotkeys
};

using Json = nlohmann::ordered_json;

struct ToJson {
    Json& row;
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
        put("size", ToText{defaults}(type));
        limits(type.min, type.max);
    }
    void operator()(const ChoiceType& type) {
        put("choice", ToText{defaults}(type));
        row["names"] = type.names;
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

} // namespace

int channelsOf(Aov aov) {
    return aov == Aov::Color || aov == Aov::Position || aov == Aov::Normal || aov == Aov::Work ? 3 : 1;
}

std::span<const SettingRow> settingsTable() {
    static const std::vector<SettingRow> table = makeTable();
    return table;
}

const SettingRow* findSetting(std::string_view key) {
    for (const auto& row : settingsTable())
        if (row.key == key) return &row;
    return nullptr;
}

std::span<const std::string_view> colorModes() {
    static constexpr std::array<std::string_view, 27> names{
        "rrr", "rrg", "rrb", "rgr", "rgg", "rgb", "rbr", "rbg", "rbb", "grr", "grg", "grb", "ggr", "ggg",
        "ggb", "gbr", "gbg", "gbb", "brr", "brg", "brb", "bgr", "bgg", "bgb", "bbr", "bbg", "bbb"};
    return names;
}

std::string textOf(const SettingRow& row, const Settings& settings) { return std::visit(ToText{settings}, row.type); }

std::string rangeOf(const SettingRow& row) { return std::visit(RangeText{}, row.type); }

bool setFromText(Settings& settings, std::string_view key, std::string_view text, std::string_view place,
                 Problems& problems) {
    const SettingRow* row = findSetting(key);
    if (!row) {
        std::vector<std::string_view> keys;
        for (const auto& known : settingsTable()) keys.push_back(known.key);
        const auto meant = closest(key, keys);
        problems.push_back({std::string(place),
                            0,
                            {},
                            "there is no setting " + quoted(key),
                            meant.empty() ? "`gnomon settings` lists them" : "did you mean " + quoted(meant) + "?"});
        return false;
    }
    Settings changed = settings;
    const Wrong wrong = std::visit(FromText{changed, text, *row}, row->type);
    if (wrong)
        problems.push_back({std::string(place), 0, std::string(key), wrong.what, wrong.remedy});
    else
        settings = changed;
    return !wrong;
}

std::string spelled(std::string_view place, std::string_view key) {
    return (place == "command line" ? "--" : "") + std::string(key);
}

std::string pressHotkey(Settings& settings, std::string_view key) {
    for (const auto& row : settingsTable()) {
        if (key.empty() || (row.next != key && row.previous != key)) continue;
        const std::string stop = std::visit(Step{settings, row.next == key ? 1 : -1}, row.type);
        return std::string(row.key) + " " + textOf(row, settings) + (stop.empty() ? "" : ", " + stop);
    }
    return {};
}

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
        std::visit(ToJson{entry}, row.type);
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
        text.append(standard.empty() ? "–" : standard).append(" | ").append(join(hotkeysOf(row), " ")).append(" | ");
        text.append(row.help).append(" |\n");
    }
    return text;
}

} // namespace gnomon
