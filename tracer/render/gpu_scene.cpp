#include "tracer/render/gpu_scene.h"

#include <utility>

namespace gnomon {

GpuScene::GpuScene(PreparedScenePtr prepared, int maxTextureSize)
    : prepared_(std::move(prepared)), packer_(prepared_), images_(prepared_, maxTextureSize) {}

void GpuScene::upload(const Plan& plan, const View& view, Pictures& pictures, Problems& problems) {
    if (auto tiles = images_.bind(pictures, problems)) packer_.setTiles(std::move(*tiles)); // before they are packed
    numbers_.upload(packer_.pack(plan, view.time, view.camera.eye), plan.scene.dataBlock);
}

} // namespace gnomon
