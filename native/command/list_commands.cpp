/// gnomon scenes, gnomon settings and gnomon info: what there is.
#include "lab/batch/numerics_self_test.h"
#include "native/command/commands.h"
#include "native/context/context.h"
#include "tracer/printable.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace gnomon {

namespace {

using Json = nlohmann::ordered_json;

int printJson(const Json& json) {
    std::printf("%s\n", printable(json.dump(2, ' ', false, Json::error_handler_t::replace), true).c_str());
    return kDone;
}

int listScenes(bool asJson) {
    Problems problems;
    const auto assets = AssetFolder::find(problems);
    if (!assets) return fail(kInputWrong, problems);
    Json list = Json::array();
    for (const auto& name : assets->sceneNames()) {
        const auto scene = assets->readScene(name, problems);
        if (!scene) continue;
        list.push_back({{"name", name},
                        {"title", scene->title},
                        {"description", scene->description},
                        {"file", scene->file},
                        {"objects", scene->objects.size()},
                        {"lights", scene->lights.size()}});
    }
    if (asJson) printJson(list);
    for (const auto& scene : list) {
        if (asJson) break;
        const std::string name = scene["name"], title = scene["title"];
        std::printf("%-16s %4d objects  %s\n", printable(name).c_str(), int(scene["objects"]),
                    printable(title).c_str());
    }
    return problems.empty() ? kDone : fail(kInputWrong, problems);
}

int listSettings(bool asJson) {
    std::printf("%s", asJson ? (settingsJson() + "\n").c_str() : settingsMarkdown().c_str());
    return kDone;
}

/// What GL says of itself through this kind of context and how exact its numbers are, or why there is none.
Json describe(ContextKind kind) {
    Problems problems;
    const auto context = makeContext(kind, problems);
    if (!context) return {{"usable", false}, {"problem", problems.empty() ? "" : toString(problems.front())}};
    const gl::Info info = gl::info();
    return {{"usable", true},
            {"version", info.version},
            {"renderer", info.renderer},
            {"vendor", info.vendor},
            {"shading_language", info.shadingLanguage},
            {"es", info.es},
            {"essl300", info.essl300},
            {"float_targets", info.floatTargets},
            {"parallel_compile", info.parallelCompile},
            {"max_texture_size", info.maxTextureSize},
            {"max_uniform_block_size", info.maxUniformBlockSize},
            {"numerics", Json::parse(toJson(runNumericsSelfTest()))}};
}

void printContext(const std::string& name, const Json& context) {
    if (!context["usable"].get<bool>()) {
        std::printf("%-8s no: %s\n", name.c_str(), printable(context["problem"].get<std::string>()).c_str());
        return;
    }
    for (const char* key : {"renderer", "version", "shading_language"})
        std::printf("%-8s %s\n", key == std::string("renderer") ? name.c_str() : "",
                    context[key].get<std::string>().c_str());
    std::printf("%-8s %s\n", "", context["numerics"]["summary"].get<std::string>().c_str());
}

/// Loud enough to be seen where the lists go into a file.
void warnOfNumerics(const Json& contexts) {
    for (const auto& [name, context] : contexts.items()) {
        const Json numerics = context.value("numerics", Json::object());
        if (!numerics.value("measured", false) || numerics.value("holds", false)) continue;
        std::fprintf(stderr, "gnomon: warning: %s: %s\n", name.c_str(), numerics["summary"].get<std::string>().c_str());
    }
}

int info(bool asJson) {
    Problems problems;
    const auto assets = AssetFolder::find(problems);
    Json report{{"version", GNOMON_VERSION}, {"assets", assets ? assets->root().string() : ""}};
    for (auto kind : {ContextKind::OsMesa, ContextKind::Egl, ContextKind::Window})
        report["contexts"][std::string(nameOf(kind))] = describe(kind);
    warnOfNumerics(report["contexts"]);
    if (asJson) return printJson(report);
    std::printf("gnomon   " GNOMON_VERSION "\nassets   %s\n",
                assets ? printable(assets->root().string()).c_str() : printable(toString(problems), true).c_str());
    for (const auto& [name, context] : report["contexts"].items()) printContext(name, context);
    return kDone;
}

void addList(CLI::App& app, Task& task, const char* name, const char* help, int (*list)(bool asJson)) {
    auto asJson = std::make_shared<bool>(false);
    auto* command = app.add_subcommand(name, help);
    command->add_flag("--json", *asJson, "As JSON");
    command->callback([&task, asJson, list] { task = [asJson, list] { return list(*asJson); }; });
}

} // namespace

void addScenes(CLI::App& app, Task& task) {
    addList(app, task, "scenes", "Lists the scenes that come with the program", listScenes);
}

void addSettingsList(CLI::App& app, Task& task) {
    addList(app, task, "settings", "Lists all settings with their values, defaults and keys", listSettings);
}

void addInfo(CLI::App& app, Task& task) {
    addList(app, task, "info", "Says which GL there is, and where scenes and textures are", info);
}

} // namespace gnomon
