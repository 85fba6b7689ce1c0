#include "lab/bench/bench_plan.h"

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

constexpr std::size_t kMostEntries = 2000;

using Values = std::span<const std::pair<std::string, std::string>>;

Problem wrong(std::string_view source, const std::string& key, const std::string& what, const std::string& remedy) {
    return {std::string(source), 0, key, what, remedy};
}

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> parts;
    for (std::size_t from = 0; from <= list.size();) {
        const std::size_t comma = std::min(list.find(',', from), list.size());
        parts.push_back(list.substr(from, comma - from));
        from = comma + 1;
    }
    return parts;
}

std::string joined(const std::vector<std::string>& values) {
    std::string text;
    for (const std::string& value : values) text += (text.empty() ? "" : ",") + value;
    return text;
}

/// What varies where nothing is said.
std::string standardList(std::string_view key) {
    if (key == "size") return "800x600";
    return key == "depth" ? "1,4,8" : "off," + textOf(*findSetting(key), {}); // shadows
}

std::vector<std::string> wordsOf(const SettingRow& row, const std::string& text) {
    const auto* choice = std::get_if<ChoiceType>(&row.type);
    if (choice && text == "all") return {choice->names.begin(), choice->names.end()};
    return takesList(row) ? split(text) : std::vector{text};
}

/// Each value once, as textOf() writes it.
Axis axisOf(const SettingRow& row, const std::string& text, std::string_view source, Problems& problems) {
    Axis axis{&row, {}};
    for (const std::string& word : wordsOf(row, text)) {
        Settings settings;
        if (!setFromText(settings, row.key, word, source, problems)) continue;
        const std::string value = textOf(row, settings);
        if (std::find(axis.values.begin(), axis.values.end(), value) == axis.values.end()) axis.values.push_back(value);
    }
    return axis;
}

/// The last value given for a setting, by its key or an alias, or null.
const std::string* given(Values values, const SettingRow& row) {
    const std::string* text = nullptr;
    for (const auto& [name, value] : values)
        if (findSetting(name) == &row) text = &value;
    return text;
}

/// Those that columns show. Settings with one value go into `fixed`.
std::vector<Axis> axesOf(Values values, Settings& fixed, std::string_view source, Problems& problems) {
    const auto standard = [&](std::string_view key) {
        const SettingRow& row = *findSetting(key);
        const std::string* text = given(values, row);
        return axisOf(row, text ? *text : standardList(key), source, problems);
    };
    std::vector<Axis> axes{standard("size")};
    for (const SettingRow& row : settingsTable()) {
        const std::string* text = given(values, row);
        if (!text || row.key == "size" || row.key == "depth" || row.key == "shadows") continue;
        Axis axis = axisOf(row, *text, source, problems);
        if (axis.values.size() == 1)
            setFromText(fixed, row.key, axis.values.front(), source, problems);
        else
            axes.push_back(std::move(axis));
    }
    axes.push_back(standard("depth"));
    axes.push_back(standard("shadows"));
    return axes;
}

/// Combination `number` of the axes' values.
BenchEntry entryOf(std::size_t scene, std::size_t number, const std::vector<Axis>& axes, const Settings& fixed) {
    BenchEntry entry{scene, std::vector<std::string>(axes.size()), fixed};
    Problems none; // the values have been read before
    for (std::size_t i = axes.size(); i-- > 0;) {
        const Axis& axis = axes[i];
        entry.values[i] = axis.values[number % axis.values.size()];
        number /= axis.values.size();
        setFromText(entry.settings, axis.setting->key, entry.values[i], {}, none);
    }
    return entry;
}

void combine(BenchPlan& plan, const Settings& fixed, std::string_view source, Problems& problems) {
    std::size_t combinations = 1;
    for (const Axis& axis : plan.axes) combinations = std::min(combinations * axis.values.size(), kMostEntries + 1);
    if (combinations * plan.scenes.size() > kMostEntries) {
        problems.push_back(wrong(source, {}, "these lists make more than " + std::to_string(kMostEntries) + " rows",
                                 "give fewer values"));
        return;
    }
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene)
        for (std::size_t i = 0; i < combinations; ++i) plan.entries.push_back(entryOf(scene, i, plan.axes, fixed));
}

/// What a baseline prescribes: a value for some axes, perhaps a scene.
struct Prescribed {
    std::vector<std::optional<std::string>> values;
    std::optional<std::size_t> scene;
};

std::string sayAxes(const BenchPlan& plan) {
    std::string text = "scene";
    for (const Axis& axis : plan.axes) text += ", " + std::string(axis.setting->key);
    return text;
}

