#include "tracer/plan/pose.h"

namespace gnomon {

std::optional<CameraPose> poseOf(const Scene& scene, const Settings& settings, std::string_view source,
                                 Problems& problems) {
    CameraPose pose = scene.camera;
    pose.eye = settings.eye.value_or(pose.eye);
    pose.target = settings.target.value_or(pose.target);
    pose.fov = settings.fov.value_or(pose.fov);
    const std::size_t before = problems.size();
    const auto refuse = [&](const char* key, const std::string& what, const std::string& remedy) {
        problems.push_back({std::string(source), 0, key, what, remedy});
    };
    if (pose.eye == pose.target)
        refuse("eye", "the camera looks at its own position",
               "let " + spelled(source, "eye") + " and " + spelled(source, "target") + " differ");
    const int lights = int(scene.lights.size());
    if (settings.aov == Aov::Visibility && settings.light >= lights)
        refuse("light", scene.name + " has no light " + std::to_string(settings.light),
               lights == 0 ? "choose a scene with lights" : "use 0…" + std::to_string(lights - 1));
    return problems.size() == before ? std::optional(pose) : std::nullopt;
}

} // namespace gnomon
