/// gnomon: the desktop program.
#include "lab/interruption.h"
#include "native/command/commands.h"

#include <algorithm>
#include <csignal>
#include <filesystem>

namespace {

using namespace gnomon;

std::vector<std::string> commandNames(const CLI::App& app) {
    std::vector<std::string> names;
    for (const auto* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

bool isSceneName(const std::string& word) {
    Problems ignored;
    const auto assets = AssetFolder::find(ignored);
    if (!assets) return false;
    const auto names = assets->sceneNames();
    return std::find(names.begin(), names.end(), word) != names.end();
}

/// `gnomon`, `gnomon lite` and `gnomon --depth=2` all mean `gnomon view …`.
bool meansView(const std::vector<std::string>& words, const CLI::App& app) {
    if (words.empty()) return true;
    const std::string& first = words.front();
    if (first == "-h" || first == "--help" || first == "--help-all" || first == "--version") return false;
    const auto commands = commandNames(app);
    return std::find(commands.begin(), commands.end(), first) == commands.end();
}

/// A first word that is neither command, scene nor file but close to a command.
Problems mistypedCommand(const std::vector<std::string>& words, const CLI::App& app) {
    const std::string word = words.empty() ? "" : words.front();
    std::error_code ignored;
    if (word.empty() || word[0] == '-' || isSceneName(word) || std::filesystem::exists(word, ignored)) return {};
    const auto commands = commandNames(app);
    const auto meant = closest(word, {commands.begin(), commands.end()});
    if (meant.empty()) return {};
    return {wrongOption({}, "there is no command '" + word + "'", "did you mean '" + std::string(meant) + "'?")};
}

/// Words that a command does not know are told in our own words, not CLI11's.
void allowExtras(CLI::App& app) {
    for (auto* command : app.get_subcommands({})) {
        command->allow_extras();
        allowExtras(*command);
    }
}

/// The innermost command that was chosen, as `lab intersect`; null where there is none.
const CLI::App* chosenIn(const CLI::App& app) {
    const auto chosen = app.get_subcommands();
    if (chosen.empty()) return nullptr;
    const CLI::App* inner = chosenIn(*chosen.front());
    return inner ? inner : chosen.front();
}

/// CLI11's words, except where they speak of types.
std::string whatIsWrong(const CLI::ParseError& error) {
    const std::string words = error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return words.substr(0, words.find(':')) + " has no value";
    return words;
}

int parseAndRun(CLI::App& app, std::vector<std::string> words, const Task& task) {
    std::reverse(words.begin(), words.end()); // as CLI11 takes them
    try {
        app.parse(words);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        const CLI::App* chosen = chosenIn(app);
        // An unknown option is often why another seems to be missing: it is told first.
        Problems problems = chosen ? unknownWords(*chosen) : Problems{};
        const std::string command = chosen ? pathOf(*chosen) + " " : "";
        if (problems.empty())
            problems.push_back(wrongOption({}, whatIsWrong(error), "`gnomon " + command + "--help` shows what fits"));
        return fail(kCommandLineWrong, problems);
    }
    const CLI::App* chosen = chosenIn(app);
    if (!chosen || !task) return kDone;
    if (const auto unknown = unknownWords(*chosen); !unknown.empty()) return fail(kCommandLineWrong, unknown);
    return task();
}

} // namespace

int main(int argc, char** argv) {
    holdStandardStreams();
    endWhenInterrupted(kInterrupted);
    std::signal(SIGXFSZ, SIG_IGN); // a file that may grow no more is told as a full disk is
    CLI::App app{"Gnomon: a real-time ray tracer in one shader"};
    app.name("gnomon");
    app.set_version_flag("--version", "gnomon " GNOMON_VERSION);
    app.require_subcommand(0, 1);
    app.footer(
        "`gnomon [SCENE]` is short for `gnomon view [SCENE]`; the first scene is lite.\n"
        "Exit codes: 0 done, 1 the input is wrong, 2 the command line is wrong, 3 no usable GL, 130 interrupted.");
    Task task;
    for (const auto add :
         {addView, addRender, addBench, addLab, addReport, addCheck, addShader, addScenes, addSettingsList, addInfo})
        add(app, task);
    allowExtras(app);

    std::vector<std::string> words(argv + 1, argv + argc);
    if (meansView(words, app)) {
        if (const auto mistyped = mistypedCommand(words, app); !mistyped.empty())
            return fail(kCommandLineWrong, mistyped);
        words.insert(words.begin(), "view");
    }
    return finish(parseAndRun(app, words, task));
}
