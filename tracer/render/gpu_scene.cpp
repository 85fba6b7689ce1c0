#include "tracer/render/gpu_scene.h"

#include <utility>

namespace gnomon {

GpuScene::GpuScene(PreparedScenePtr prepared, int maxTextureSize)
    : prepared_(std::move(prepared)), packer_(prepared_), images_(prepared_, maxTextureSize), fields_(prepared_) {}

bool GpuScene::bake(ProgramCache& cache, const CodegenTarget& target, Problems& problems) {
    auto layout = fields_.step(cache, target, problems);
    if (layout) packer_.setFields(std::move(*layout));
    return layout.has_value();
}

void GpuScene::upload(const Plan& plan, const View& view, Pictures& pictures, Problems& problems) {
    if (auto tiles = images_.bind(pictures, problems)) packer_.setTiles(std::move(*tiles)); // before they are packed
    if (plan.scene.fields) fields_.bind();
    numbers_.upload(packer_.pack(plan, view.time, view.camera.eye), plan.scene.dataBlock);
}

} // namespace gnomon
