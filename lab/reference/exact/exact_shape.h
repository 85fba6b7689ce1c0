/// A shape as geometry: its exact distance about its own middle.
///
/// It knows nothing of rays and shares no formula with the shader's intersectors. R is double for millions of rays (the
/// coordinates are those of the shape's own size, so 1e-16 of it is lost), or any wider type.
#pragma once

#include "lab/reference/exact/vec3.h"
#include "tracer/scene/shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
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
    bool closed() const { return kind_ != ShapeKind::Plane && kind_ != ShapeKind::Disc && !triangle(); }
    bool triangle() const { return kind_ == ShapeKind::Triangle || kind_ == ShapeKind::SmoothTriangle; }
    /// The distance is a convex function of the point.
    bool convex() const { return closed() && kind_ != ShapeKind::Torus; }
    const Vec3<Wide<R>>& middle() const { return middle_; }
    /// Radius of the sphere about the middle that holds the shape; 1 for a plane.
    const R& size() const { return size_; }
    /// Along the torus, the plane's or disc's normal, from `from` to `to`; a triangle's normal.
    const Vec3<R>& axis() const { return axis_; }
    const R& radius() const { return radius_; }
    const R& minor() const { return minor_; }
    const Vec3<R>& vertex(int i) const { return vertices_[i]; }

    /// Signed distance of a closed shape's surface, negative inside, or of the plane of a flat one. `p` from the
    /// middle.
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
        case ShapeKind::Ellipsoid: return ellipsoidDistance(alongAxes(p));
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
        case ShapeKind::HeightPatch: // patch_distance.h
        case ShapeKind::LargeSphere: // to its scene it is a sphere
        case ShapeKind::Mandelbulb:  // told by their distance fields only (solid.h)
        case ShapeKind::Solid: break;
        }
        return noAnswer();
    }

    /// The same, but of a disc or triangle as far as its rim, which has no inside: never negative.
    R boundedDistance(const Vec3<R>& p) const {
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

    /// Unit, outward, by central differences of the distance.
    Vec3<R> normal(const Vec3<R>& p) const {
        if (!closed()) return axis_;
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
        if (kind_ == ShapeKind::Ellipsoid) return ellipsoidDepth(alongAxes(p));
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
        case ShapeKind::Ellipsoid: return std::min<R>(size_, ellipsoidBend(alongAxes(p)));
        case ShapeKind::HeightPatch:
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
    Vec3<R> alongAxes(const Vec3<R>& p) const { return {dot(p, axes_[0]), dot(p, axes_[1]), dot(p, axes_[2])}; }

    /// The foot q of p has p - q = s q / radii². Newton's method for 1 / |q / radii| = 1, nearly a straight line in s,
    /// from where it is too small: it bends so that no step passes the root.
    R ellipsoidDistance(const Vec3<R>& p) const {
        using std::sqrt;
        const R least = std::min<R>(half_.x, std::min<R>(half_.y, half_.z));
        Vec3<R> weighed, gap;
        R s = 0;
        for (int i = 0; i < 3; ++i) {
            weighed[i] = half_[i] * std::max<R>(abs(p[i]), least * std::numeric_limits<R>::epsilon());
            gap[i] = (half_[i] - least) * (half_[i] + least); // told from the pole at s = -least²
            s = std::max<R>(s, weighed[i] - gap[i]);
        }
        for (int round = 0; round < 200; ++round) {
            R square = 0, slope = 0;
            for (int i = 0; i < 3; ++i) {
                const R part = weighed[i] / (s + gap[i]);
                square += part * part;
                slope += part * part / (s + gap[i]);
            }
            const R step = (sqrt(square) - 1) * square / slope;
            if (!(step > s * std::numeric_limits<R>::epsilon())) break;
            s += step;
        }
        Vec3<R> off, normal;
        for (int i = 0; i < 3; ++i) {
            const R part = weighed[i] / (s + gap[i]);
            off[i] = abs(p[i]) - half_[i] * part;
            normal[i] = part / half_[i];
        }
        return dot(off, unit(normal));
    }
    /// The normal through a point of the surface meets the plane across the shortest axis so far inside.
    R ellipsoidDepth(const Vec3<R>& p) const {
        const R least = std::min<R>(half_.x, std::min<R>(half_.y, half_.z));
        Vec3<R> gradient;
        for (int i = 0; i < 3; ++i) gradient[i] = p[i] / (half_[i] * half_[i]);
        return least * least * length(gradient);
    }
    /// From trace and determinant of the shape operator of q / radii² at a point of the surface.
    R ellipsoidBend(const Vec3<R>& p) const {
        using std::sqrt;
        Vec3<R> gradient, bends;
        for (int i = 0; i < 3; ++i) {
            bends[i] = 1 / (half_[i] * half_[i]);
            gradient[i] = p[i] * bends[i];
        }
        const R steep = length(gradient);
        R trace = 0;
        for (int i = 0; i < 3; ++i) trace += bends[i] * (1 - gradient[i] * gradient[i] / (steep * steep)) / steep;
        const R gauss = bends.x * bends.y * bends.z / (steep * steep * steep * steep);
        return 2 / (trace + sqrt(std::max<R>(trace * trace - 4 * gauss, 0)));
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
        case ShapeKind::RotatedBox: return length(half_);
        case ShapeKind::Ellipsoid: return std::max<R>(half_.x, std::max<R>(half_.y, half_.z));
        case ShapeKind::Capsule: return halfLength_ + radius_;
        case ShapeKind::Cylinder:
        case ShapeKind::Cone: return hypotenuse(halfLength_, radius_);
        case ShapeKind::Triangle:
        case ShapeKind::SmoothTriangle:
            return std::max<R>(length(vertices_[0]), std::max<R>(length(vertices_[1]), length(vertices_[2])));
        case ShapeKind::Plane: return R(1);
        case ShapeKind::HeightPatch:
        case ShapeKind::LargeSphere:
        case ShapeKind::Mandelbulb:
        case ShapeKind::Solid: break;
        }
        return noAnswer();
    }

    ShapeKind kind_;
    Vec3<Wide<R>> middle_;
    Vec3<R> vertices_[3], axis_, half_; ///< half_: of an ellipsoid its radii
    Vec3<R> axes_[3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    R radius_ = 0, minor_ = 0, halfLength_ = 0, size_ = 1;
};

} // namespace gnomon::oracle
