#include "lab/batch/light_batch.h"

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

/// Shadows are compiled where there is a light.
Scene withLight(Scene scene) {
    if (scene.lights.empty()) scene.lights.emplace_back();
    return scene;
}

BatchPass passFor(Settings settings) {
    settings.aov = Aov::Steps;
    BatchPass pass{"pass/light.frag", {"receivers", "normals", "lights"}};
    pass.settings = settings;
    return pass;
}

} // namespace

LightBatch::LightBatch(Scene scene, Settings settings, Problems& problems, std::span<const ShaderFile> overrides)
    : batch_(Batch::make(passFor(settings), withLight(std::move(scene)), problems, overrides)) {}

void LightBatch::upload(std::span<const BatchLit> points) {
    std::array<std::vector<glm::vec4>, 3> inputs;
    for (const BatchLit& lit : points) {
        inputs[0].emplace_back(lit.point, lit.width);
        inputs[1].emplace_back(lit.normal, float(lit.object));
        inputs[2].emplace_back(lit.light, lit.radius);
    }
    batch_->upload(inputs);
}

std::vector<BatchShade> LightBatch::shade(std::span<const BatchLit> points) {
    std::vector<BatchShade> answers;
    answers.reserve(points.size());
    for (std::size_t start = 0; start < points.size(); start += Batch::kMost) {
        upload(points.subspan(start, std::min(Batch::kMost, points.size() - start)));
        batch_->draw();
        for (const glm::vec4& texel : batch_->read(0)) answers.push_back({texel.x, int(texel.y)});
    }
    return answers;
}

double LightBatch::seconds(std::span<const BatchLit> points, int repeats, double (*clock)()) {
    double sum = 0;
    for (std::size_t start = 0; start < points.size(); start += Batch::kMost) {
        upload(points.subspan(start, std::min(Batch::kMost, points.size() - start)));
        batch_->draw(); // once before: some drivers compile and upload at the first draw
        batch_->wait();
        const double before = clock();
        batch_->draw(repeats);
        batch_->wait();
        sum += clock() - before;
    }
    return sum;
}

} // namespace gnomon
