/// Triangles that share edges and a vertex, and rays through exactly those: a ray that meets none of them has leaked.
#pragma once

#include "lab/batch/ray_batch.h"
#include "tracer/scene/shapes.h"

#include <random>
#include <vector>

namespace gnomon::oracle {

/// Six triangles of about unit size around a vertex.
class Fan {
  public:
    explicit Fan(glm::dvec3 middle);

    const std::vector<Shape>& triangles() const { return triangles_; }
    /// From about `distance` away through an edge, every fourth through the vertex: as exactly as float32 can aim.
    BatchRay next(double distance);

  private:
    double number(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }

    glm::vec3 middle_;
    std::vector<glm::vec3> rim_;
    std::vector<Shape> triangles_;
    std::mt19937_64 random_{3};
    int asked_ = 0;
};

} // namespace gnomon::oracle
