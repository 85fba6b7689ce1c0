#include "tracer/render/gpu_scene.h"

namespace gnomon {

GpuScene::GpuScene(const Scene& scene, int maxTextureSize)
    : scene_(scene), origin_(originOf(scene)), packer_(scene, origin_), images_(scene, maxTextureSize) {}

void GpuScene::upload(const Features& features, const View& view, const Pictures& pictures, Problems& problems) {
    if (auto tiles = images_.bind(pictures, problems)) packer_.setTiles(std::move(*tiles)); // before they are packed
    numbers_.upload(packer_.pack(features, view.time, view.camera.eye), features.dataBlock);
}

} // namespace gnomon
