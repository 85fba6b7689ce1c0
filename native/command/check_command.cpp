/// gnomon check: is this scene file right?
#include "native/command/commands.h"
#include "tracer/printable.h"

#include <cstdio>
#include <memory>

namespace gnomon {

namespace {

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

int check(const std::string& name) {
    Problems problems;
    const auto loaded = load(name, problems);
    if (!loaded) return fail(kInputWrong, problems);
    note(loaded->notes);
    const Scene& scene = loaded->scene;
    std::printf("%s: right (%s, %s, %s, %s)\n", printable(scene.name).c_str(),
                counted(scene.objects.size(), "object").c_str(), counted(scene.lights.size(), "light").c_str(),
                counted(scene.materials.size(), "material").c_str(), counted(loaded->images.size(), "image").c_str());
    return kDone;
}

} // namespace

void addCheck(CLI::App& app, Task& task) {
    auto scene = std::make_shared<std::string>();
    auto* command = app.add_subcommand("check", "Says whether a scene file is right, and every problem it has");
    addScene(*command, *scene, true);
    command->callback([&task, scene] { task = [scene] { return check(*scene); }; });
}

} // namespace gnomon
