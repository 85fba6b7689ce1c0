#include "lab/batch/distance_batch.h"

#include <algorithm>
#include <array>

namespace gnomon {

DistanceBatch::DistanceBatch(const Scene& scene, Problems& problems, std::span<const ShaderFile> overrides)
    : batch_(Batch::make({"pass/distance.frag", {"points", "viewpoints"}, 3, true}, scene, problems, overrides)) {}

std::vector<BatchDistance> DistanceBatch::measure(std::span<const BatchPoint> points) {
    std::vector<BatchDistance> answers;
    answers.reserve(points.size());
    for (std::size_t start = 0; start < points.size(); start += Batch::kMost) {
        std::array<std::vector<glm::vec4>, 2> inputs;
        for (const BatchPoint& point : points.subspan(start, std::min(Batch::kMost, points.size() - start))) {
            inputs[0].emplace_back(point.p, 0.0f);
            inputs[1].emplace_back(point.from, 0.0f);
        }
        batch_->upload(inputs);
        batch_->draw();
        const auto nearest = batch_->read(0), casters = batch_->read(1), object = batch_->read(2);
        for (std::size_t i = 0; i < nearest.size(); ++i)
            answers.push_back({int(object[i].x), glm::vec3(nearest[i]), nearest[i].w, casters[i]});
    }
    return answers;
}

} // namespace gnomon
