#include "lab/shadows/shadow_pictures.h"

#include "native/file/image_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace gnomon {
namespace {

constexpr double kBase = 1.0 / 30;
constexpr int kMagnified = 4;
constexpr int kReference = 100; ///< samples: one picture of eight bits

Image pictureOf(const Loaded& loaded, const ShadowPlan& plan, const ShadowWay& way, Problems& problems) {
    Settings settings = settingsFor(plan, way, plan.radii.empty() ? std::nullopt : std::optional(plan.radii[0]));
    BenchmarkCase benchmarkCase(loaded.scene, loaded.images, settings, {}, problems);
    if (!problems.empty()) return {};
    return benchmarkCase.picture(settings, {plan.camera.value_or(loaded.scene.camera), 0, plan.size.x, plan.size.y},
                                 problems);
}

/// Model, reference and their difference, side by side.
Image triptych(const Image& model, const Image& reference) {
    Image all{3 * model.width, model.height, std::vector<std::uint8_t>(3 * model.rgba.size(), 255)};
    for (int y = 0; y < model.height; ++y)
        for (int x = 0; x < model.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const std::size_t from = (std::size_t(y) * model.width + x) * 4 + std::size_t(c);
                const auto to = [&](int panel) -> std::uint8_t& {
                    return all
                        .rgba[(std::size_t(y) * all.width + std::size_t(panel * model.width + x)) * 4 + std::size_t(c)];
                };
                to(0) = model.rgba[from];
                to(1) = reference.rgba[from];
                to(2) = std::uint8_t(std::min(kMagnified * std::abs(model.rgba[from] - reference.rgba[from]), 255));
            }
    return all;
}

} // namespace

bool writePictures(const std::string& folder, const Loaded& loaded, const ShadowPlan& plan, Problems& problems) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        problems.push_back(
            {folder, 0, {}, "cannot be made: " + error.message(), "choose a folder that may be written to"});
        return false;
    }
    const Image reference =
        pictureOf(loaded, plan, {ShadowModel::Montecarlo, ConeOrigin::Surface, kBase, kReference}, problems);
    const auto nearest = std::min_element(plan.epsilons.begin(), plan.epsilons.end(),
                                          [](double a, double b) { return std::abs(a - kBase) < std::abs(b - kBase); });
    for (const ShadowModel model : plan.models) {
        if (model == ShadowModel::Montecarlo || nearest == plan.epsilons.end()) continue;
        const Image image = pictureOf(loaded, plan, {model, ConeOrigin::Surface, *nearest}, problems);
        const auto file =
            std::filesystem::path(folder) / (loaded.scene.name + "-" + std::string(shadowRow(model).key) + ".png");
        if (!problems.empty() || !writeImage(file.string(), triptych(image, reference), problems)) return false;
    }
    return true;
}

} // namespace gnomon
