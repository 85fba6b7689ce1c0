/// Holds the GPU's answer to a ray through a whole scene against the exact one: which object, where, and how exactly.
#pragma once

#include "lab/intersect/scene_object.h"

#include <vector>

namespace gnomon::oracle {

enum class Fault {
    None,
    Missed,    ///< an object that is met before the told one, or where nothing is told
    Invented,  ///< an object that is not met, or not there
    NotFirst,  ///< of equal objects another than the first
    Elsewhere, ///< the right object at the wrong place
    Beyond     ///< t, surface point or normal farther off than the bounds of the kind
};
std::string_view nameOf(Fault);

struct SceneVerdict {
    /// One answer only is right. Else two surfaces are nearer to each other than their bounds, or the ray is in the
    /// band of an object that may come first.
    bool decided = false;
    int object = -1; ///< that answer, in the shader's order; -1: nothing, or not decided
    Fault fault = Fault::None;
    HitErrors errors{}; ///< where an object is rightly met
};

class SceneOracle {
  public:
    /// The scene as it is at `time`, seen from its own camera, in the world's coordinates: as RayBatch has it.
    SceneOracle(const Scene&, double time);

    SceneVerdict compare(const BatchRay&, const BatchHit&) const;

    /// In the shader's order.
    std::size_t objects() const { return objects_.size(); }
    ShapeKind kindOf(int object) const { return objects_[std::size_t(object)]->kind(); }
    /// In the scene; -1 of nothing.
    int fileIndexOf(int object) const { return object < 0 ? -1 : fileIndices_[std::size_t(object)]; }
    const Shape& shapeOf(int object) const { return shapes_[std::size_t(object)]; }
    /// Where the ray meets one object: to tell of what is wrong.
    Meeting meetingWith(int object, const BatchRay&) const;

  private:
    struct Met {
        int object;
        Meeting meeting;
    };
    std::vector<Met> meetings(const BatchRay&) const;
    Fault faultOf(const std::vector<Met>&, const BatchHit&, SceneVerdict&) const;
    /// The shader has the same numbers for both, and the ray meets both at once.
    bool together(const Met& a, const Met& b) const {
        return values_[std::size_t(a.object)] == values_[std::size_t(b.object)] && a.meeting.from <= b.meeting.by &&
               b.meeting.from <= a.meeting.by;
    }

    std::vector<std::unique_ptr<ExactObject>> objects_;
    std::vector<Shape> shapes_;
    std::vector<int> fileIndices_;
    std::vector<std::vector<glm::vec4>> values_;
};

} // namespace gnomon::oracle
