/// Many given surface points and lights in a scene, answered by the shader's own shadow model and read back: how soft
/// shadows are measured.
#pragma once

#include "lab/batch/batch.h"
#include "tracer/clock.h"

namespace gnomon {

struct BatchLit {
    glm::vec3 point{0};
    float width = 0; ///< what a pixel covers there
    glm::vec3 normal{0, 0, 1};
    int object = -1; ///< whose surface it is, in the shader's order
    glm::vec3 light{0};
    float radius = 0; ///< of the light
};

struct BatchShade {
    float visibility = 1;
    int evaluations = 0; ///< of distances
};

class LightBatch {
  public:
    /// As RayBatch, for the shadow model of the settings and with its numbers.
    LightBatch(Scene, Settings, Problems&, std::span<const ShaderFile> overrides = {});
    bool valid() const { return batch_ != nullptr; }

    /// One answer a point, in order.
    std::vector<BatchShade> shade(std::span<const BatchLit>);

    /// Seconds that asking for every point `repeats` times takes, without compiling, upload or read-back.
    double seconds(std::span<const BatchLit>, int repeats, double (*clock)() = monotonicSeconds);

  private:
    void upload(std::span<const BatchLit>);
    std::unique_ptr<Batch> batch_;
};

} // namespace gnomon
