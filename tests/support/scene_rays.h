/// Rays through a whole scene: as cameras anywhere have them, as near to a shape's edge as float32 goes, and those that
/// leave what such rays have met.
#pragma once

#include "lab/intersect/compare_scene_hit.h"
#include "lab/intersect/subjects.h"
#include "tests/support/clouds.h"

#include <vector>

namespace gnomon::test {

class SceneRays {
  public:
    SceneRays(const Scene&, const oracle::SceneOracle&, std::uint64_t seed);

    std::vector<BatchRay> primary(int count);
    /// One from each hit: mirrored, bent, back towards a light, or anywhere, on either side.
    std::vector<BatchRay> secondary(const std::vector<BatchRay>&, const std::vector<BatchHit>&);

  private:
    struct Ball {
        glm::dvec3 center;
        double radius;
    };
    Ball ballOf(int object) const;
    int anyObject();
    glm::dvec3 direction();
    BatchRay towards(glm::dvec3 from, glm::dvec3 to) const;
    /// Of one camera: `count` of them through a cone as wide as its field of view.
    void addView(std::vector<BatchRay>&, int count);
    /// About one object, in each way that its own intersector is tested.
    void addAbout(std::vector<BatchRay>&, int count);
    void addBetween(std::vector<BatchRay>&, int count);

    const Scene& scene_;
    const oracle::SceneOracle& oracle_;
    Dice dice_;
};

} // namespace gnomon::test
