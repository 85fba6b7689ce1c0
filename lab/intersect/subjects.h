/// The shapes and the rays that intersectors are tried with.
#pragma once

#include "lab/batch/ray_batch.h"
#include "lab/reference/exact/exact_hit.h"
#include "tracer/scene/scene.h"

#include <array>
#include <cstdint>
#include <iosfwd>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::oracle {

/// A shape of about unit size. Those about an axis have it along z, in the middle of the world.
struct Subject {
    std::string_view shape, proportion; ///< proportion: thin, fat, or empty where there is but one
    Shape geometry;

    std::string name() const { return std::string(shape) + std::string(proportion); }
    std::string title() const {
        return proportion.empty() ? std::string(shape) : std::string(shape) + ", " + std::string(proportion);
    }
};
std::ostream& operator<<(std::ostream&, const Subject&);
const std::vector<Subject>& subjects();
/// The same of height patches, which have no textbook's formula, no solid and no outline: gentle, and of the source's
/// random recipe, four times as high as wide.
const std::vector<Subject>& patches();

/// Nothing but these, as RayBatch takes it.
Scene sceneOf(const std::vector<Shape>&);

enum class RayClass {
    Uniform, ///< from `distance` away towards the bounding sphere
    Grazing, ///< tangent to the surface, or past the rim of a flat shape, but for 1e-8 … 1e-2 of the size
    Tangent, ///< along a world axis but for a tiny slant, 2^-27 … 2^-16 of the size from a silhouette: as near as
             ///< float32 goes
    Hole,    ///< a torus' hole: through it, or onto its inner wall
    Inside,  ///< from inside; the shape as a whole is `distance` away from the world's origin
    Axis,    ///< coordinates and direction components that are 0 or the shape's own measures
};
inline constexpr std::array<RayClass, 6> kRayClasses{RayClass::Uniform, RayClass::Grazing, RayClass::Tangent,
                                                     RayClass::Hole,    RayClass::Inside,  RayClass::Axis};
std::string_view nameOf(RayClass);
bool fits(RayClass, const Subject&);
/// The fraction of a class's rays that have to be so far from tangency that float32 must decide them rightly, at least.
/// The others are near it on purpose, or are put there by the rounding of what lies far from the world's origin.
double leastDecided(RayClass, ShapeKind, double distance);

/// The subject where the class wants it: turned and moved off the origin, or upright in it, or far away.
Shape placed(const Subject&, RayClass, double distance);

/// An endless, reproducible stream of rays about one placed shape. `distance` counts sizes of the shape.
class RayStream {
  public:
    RayStream(const Shape& placed, RayClass, double distance, std::uint64_t seed);
    BatchRay next();
    /// From `distance` away towards a point of the surface, so that thin shapes are met, too.
    BatchRay towardsSurface();

    /// In [low, high).
    double number(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
    Vec3<double> direction();
    struct Spot {
        Vec3<double> point, normal;
    };
    /// Somewhere on the surface; on the rim of a flat shape.
    Spot surface();
    /// Somewhere on a patch's rim, its normal away from the patch.
    Spot rim();

  private:
    Vec3<double> acrossTo(const Vec3<double>& normal);
    BatchRay from(const Vec3<double>& origin, const Vec3<double>& along) const;
    BatchRay towards(const Vec3<double>& origin, const Vec3<double>& target) const;
    BatchRay nudged(const BatchRay&, const Spot& wanted);
    BatchRay uniform();
    BatchRay grazing();
    BatchRay tangent();
    BatchRay hole();
    BatchRay inside();
    BatchRay axis();
    bool meets(const BatchRay&) const;
    BatchRay alongAxis(const Vec3<double>& through, const Vec3<double>& slant) const;
    void findSilhouette();

    ExactShape<double> shape_;
    std::vector<double> measures_; ///< numbers of the shape, as coordinates for Axis
    RayClass kind_;
    double far_;
    std::mt19937_64 random_;
    int view_ = 2;      ///< the world axis Tangent looks along
    double facing_ = 1; ///< and which way
    int left_ = 0;      ///< rays to be had from the silhouette
    Vec3<double> silhouette_, outward_;
};

} // namespace gnomon::oracle