void prescribe(const std::string& key, const std::string& text, const BenchPlan& plan, Prescribed& prescribed,
               std::string_view source, Problems& problems) {
    const auto refuse = [&](const std::string& what, const std::string& remedy) {
        problems.push_back(wrong(source, "baseline", what, remedy));
    };
    if (key == "scene") {
        const auto found = std::find(plan.scenes.begin(), plan.scenes.end(), text);
        if (found == plan.scenes.end()) return refuse("'" + text + "' is none of the scenes", {});
        prescribed.scene = std::size_t(found - plan.scenes.begin());
        return;
    }
    const SettingRow* row = findSetting(key);
    const auto axis = std::find_if(plan.axes.begin(), plan.axes.end(),
                                   [&](const Axis& candidate) { return candidate.setting == row; });
    if (axis == plan.axes.end()) return refuse("'" + key + "' does not vary here", "use " + sayAxes(plan));
    const auto* choice = std::get_if<ChoiceType>(&row->type);
    const std::string value(choice ? renamed(text, choice->renamed) : text);
    if (std::find(axis->values.begin(), axis->values.end(), value) == axis->values.end())
        return refuse(std::string(row->key) + " is never '" + text + "' here",
                      "add it to " + spelled(source, row->key) + ", or choose one of its values");
    prescribed.values[std::size_t(axis - plan.axes.begin())] = value;
}

/// Where nothing is prescribed: the first value of every axis.
Prescribed prescribedBy(const std::string& baseline, const BenchPlan& plan, std::string_view source,
                        Problems& problems) {
    Prescribed prescribed{std::vector<std::optional<std::string>>(plan.axes.size()), {}};
    if (baseline.empty()) {
        for (std::size_t i = 0; i < plan.axes.size(); ++i) prescribed.values[i] = plan.axes[i].values.front();
        return prescribed;
    }
    for (const std::string& pair : split(baseline)) {
        const std::size_t equals = pair.find('=');
        if (equals == std::string::npos)
            problems.push_back(wrong(source, "baseline", "'" + pair + "' is no KEY=VALUE",
                                     "write it as " + spelled(source, "baseline") + "=shadows=off"));
        else
            prescribe(pair.substr(0, equals), pair.substr(equals + 1), plan, prescribed, source, problems);
    }
    return prescribed;
}

/// Of settings that no frame could be measured with.
void checkKeys(Values values, std::string_view source, Problems& problems) {
    for (const auto& [key, text] : values) {
        Settings ignored;
        const SettingRow* row = findSetting(key);
        if (!row)
            setFromText(ignored, key, text, source, problems); // says what may be meant
        else if (!isBenchSetting(*row))
            problems.push_back(
                wrong(source, key, "no frame that is drawn for measuring depends on it", "leave it out"));
    }
}

std::size_t baselineOf(const BenchEntry& entry, const BenchPlan& plan, const Prescribed& prescribed) {
    std::vector<std::string> wanted = entry.values;
    for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = prescribed.values[i].value_or(wanted[i]);
    const std::size_t scene = prescribed.scene.value_or(entry.scene);
    const auto found = std::find_if(plan.entries.begin(), plan.entries.end(), [&](const BenchEntry& candidate) {
        return candidate.scene == scene && candidate.values == wanted;
    });
    return std::size_t(found - plan.entries.begin());
}

} // namespace

bool isBenchSetting(const SettingRow& row) {
    constexpr std::array<std::string_view, 4> kOfWindows{"pause", "speed", "adapt", "vsync"};
    return std::find(kOfWindows.begin(), kOfWindows.end(), row.key) == kOfWindows.end();
}

bool takesList(const SettingRow& row) { return !std::holds_alternative<OptionalPointType>(row.type); }

BenchPlan planBench(const std::vector<std::string>& scenes, Values values, const std::string& baseline,
                    Problems& problems, std::string_view source) {
    const std::size_t before = problems.size();
    BenchPlan plan;
    for (const std::string& scene : scenes)
        if (std::find(plan.scenes.begin(), plan.scenes.end(), scene) == plan.scenes.end()) plan.scenes.push_back(scene);
    if (plan.scenes.empty()) problems.push_back(wrong(source, "scenes", "there is none", "name at least one"));
    checkKeys(values, source, problems);
    Settings fixed;
    plan.axes = axesOf(values, fixed, source, problems);
    if (problems.size() > before) return plan;
    combine(plan, fixed, source, problems);
    const Prescribed prescribed = prescribedBy(baseline, plan, source, problems);
    if (problems.size() > before) return plan;
    for (const BenchEntry& entry : plan.entries) plan.baselines.push_back(baselineOf(entry, plan, prescribed));
    plan.baselineText = baseline.empty() ? "first" : baseline;
    return plan;
}

std::vector<std::pair<std::string, std::string>> valuesOf(const BenchPlan& plan, Values values) {
    std::vector<std::pair<std::string, std::string>> all;
    for (const SettingRow& row : settingsTable()) {
        const auto axis =
            std::find_if(plan.axes.begin(), plan.axes.end(), [&](const Axis& a) { return a.setting == &row; });
        if (axis != plan.axes.end())
            all.emplace_back(row.key, joined(axis->values));
        else if (const std::string* value = given(values, row))
            all.emplace_back(row.key, *value);
    }
    return all;
}

std::string optionsOf(const BenchPlan& plan, Values values) {
    std::string text;
    for (const auto& [key, value] : valuesOf(plan, values)) text += " --" + key + "=" + value;
    return text;
}

std::string toString(const BenchPlan& plan, const BenchEntry& entry) {
    std::string text = plan.scenes[entry.scene];
    for (std::size_t i = 0; i < plan.axes.size(); ++i)
        text += ", " + std::string(plan.axes[i].setting->key) + " " + entry.values[i];
    return text;
}

} // namespace gnomon
