/// Many given points in a scene, answered by the shader's own distances and read back: how their numbers are measured.
#pragma once

#include "lab/batch/batch.h"

namespace gnomon {

struct BatchPoint {
    glm::vec3 p{0};
    glm::vec3 from{0}; ///< the side of a plane where this is lies outside
};

struct BatchDistance {
    int object = -1; ///< the nearest in the shader's order; of several as near the first
    glm::vec3 gradient{0};
    float distance = 0;
    glm::vec4 casters{0}; ///< gradient and distance of the nearest object that casts shadows: sceneDistance()
};

class DistanceBatch {
  public:
    /// As RayBatch, for the distances of the scene's shapes.
    DistanceBatch(const Scene&, Problems&, std::span<const ShaderFile> overrides = {});
    bool valid() const { return batch_ != nullptr; }

    /// One answer a point, in order.
    std::vector<BatchDistance> measure(std::span<const BatchPoint>);

  private:
    std::unique_ptr<Batch> batch_;
};

} // namespace gnomon
