/// A scene with its numbers and images on the GPU. Scenes that follow one another share nothing: the old one draws on
/// until the new one's programs are ready.
#pragma once

#include "tracer/plan/scene_packer.h"
#include "tracer/render/scene_fields.h"
#include "tracer/render/scene_images.h"
#include "tracer/render/scene_numbers.h"
#include "tracer/render/view.h"

namespace gnomon {

class GpuScene {
  public:
    GpuScene(PreparedScenePtr, int maxTextureSize);

    const PreparedScene& prepared() const { return *prepared_; }
    SceneImages& images() { return images_; }
    const SceneImages& images() const { return images_; }
    SceneFields& fields() { return fields_; }
    const SceneFields& fields() const { return fields_; }

    /// Bakes fields on; true where new ones are drawn with from here on.
    bool bake(ProgramCache&, const CodegenTarget&, Problems&);

    /// Brings all to the GPU that programs of this plan read for the view, and binds it.
    void upload(const Plan&, const View&, Pictures&, Problems&);
    /// Every object's shape as it was uploaded last, relative to the origin.
    const std::vector<Shape>& shapes() const { return packer_.shapes(); }

  private:
    PreparedScenePtr prepared_;
    ScenePacker packer_;
    SceneImages images_;
    SceneFields fields_;
    SceneNumbers numbers_;
};

} // namespace gnomon
