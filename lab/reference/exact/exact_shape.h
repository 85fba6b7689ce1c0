/// A shape as geometry: its exact distance about its own middle.
///
/// It knows nothing of rays and shares no formula with the shader's intersectors. R is double for millions of rays (the
/// coordinates are those of the shape's own size, so 1e-16 of it is lost), or any wider type.
#pragma once

#include "lab/reference/exact/ellipsoid.h"
#include "lab/reference/exact/patch_surface.h"
#include "lab/reference/exact/vec3.h"
#include "tracer/scene/shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string_view>
#include <type_traits>

namespace gnomon::oracle {

/// What world coordinates are subtracted in before the rest is R.
template<class R>
using Wide = std::conditional_t<std::is_same_v<R, double>, long double, R>;

/// Which values of a shape are meant: rounded to float32, as the shader gets them, or as the scene has them.
enum class Values { OfTheShader, OfTheScene };

template<class R>
class ExactShape {
  public:
    explicit ExactShape(const Shape& shape, Values values = Values::OfTheShader) : kind_(shape.kind) {
        setFields(values == Values::OfTheShader ? inFloat(shape) : shape);
        size_ = sizeOf();
    }

    ShapeKind kind() const { return kind_; }
    bool closed() const { return !flat() && kind_ != ShapeKind::HeightPatch; }
    /// A ray meets it once.
    bool flat() const { return kind_ == ShapeKind::Plane || kind_ == ShapeKind::Disc || triangle(); }
    bool triangle() const { return kind_ == ShapeKind::Triangle || kind_ == ShapeKind::SmoothTriangle; }
    /// The distance is a convex function of the point.
    bool convex() const { return closed() && kind_ != ShapeKind::Torus; }
    const Vec3<Wide<R>>& middle() const { return middle_; }
    /// Radius of the sphere about the middle that holds the shape; 1 for a plane.
    const R& size() const { return size_; }
    /// Along the torus, the plane's or disc's normal, from `from` to `to`; a triangle's normal; a patch's upwards.
    const Vec3<R>& axis() const { return axis_; }
    const R& radius() const { return radius_; }
    const R& minor() const { return minor_; }
    const Vec3<R>& vertex(int i) const { return vertices_[i]; }
    /// Of a height patch, in its own axes.
    const PatchSurface<R>& patch() const { return *patch_; }
    Vec3<R> alongAxes(const Vec3<R>& p) const { return {dot(p, axes_[0]), dot(p, axes_[1]), dot(p, axes_[2])}; }
    Vec3<R> fromAxes(const Vec3<R>& p) const { return p.x * axes_[0] + p.y * axes_[1] + p.z * axes_[2]; }

    /// Signed distance of a closed shape's surface, negative inside, or of the plane of a flat one; of a patch negative
    /// below it, where that has a meaning. `p` from the middle.
    R distance(const Vec3<R>& p) const {
        switch (kind_) {
        case ShapeKind::Sphere: return length(p) - radius_;
        case ShapeKind::Torus: {
            const R along = dot(p, axis_);
            return hypotenuse(length(p - along * axis_) - radius_, along) - minor_;
        }
        case ShapeKind::Box:
        case ShapeKind::RotatedBox: {
            const Vec3<R> q = alongAxes(p);
            return boxDistance(abs(q.x) - half_.x, abs(q.y) - half_.y, abs(q.z) - half_.z);
        }
        case ShapeKind::Ellipsoid: return ellipsoidDistance(half_, alongAxes(p));
        case ShapeKind::Cylinder: {
            const Profile q = profile(p);
            return boxDistance(q.radial - radius_, abs(q.along) - halfLength_, R(-1e30));
        }
        case ShapeKind::Capsule: {
            const Profile q = profile(p);
            return hypotenuse(q.radial, std::max<R>(abs(q.along) - halfLength_, 0)) - radius_;
        }
        case ShapeKind::Cone: return coneDistance(profile(p));
        case ShapeKind::Plane:
        case ShapeKind::Disc:
        case ShapeKind::Triangle:
        case ShapeKind::SmoothTriangle: return dot(p, axis_);
        case ShapeKind::HeightPatch: return patch_->signedDistance(alongAxes(p));
        case ShapeKind::SpacePatch:  // space_patch_hit.h
        case ShapeKind::LargeSphere: // to its scene it is a sphere
        case ShapeKind::Mandelbulb:  // told by their distance fields only (solid.h)
        case ShapeKind::Solid: break;
        }
        return noAnswer();
    }

