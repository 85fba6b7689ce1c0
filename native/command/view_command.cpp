/// gnomon view: the window.
#include "native/command/commands.h"
#include "native/window/window_host.h"

#include <memory>

namespace gnomon {

namespace {

struct ViewOptions {
    Drawing drawing;
    std::string window = "glfw";
    int frames = 0;
};

int view(const ViewOptions& options) {
    Problems problems;
    const auto settings = readSettings(options.drawing, problems);
    if (options.window != "glfw" && options.window != "sdl")
        problems.push_back(wrongOption("window", "'" + options.window + "' is none of glfw|sdl", {}));
    if (!problems.empty()) return fail(kCommandLineWrong, problems);
    auto loaded = load(options.drawing.scene, problems);
    if (!loaded) return fail(kInputWrong, problems);
    if (!poseOf(loaded->scene, *settings, problems)) return fail(kCommandLineWrong, problems);
    ViewTask task{*settings, std::move(*loaded), options.frames};
    return options.window == "glfw" ? viewWithGlfw(std::move(task)) : viewWithSdl(std::move(task));
}

} // namespace

void addView(CLI::App& app, Task& task) {
    auto options = std::make_shared<ViewOptions>();
    auto* command = app.add_subcommand("view", "Opens a window on a scene [lite]");
    addScene(*command, options->drawing.scene, false);
    command->add_option("--window", options->window, "The library that opens the window [glfw]")->type_name("glfw|sdl");
    command->add_option("--frames", options->frames, "Ends after so many pictures")
        ->type_name("N")
        ->check(CLI::Range(1, 1'000'000'000));
    addSettings(*command, options->drawing);
    command->footer(
        "W A S D move, Shift halves the speed, a drag looks around, the wheel goes near and far.\n"
        "F2 panel, F5 reads the scene file again, F12 screenshot, Escape ends. A scene file dropped on the\n"
        "window is opened.");
    command->callback([&task, options] { task = [options] { return view(*options); }; });
}

} // namespace gnomon
