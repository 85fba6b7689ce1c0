/// A scene with its numbers and images on the GPU. Scenes that follow one another share nothing: the old one draws on until the new
/// one's programs are ready.
#pragma once

#include "tracer/plan/scene_packer.h"
#include "tracer/render/scene_images.h"
#include "tracer/render/scene_numbers.h"
#include "tracer/render/view.h"

namespace gnomon {

class GpuScene {
  public:
    GpuScene(const Scene&, int maxTextureSize);

    const Scene& scene() const { return scene_; }
    glm::dvec3 origin() const { return origin_; } ///< originOf(scene)
    SceneImages& images() { return images_; }
    const SceneImages& images() const { return images_; }

    /// Brings all to the GPU that programs of these features read for the view, and binds it.
    void upload(const Features&, const View&, const Pictures&, Problems&);
    /// What eye rays may meet of what was uploaded last.
    std::vector<ScreenBounds> screenBounds(const Features& features) const { return packer_.screenBounds(features); }

  private:
    Scene scene_;
    glm::dvec3 origin_;
    ScenePacker packer_;
    SceneImages images_;
    SceneNumbers numbers_;
};

} // namespace gnomon
