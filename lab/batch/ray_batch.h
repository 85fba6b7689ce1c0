/// Many given rays against a scene, answered by the shader's own intersectors and read back: how their numbers are
/// measured.
#pragma once

#include "lab/batch/batch.h"
#include "tracer/clock.h"

namespace gnomon {

struct BatchRay {
    glm::vec3 origin{0};
    float side = 0; ///< 1 + i: starts on object i, in the shader's order, and travels outside of it; −1 − i: inside
    glm::vec3 direction{0, 0, 1}; ///< unit
    float tMin = 0;               ///< hits nearer than that are rounding of the start; < 0: as rayFrom() tells it

    int self() const { return int(side < 0 ? -side : side) - 1; } ///< the object that it starts on, −1: none
};

struct BatchHit {
    int object = -1; ///< in the shader's order, −1: nothing
    float t = 0;
    glm::vec3 point{0}, normal{0};
};

class RayBatch {
  public:
    /// Compiles the intersectors of the scene's shapes in the current context. valid() is false, with problems, where
    /// that fails or the context cannot draw float32.
    /// `overrides` take the place of shader files of the same name, as for buildShader().
    RayBatch(const Scene&, Problems&, std::span<const ShaderFile> overrides = {});
    /// For the settings' search, march and time, with cones of that angle.
    RayBatch(const Scene&, const Settings&, float pixelAngle, Problems&, std::span<const ShaderFile> overrides = {});
    bool valid() const { return batch_ != nullptr; }

    /// As Batch::setScene().
    bool setScene(const Scene& scene, Problems& problems) { return batch_->setScene(scene, problems); }

    /// One answer a ray, in order.
    std::vector<BatchHit> trace(std::span<const BatchRay>);

    /// Seconds that intersecting every ray `repeats` times takes from asking the GPU to its answer, without compiling,
    /// upload or read-back. `clock` counts seconds: for a GL in software the CPU time of the process says more on a
    /// busy machine.
    double seconds(std::span<const BatchRay>, int repeats, double (*clock)() = monotonicSeconds);

  private:
    std::unique_ptr<Batch> batch_;
};

} // namespace gnomon