    /// The same, but of a disc, triangle or patch as far as its rim, which has no inside: never negative.
    R boundedDistance(const Vec3<R>& p) const {
        if (kind_ == ShapeKind::HeightPatch) return patch_->distance(alongAxes(p));
        if (kind_ == ShapeKind::Disc) {
            const Profile q = profile(p);
            return hypotenuse(q.along, std::max<R>(q.radial - radius_, 0));
        }
        if (!triangle()) return distance(p);
        if (withinRim(p) >= 0) return abs(distance(p));
        R least = R(1e30);
        for (int i = 0; i < 3; ++i) {
            const Vec3<R> along = vertices_[(i + 1) % 3] - vertices_[i], off = p - vertices_[i];
            const R part = std::clamp<R>(dot(off, along) / dot(along, along), 0, 1);
            least = std::min<R>(least, length(off - part * along));
        }
        return least;
    }

    /// No farther than that from the surface: sooner told.
    bool nearSurface(const Vec3<R>& p, const R& most) const {
        if (kind_ == ShapeKind::HeightPatch && patch_->nearAt(alongAxes(p), most)) return true;
        return abs(distance(p)) <= most; // NaN is not
    }

    /// How far a point of a flat shape's plane is inside its rim; a plane has none.
    R withinRim(const Vec3<R>& p) const {
        if (kind_ == ShapeKind::Disc) return radius_ - length(p);
        if (!triangle()) return R(1e30);
        R least = R(1e30);
        for (int i = 0; i < 3; ++i) {
            const Vec3<R> along = unit(vertices_[(i + 1) % 3] - vertices_[i]);
            least = std::min<R>(least, dot(cross(axis_, along), p - vertices_[i]));
        }
        return least;
    }

    /// Unit, outward, by central differences of the distance; of a patch upwards, at the point nearest to p.
    Vec3<R> normal(const Vec3<R>& p) const {
        if (flat()) return axis_;
        if (kind_ == ShapeKind::HeightPatch) return fromAxes(patch_->normal(patch_->nearest(alongAxes(p))));
        const R h = R(1e-7) * size_;
        Vec3<R> g;
        for (int i = 0; i < 3; ++i) {
            Vec3<R> before = p, after = p;
            before[i] -= h;
            after[i] += h;
            g[i] = distance(after) - distance(before);
        }
        return unit(g);
    }

    /// From a point of the surface to the nearest edge or apex, where the normal jumps; through an ellipsoid to where
    /// it is that of the other side.
    R toEdge(const Vec3<R>& p) const {
        if (kind_ == ShapeKind::Box || kind_ == ShapeKind::RotatedBox) {
            const Vec3<R> q = alongAxes(p);
            R away[] = {abs(abs(q.x) - half_.x), abs(abs(q.y) - half_.y), abs(abs(q.z) - half_.z)};
            std::sort(away, away + 3);
            return away[1];
        }
        if (kind_ == ShapeKind::Ellipsoid) return ellipsoidDepth(half_, alongAxes(p));
        const Profile q = profile(p);
        if (kind_ == ShapeKind::Cylinder) return hypotenuse(q.radial - radius_, halfLength_ - abs(q.along));
        if (kind_ != ShapeKind::Cone) return R(1e30);
        return std::min<R>(hypotenuse(q.radial - radius_, q.along + halfLength_),
                           hypotenuse(q.radial, q.along - halfLength_));
    }

