#include "lab/batch/ray_batch.h"

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

void upload(Batch& batch, std::span<const BatchRay> rays) {
    std::array<std::vector<glm::vec4>, 2> inputs; // origins, directions
    for (const BatchRay& ray : rays) {
        inputs[0].emplace_back(ray.origin, ray.side);
        inputs[1].emplace_back(ray.direction, ray.tMin);
    }
    batch.upload(inputs);
}

double secondsOf(Batch& batch, std::span<const BatchRay> rays, int repeats, double (*clock)()) {
    upload(batch, rays);
    batch.draw(); // once before: some drivers compile and upload at the first draw
    batch.wait();
    const double start = clock();
    batch.draw(repeats);
    batch.wait();
    return clock() - start;
}

} // namespace

RayBatch::RayBatch(const Scene& scene, Problems& problems, std::span<const ShaderFile> overrides)
    : RayBatch(scene, {}, 0, problems, overrides) {}

RayBatch::RayBatch(const Scene& scene, const Settings& settings, float pixelAngle, Problems& problems,
                   std::span<const ShaderFile> overrides)
    : batch_(Batch::make({"pass/intersect.frag", {"rayOrigins", "rayDirections"}, 3, false, settings, pixelAngle},
                         scene, problems, overrides)) {}

std::vector<BatchHit> RayBatch::trace(std::span<const BatchRay> rays) {
    std::vector<BatchHit> hits;
    hits.reserve(rays.size());
    for (std::size_t from = 0; from < rays.size(); from += Batch::kMost) {
        upload(*batch_, rays.subspan(from, std::min(Batch::kMost, rays.size() - from)));
        batch_->draw();
        const auto hit = batch_->read(0), point = batch_->read(1), normal = batch_->read(2);
        for (std::size_t i = 0; i < hit.size(); ++i)
            hits.push_back({int(hit[i].y), hit[i].x, glm::vec3(point[i]), glm::vec3(normal[i])});
    }
    return hits;
}

double RayBatch::seconds(std::span<const BatchRay> rays, int repeats, double (*clock)()) {
    double sum = 0;
    for (std::size_t from = 0; from < rays.size(); from += Batch::kMost)
        sum += secondsOf(*batch_, rays.subspan(from, std::min(Batch::kMost, rays.size() - from)), repeats, clock);
    return sum;
}

} // namespace gnomon
