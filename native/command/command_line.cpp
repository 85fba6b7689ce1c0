#include "native/command/command_line.h"

#include "tracer/plan/pose.h"

namespace gnomon {

namespace {

std::string helpOf(const SettingRow& row, const Settings& standard) {
    const std::string value = textOf(row, standard);
    std::string text(row.help);
    if (!value.empty()) text += " [" + value + "]";
    if (!row.next.empty()) text += " key " + std::string(row.next);
    if (!row.previous.empty()) text += ", " + std::string(row.previous);
    return text;
}

/// The values of a row, in ASCII so that CLI11's columns line up.
std::string valuesOf(const SettingRow& row) {
    std::string range = rangeOf(row);
    const std::string ellipsis = "…";
    for (auto at = range.find(ellipsis); at != std::string::npos; at = range.find(ellipsis))
        range.replace(at, ellipsis.size(), "..");
    return range;
}

} // namespace

Problem wrongOption(const std::string& option, const std::string& what, const std::string& remedy) {
    return {"command line", 0, option, what, remedy};
}

void addScene(CLI::App& command, std::string& scene, bool required) {
    auto* option = command.add_option(
        "SCENE", scene, "A scene's name, as `gnomon scenes` lists them, or a scene file; - is standard input");
    option->type_name("")->required(required);
}

void addSettings(CLI::App& command, Drawing& drawing) {
    for (const auto& row : settingsTable()) addSetting(command, drawing, row);
}

std::string optionNames(const SettingRow& row) {
    std::string names = "--" + std::string(row.key);
    for (const auto alias : row.aliases) names.append(",--").append(alias);
    return names;
}

void addSetting(CLI::App& command, Drawing& drawing, const SettingRow& row, const Settings& standard) {
    const std::string key(row.key);
    const auto keep = [&drawing, key](const std::string& text) { drawing.values.emplace_back(key, text); };
    command.add_option_function<std::string>(optionNames(row), keep, helpOf(row, standard))
        ->type_name(valuesOf(row))
        ->group(std::string(row.group))
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

std::optional<Settings> readSettings(const Drawing& drawing, Problems& problems, Settings settings) {
    bool right = true;
    for (const auto& [key, text] : drawing.values)
        right = setFromText(settings, key, text, "command line", problems) && right;
    return right ? std::optional(settings) : std::nullopt;
}

std::optional<CameraPose> poseOf(const Scene& scene, const Settings& settings, Problems& problems) {
    return poseOf(scene, settings, "command line", problems);
}

namespace {

std::vector<std::string> namesOf(const std::vector<const CLI::App*>& commands) {
    std::vector<std::string> names;
    for (const auto* command : commands) names.push_back(command->get_name());
    return names;
}

} // namespace

std::string pathOf(const CLI::App& command) {
    if (!command.get_parent()) return {};
    const std::string above = pathOf(*command.get_parent());
    return above.empty() ? command.get_name() : above + " " + command.get_name();
}

Problems unknownWords(const CLI::App& command) {
    std::vector<std::string> known;
    for (const auto* option : command.get_options())
        for (const auto& name : option->get_lnames()) known.push_back("--" + name);
    Problems problems;
    for (const auto& word : command.remaining()) {
        if (const auto below = namesOf(command.get_subcommands([](const CLI::App*) { return true; }));
            !below.empty() && word[0] != '-') {
            const auto meant = closest(word, {below.begin(), below.end()});
            problems.push_back(wrongOption({}, "there is no " + command.get_name() + " '" + word + "'",
                                           meant.empty() ? "`gnomon " + pathOf(command) + " --help` lists them"
                                                         : "did you mean '" + std::string(meant) + "'?"));
            continue;
        }
        if (word.empty() || word[0] != '-') {
            problems.push_back(wrongOption({}, "'" + word + "' is one word too many",
                                           "`gnomon " + pathOf(command) + " --help` shows what fits"));
            continue;
        }
        const std::string name = word.substr(0, word.find('='));
        const auto meant = closest(name, {known.begin(), known.end()});
        problems.push_back(wrongOption({}, "there is no option " + name,
                                       meant.empty() ? "`gnomon " + pathOf(command) + " --help` lists them"
                                                     : "did you mean " + std::string(meant) + "?"));
    }
    return problems;
}

} // namespace gnomon
