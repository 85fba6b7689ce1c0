/// gnomon render: one picture, or one output as numbers, to a file.
#include "native/command/commands.h"
#include "native/context/context.h"
#include "native/file/image_file.h"
#include "native/file/output_file.h"
#include "tracer/printable.h"
#include "tracer/render/renderer.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <utility>

namespace gnomon {

namespace {

struct RenderOptions {
    Drawing drawing;
    std::string file, format;
    std::string context = "osmesa";
};

/// What is wrong with the scene's own file is the input's fault, all else the GL's.
ExitCode whyNotDrawn(const Problems& problems, const Scene& scene) {
    const auto ofScene = [&](const Problem& problem) { return !scene.file.empty() && problem.file == scene.file; };
    return !problems.empty() && std::ranges::all_of(problems, ofScene) ? kInputWrong : kNoGl;
}

/// Draws with a renderer of the current context and writes the file: a picture as a window shows it, or the numbers.
ExitCode draw(Loaded& loaded, const Settings& settings, const CameraPose& pose, const std::string& file,
              ImageFormat format, Problems& problems) {
    Renderer renderer;
    if (!renderer.setScene(loaded.scene, problems)) return kInputWrong;
    renderer.useImagesOnce();
    for (auto& [name, image] : loaded.images) renderer.setImage(name, std::move(image));
    renderer.configure(settings);
    const View view{pose, settings.time, settings.size.x, settings.size.y};
    if (!renderer.finish(problems)) return whyNotDrawn(problems, loaded.scene);
    bool written = false;
    if (format == ImageFormat::Png) {
        const Image picture = renderer.readPicture(view, problems);
        if (!problems.empty()) return whyNotDrawn(problems, loaded.scene);
        written = writeImage(file, picture, problems);
    } else {
        const FloatImage values = renderer.readOutput(view, problems);
        if (!problems.empty()) return whyNotDrawn(problems, loaded.scene);
        written = writeImage(file, format, values, problems);
    }
    if (const std::string cut = renderer.depthCut(view); written && !cut.empty())
        std::fprintf(stderr, "gnomon: note: %s\n", cut.c_str());
    return written ? kDone : kInputWrong;
}

int render(const RenderOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    Problems problems;
    const auto settings = readSettings(options.drawing, problems);
    const auto kind = contextNamed(options.context);
    if (!kind) problems.push_back(wrongOption("context", "'" + options.context + "' is none of osmesa|egl|window", {}));
    const auto format = checkImageFile(options.file, options.format, settings.value_or(Settings{}).aov, problems);
    if (!problems.empty()) return fail(kCommandLineWrong, problems);

    auto loaded = load(options.drawing.scene, problems);
    if (!loaded) return fail(kInputWrong, problems);
    if (!sparesInputs(options.file, problems)) return fail(kCommandLineWrong, problems);
    note(loaded->notes);
    const auto pose = poseOf(loaded->scene, *settings, problems);
    if (!pose) return fail(kCommandLineWrong, problems);

    const auto context = makeContext(*kind, problems);
    if (!context) return fail(kNoGl, problems);
    const ExitCode code = draw(*loaded, *settings, *pose, options.file, *format, problems);
    if (code != kDone) return fail(code, problems);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%s: %s, %d x %d, %.2f s\n", printable(options.file).c_str(), printable(loaded->scene.name).c_str(),
                settings->size.x, settings->size.y, seconds.count());
    return kDone;
}

} // namespace

void addRender(CLI::App& app, Task& task) {
    auto options = std::make_shared<RenderOptions>();
    auto* command = app.add_subcommand("render", "Draws one picture into a file; needs no display");
    addScene(*command, options->drawing.scene, true);
    command
        ->add_option("-o,--output", options->file,
                     "The file: .png (8 bit), .pfm or .exr (32-bit float); - is standard output")
        ->type_name("FILE")
        ->required();
    command->add_option("--format", options->format, "Whatever the file's name ends with [png for -]")
        ->type_name("png|pfm|exr");
    command->add_option("--context", options->context, "Where GL comes from [osmesa]")->type_name("osmesa|egl|window");
    addSettings(*command, options->drawing);
    command->callback([&task, options] { task = [options] { return render(*options); }; });
}

} // namespace gnomon
