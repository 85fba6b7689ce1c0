/// gnomon shader: the GLSL that a scene and settings are drawn with.
#include "native/command/commands.h"
#include "native/context/context.h"
#include "tracer/render/renderer.h"
#include "tracer/shader/shader_builder.h"
#include "tracer/software/tuning.h"
#include "tracer/software/uncommon_features.h"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace gnomon {

namespace {

struct ShaderOptions {
    Drawing drawing;
    std::string pass = "trace", glsl = "es300";
    bool processor = false, swiftShader = false, stats = false;
};

/// Milliseconds from the source to the first picture, with OSMesa.
std::optional<double> compileMs(const Scene& scene, const Settings& settings, Problems& problems) {
    const auto context = makeContext(ContextKind::OsMesa, problems);
    if (!context) return std::nullopt;
    Renderer renderer;
    if (!renderer.setScene(scene, problems)) return std::nullopt;
    renderer.configure(settings);
    if (!renderer.finish(problems)) return std::nullopt;
    renderer.readOutput({scene.camera, 0, 1, 1}, problems);
    return problems.empty() ? std::optional(renderer.stats().compileMs) : std::nullopt;
}

int printStats(const ShaderSource& source, const Scene& scene, const Settings& settings) {
    std::printf("bytes    %zu\nlines    %zu\nmodules  %zu\n", source.text.size(), source.lines.size(),
                source.modules.size());
    for (const auto module : source.modules) std::printf("  %.*s\n", int(module.size()), module.data());
    Problems problems;
    const auto milliseconds = compileMs(scene, settings, problems);
    if (!milliseconds) return fail(kNoGl, problems);
    std::printf("compile  %.1f ms (OSMesa)\n", *milliseconds);
    return kDone;
}

void checkChoice(const char* option, const std::string& value, const std::vector<std::string_view>& names,
                 Problems& problems) {
    if (std::find(names.begin(), names.end(), value) != names.end()) return;
    std::string all;
    for (const auto name : names) all.append(all.empty() ? "" : "|").append(name);
    problems.push_back(wrongOption(option, "'" + value + "' is none of " + all, {}));
}

ShaderSource sourceOf(const std::string& pass, const Plan& plan, Problems& problems) {
    if (pass == "canvas") return buildCanvas(plan, problems);
    if (pass == "sky") return buildShader("pass/sky.frag", skyOf(plan), problems);
    return buildShader("pass/trace.frag", pass == "base" ? baseOf(plan) : plan, problems);
}

int shader(const ShaderOptions& options) {
    Problems problems;
    const auto settings = readSettings(options.drawing, problems);
    checkChoice("pass", options.pass, {"trace", "base", "sky", "canvas"}, problems);
    checkChoice("glsl", options.glsl, {"es300", "gl330"}, problems);
    if (!problems.empty()) return fail(kCommandLineWrong, problems);
    const auto assets = AssetFolder::find(problems);
    const auto scene = assets ? assets->readScene(options.drawing.scene, problems) : std::nullopt;
    if (!scene) return fail(kInputWrong, problems);

    const Rasteriser rasteriser = options.swiftShader ? Rasteriser::SwiftShader
                                  : options.processor ? Rasteriser::Llvmpipe
                                                      : Rasteriser::Gpu;
    const CodegenTarget target = tunedFor(rasteriser, 64, {.es300 = options.glsl == "es300"});
    const Plan plan = splitPlanOf(*prepare(*scene), *settings, target);
    const ShaderSource source = sourceOf(options.pass, plan, problems);
    if (!problems.empty()) return fail(kInputWrong, problems);
    if (options.stats) return printStats(source, *scene, *settings);
    std::fwrite(source.text.data(), 1, source.text.size(), stdout);
    return kDone;
}

} // namespace

void addShader(CLI::App& app, Task& task) {
    auto options = std::make_shared<ShaderOptions>();
    auto* command =
        app.add_subcommand("shader", "Prints the exact GLSL a scene and settings are drawn with; needs no GL");
    addScene(*command, options->drawing.scene, true);
    command
        ->add_option("--pass", options->pass,
                     "Fragment shader, its base variant, that of the sky, or vertex shader [trace]")
        ->type_name("trace|base|sky|canvas")
        ->transform([](std::string pass) { return pass == "usual" ? std::string("base") : pass; }); // its earlier name
    command->add_option("--glsl", options->glsl, "GLSL ES 3.00 or GLSL 3.30 [es300]")->type_name("es300|gl330");
    command->add_flag("--processor", options->processor, "As for a software rasteriser");
    command->add_flag("--swiftshader", options->swiftShader, "As for SwiftShader, Chromium's software rasteriser");
    command->add_flag("--stats", options->stats, "Its size, its modules and its compile time with OSMesa instead");
    addSettings(*command, options->drawing);
    command->callback([&task, options] { task = [options] { return shader(*options); }; });
}

} // namespace gnomon