    /// The smallest radius of curvature about a point of the surface; of a flat shape its smallest height.
    R bend(const Vec3<R>& p) const {
        switch (kind_) {
        case ShapeKind::Torus: return std::min<R>(minor_, radius_ - minor_);
        case ShapeKind::Cylinder:
        case ShapeKind::Capsule: return radius_;
        case ShapeKind::Cone: {
            const Profile q = profile(p);
            const bool base = toBase(q) <= toSide(q);
            return base ? radius_ : std::min<R>(radius_, q.radial);
        }
        case ShapeKind::Triangle:
        case ShapeKind::SmoothTriangle: {
            const Vec3<R> a = vertices_[1] - vertices_[0], b = vertices_[2] - vertices_[1],
                          c = vertices_[0] - vertices_[2];
            return length(cross(a, b)) / std::max<R>(length(a), std::max<R>(length(b), length(c)));
        }
        case ShapeKind::Sphere:
        case ShapeKind::Plane:
        case ShapeKind::Disc:
        case ShapeKind::Box:
        case ShapeKind::RotatedBox: return size_;
        case ShapeKind::Ellipsoid: return std::min<R>(size_, ellipsoidBend(half_, alongAxes(p)));
        case ShapeKind::HeightPatch: return std::min<R>(size_, patch_->bend(alongAxes(p)));
        case ShapeKind::SpacePatch:
        case ShapeKind::LargeSphere:
        case ShapeKind::Mandelbulb:
        case ShapeKind::Solid: break;
        }
        return noAnswer();
    }

  private:
    void setFields(const Shape& shape) {
        using W = Wide<R>;
        const auto point = [&](std::string_view field) { return Vec3<W>(pointOf(shape, field)); };
        const auto direction = [&](std::string_view field) { return unit(Vec3<R>(point(field))); };
        const auto scalar = [&](std::string_view field) { return R(lengthOf(shape, field)); };
        switch (kind_) {
        case ShapeKind::Sphere:
            middle_ = point("center");
            radius_ = scalar("radius");
            break;
        case ShapeKind::Plane:
            middle_ = point("point");
            axis_ = direction("normal");
            break;
        case ShapeKind::Disc:
            middle_ = point("center");
            axis_ = direction("normal");
            radius_ = scalar("radius");
            break;
        case ShapeKind::Triangle:
        case ShapeKind::SmoothTriangle:
            middle_ =
                (1 / W(3)) * (Vec3<W>(vertexOf(shape, 0)) + Vec3<W>(vertexOf(shape, 1)) + Vec3<W>(vertexOf(shape, 2)));
            for (int i = 0; i < 3; ++i) vertices_[i] = Vec3<R>(Vec3<W>(vertexOf(shape, i)) - middle_);
            axis_ = unit(cross(vertices_[1] - vertices_[0], vertices_[2] - vertices_[0]));
            break;
        case ShapeKind::Torus:
            middle_ = point("center");
            axis_ = direction("axis");
            radius_ = scalar("major_radius");
            minor_ = scalar("minor_radius");
            break;
        case ShapeKind::Box:
            middle_ = point("center");
            half_ = Vec3<R>(point("half_size"));
            break;
        case ShapeKind::RotatedBox:
        case ShapeKind::Ellipsoid:
            middle_ = point("center");
            half_ = Vec3<R>(point(kind_ == ShapeKind::Ellipsoid ? "radii" : "half_size"));
            setAxes(Vec3<R>(point("rotate")));
            break;
        case ShapeKind::Cylinder:
        case ShapeKind::Capsule:
        case ShapeKind::Cone: {
            middle_ = W(0.5) * (point("from") + point("to"));
            const Vec3<R> along = Vec3<R>(point("to") - middle_) - Vec3<R>(point("from") - middle_);
            axis_ = unit(along);
            halfLength_ = length(along) / 2;
            radius_ = scalar("radius");
            break;
        }
        case ShapeKind::HeightPatch:
            middle_ = point("center");
            half_ = R(0.5) * Vec3<R>(point("size"));
            setAxes(Vec3<R>(point("rotate")));
            axis_ = axes_[1];
            patch_ = std::make_shared<PatchSurface<R>>(*shape.heights, R(2) * half_);
            break;
        case ShapeKind::SpacePatch:
        case ShapeKind::LargeSphere:
        case ShapeKind::Mandelbulb:
        case ShapeKind::Solid: noAnswer();
        }
    }

