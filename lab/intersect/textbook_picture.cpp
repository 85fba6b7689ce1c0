#include "lab/intersect/textbook_picture.h"

#include "lab/reference/textbook/textbook.h"
#include "native/file/image_file.h"
#include "tracer/render/renderer.h"
#include "tracer/scene/read_scene.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

constexpr int kSide = 240;
constexpr double kDistances[] = {3, 30, 100, 1000};

constexpr const char* kScene = R"({
    "background": {"color": [0.16, 0.19, 0.23]},
    "lights": [{"point": {"position": [-2600, 3600, 2400]}}],
    "materials": {"clay": {"ambient": 0.12, "diffuse": [0.8, 0.42, 0.25], "specular": 0.35, "shininess": 60}},
    "objects": [{"torus": {"center": [0, 0, 0], "axis": [0.25, 0.8, 0.5], "major_radius": 1, "minor_radius": 0.4},
                 "material": "clay"}]})";

/// The torus from `distance`, with a lens that lets it fill the picture.
Image draw(Scene scene, double distance, std::span<const ShaderFile> overrides, Problems& problems) {
    scene.camera.eye = {0, 0, distance};
    scene.camera.target = {0, 0, 0};
    scene.camera.fov = glm::degrees(2 * std::asin(1.45 / distance));
    Renderer renderer(overrides);
    renderer.setScene(scene, problems);
    Settings settings;
    settings.size = {kSide, kSide};
    renderer.configure(settings);
    if (!renderer.finish(problems)) return {};
    return renderer.readPicture({scene.camera, 0, kSide, kSide}, problems);
}

void paste(const Image& part, int left, int top, Image& whole) {
    for (int y = 0; y < part.height; ++y)
        std::copy_n(&part.rgba[std::size_t(y) * part.width * 4], part.width * 4,
                    &whole.rgba[(std::size_t(top + y) * whole.width + left) * 4]);
}

} // namespace

bool writeTextbookPicture(const std::string& file, Problems& problems) {
    const auto scene = readScene(kScene, "textbook picture", problems);
    if (!scene) return false;
    Image whole;
    whole.width = kSide * int(std::size(kDistances));
    whole.height = kSide * 2;
    whole.rgba.resize(std::size_t(whole.width) * whole.height * 4);
    for (std::size_t i = 0; i < std::size(kDistances); ++i)
        for (const bool ours : {false, true}) {
            const auto overrides = ours ? std::span<const ShaderFile>{} : textbookShaders();
            const Image part = draw(*scene, kDistances[i], overrides, problems);
            if (!problems.empty()) return false;
            paste(part, int(i) * kSide, ours ? kSide : 0, whole);
        }
    return writeImage(file, whole, problems);
}

} // namespace gnomon
