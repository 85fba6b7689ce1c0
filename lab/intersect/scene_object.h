/// One object of a whole scene, and between where and where a ray meets it at the latest.
#pragma once

#include "lab/intersect/compare_hit.h"
#include "lab/reference/exact/solid_passage.h"
#include "tracer/scene/scene.h"

#include <memory>
#include <optional>

namespace gnomon::oracle {

/// What a ray owes to one object, in t.
struct Meeting {
    static constexpr double kNever = Passage::kNever;

    double from = kNever; ///< no nearer than that is it met
    double by = kNever;   ///< and at that it is: the bounds of its kind lie between the two
    bool decided = true;  ///< else float32 may see it otherwise: near tangency, or started in the band
    ExactHit<double> exact{};
    Line<double> line{};

    bool none() const { return decided && by == kNever; }
};

/// How far an answer is from the exact one, in the measures of Bounds; of a large sphere in fractions of what it may.
struct HitErrors {
    bool elsewhere = false;
    double ray = 0, point = 0, normal = 0;
};

/// What a ray starts with. `clear`: it starts on the object.
struct RayStart {
    double tMin = 0;
    float side = 0;
};

class ExactObject {
  public:
    virtual ~ExactObject() = default;
    virtual Meeting meeting(const BatchRay&, const RayStart&) const = 0;
    virtual HitErrors errors(const Meeting&, const BatchHit&) const = 0;

    /// The ray may come near it: by its ball, with room.
    bool near(const BatchRay&) const;
    /// By kind: what it is drawn as.
    ShapeKind kind() const { return kind_; }
    Bounds bounds() const { return bounds_; }

  protected:
    ExactObject(ShapeKind kind, Bounds bounds) : kind_(kind), bounds_(bounds) {}
    /// Where the ray comes into the ball; where it starts, if that is later, or there is no ball.
    double entry(const BatchRay&, double start) const;

    ShapeKind kind_;
    Bounds bounds_;
    glm::dvec3 center_{0};
    double radius_ = Meeting::kNever;
};

/// A shape as the shader draws it, of kind `drawn`. `extent`: of all triangles together. `eye`: from where large
/// spheres are told.
std::unique_ptr<ExactObject> exactObject(const Shape&, ShapeKind drawn, double extent, glm::dvec3 eye);

/// The bounds of a solid: of o + t d and of the surface point in 2^-18 of its bounding sphere's radius, of the normal
/// in degrees.
inline constexpr Bounds kSolidBounds{0x1p-18, 1, 4, 1.2};
/// Of a large sphere, in fractions of what shaders/primitive/large_sphere.glsl states.
inline constexpr Bounds kLargeSphereBounds{0x1p-22, 1, 1, 1};

} // namespace gnomon::oracle