    /// As a unit quaternion applied to each axis: i' = (w² - v²) i + 2 (v i) v + 2 w v x i.
    void setAxes(const Vec3<R>& rodrigues) {
        const R square = dot(rodrigues, rodrigues), w = (1 - square) / (1 + square);
        const Vec3<R> v = (2 / (1 + square)) * rodrigues;
        for (int i = 0; i < 3; ++i) {
            Vec3<R> axis;
            axis[i] = 1;
            axes_[i] = (w * w - dot(v, v)) * axis + (2 * v[i]) * v + (2 * w) * cross(v, axis);
        }
    }

    /// Ends the program: a wrong reference would make every comparison with it worthless.
    R noAnswer() const {
        const std::string_view key = shapeRow(kind_).key;
        std::fprintf(stderr, "gnomon: internal error: the exact reference has no formula for a %.*s\n", int(key.size()),
                     key.data());
        std::abort();
    }

    /// In the half plane of the axis: radial distance, and along the axis from the middle.
    struct Profile {
        R radial, along;
    };

    static R abs(const R& x) { return x < 0 ? -x : x; }
    static R hypotenuse(const R& a, const R& b) {
        using std::sqrt;
        return sqrt(a * a + b * b);
    }
    Profile profile(const Vec3<R>& p) const {
        const R along = dot(p, axis_);
        return {length(p - along * axis_), along};
    }
    static R boxDistance(const R& x, const R& y, const R& z) {
        using std::sqrt;
        const R ox = std::max<R>(x, 0), oy = std::max<R>(y, 0), oz = std::max<R>(z, 0);
        return sqrt(ox * ox + oy * oy + oz * oz) + std::min<R>(std::max<R>(x, std::max<R>(y, z)), 0);
    }
    static R toSegment(const R& x, const R& y, const R& ax, const R& ay, const R& bx, const R& by) {
        const R dx = bx - ax, dy = by - ay;
        const R part = std::clamp<R>(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0, 1);
        return hypotenuse(x - ax - part * dx, y - ay - part * dy);
    }
    R coneDistance(const Profile& q) const {
        const R y = q.along + halfLength_, whole = 2 * halfLength_; // from the base up
        const bool inside = y > 0 && y < whole && q.radial * whole < radius_ * (whole - y);
        const R away = std::min<R>(toBase(q), toSide(q));
        return inside ? R(-away) : away;
    }
    R toBase(const Profile& q) const {
        return toSegment(q.radial, R(q.along + halfLength_), R(0), R(0), radius_, R(0));
    }
    R toSide(const Profile& q) const {
        return toSegment(q.radial, R(q.along + halfLength_), radius_, R(0), R(0), R(2 * halfLength_));
    }
    R sizeOf() const {
        switch (kind_) {
        case ShapeKind::Sphere:
        case ShapeKind::Disc: return radius_;
        case ShapeKind::Torus: return radius_ + minor_;
        case ShapeKind::Box:
        case ShapeKind::RotatedBox:
        case ShapeKind::HeightPatch: return length(half_);
        case ShapeKind::Ellipsoid: return std::max<R>(half_.x, std::max<R>(half_.y, half_.z));
        case ShapeKind::Capsule: return halfLength_ + radius_;
        case ShapeKind::Cylinder:
        case ShapeKind::Cone: return hypotenuse(halfLength_, radius_);
        case ShapeKind::Triangle:
        case ShapeKind::SmoothTriangle:
            return std::max<R>(length(vertices_[0]), std::max<R>(length(vertices_[1]), length(vertices_[2])));
        case ShapeKind::Plane: return R(1);
        case ShapeKind::SpacePatch:
        case ShapeKind::LargeSphere:
        case ShapeKind::Mandelbulb:
        case ShapeKind::Solid: break;
        }
        return noAnswer();
    }

    ShapeKind kind_;
    Vec3<Wide<R>> middle_;
    Vec3<R> vertices_[3], axis_, half_; ///< half_: of an ellipsoid its radii, of a patch of the box about it
    Vec3<R> axes_[3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::shared_ptr<const PatchSurface<R>> patch_;
    R radius_ = 0, minor_ = 0, halfLength_ = 0, size_ = 1;
};

} // namespace gnomon::oracle
