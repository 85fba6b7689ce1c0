/// A height patch about its centre: its points, its slopes and bends, and what is nearest to a point.
///
/// R is double or wider; the nearest point's part of the surface is found in double (patch_distance.h), and the point
/// itself in R.
#pragma once

#include "lab/reference/exact/patch_distance.h"
#include "lab/reference/exact/vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace gnomon::oracle {

template<class R>
class PatchSurface {
  public:
    /// The tracer's patch, its centre at 0.
    PatchSurface(const Heights& heights, const Vec3<R>& size)
        : size_(size), near_(heights, glm::dvec3(0), {double(size.x), double(size.y), double(size.z)}) {
        for (std::size_t i = 0; i < 16; ++i) net_[i / 4][i % 4] = size.y * R(heights[i]);
        low_ = high_ = net_[0][0];
        for (const auto& row : net_)
            for (const R& height : row) {
                low_ = std::min<R>(low_, height);
                high_ = std::max<R>(high_, height);
            }
    }

    /// Height over (x, z) and its derivatives.
    struct Jet {
        R y = 0, x = 0, z = 0, xx = 0, xz = 0, zz = 0;
    };
    Jet at(const R& x, const R& z) const {
        const Powers u = powers(x, size_.x), v = powers(z, size_.z);
        Jet jet;
        for (int j = 0; j < 4; ++j) {
            R along[3]{0, 0, 0};
            for (int n = 0; n < 3; ++n)
                for (int i = 0; i < 4; ++i) along[n] += u[n][i] * net_[j][i];
            jet.y += v[0][j] * along[0];
            jet.x += v[0][j] * along[1];
            jet.xx += v[0][j] * along[2];
            jet.z += v[1][j] * along[0];
            jet.xz += v[1][j] * along[1];
            jet.zz += v[2][j] * along[0];
        }
        return jet;
    }
    const R& control(int i, int j) const { return net_[j][i]; } ///< y of a control point: i-th along x, j-th along z
    Vec3<R> controlPoint(int i, int j) const {
        return {size_.x * (R(i) / 3 - R(0.5)), net_[j][i], size_.z * (R(j) / 3 - R(0.5))};
    }
    const Vec3<R>& size() const { return size_; }
    /// Of the control points, between which the surface lies.
    const R& low() const { return low_; }
    const R& high() const { return high_; }

    bool over(const Vec3<R>& p) const {
        return p.x >= -size_.x / 2 && p.x <= size_.x / 2 && p.z >= -size_.z / 2 && p.z <= size_.z / 2;
    }
    /// The point of the patch that is nearest, or one that is as near as PatchDistance can tell.
    Vec3<R> nearest(const Vec3<R>& p) const {
        const Foot foot = near_.nearest({double(p.x), double(p.y), double(p.z)});
        R at[2]{size_.x * (R(foot.u) - R(0.5)), size_.z * (R(foot.v) - R(0.5))};
        const Vec3<R> told = point(at[0], at[1]);
        R before =
            R(2e-5) * std::max<R>(size_.x, size_.z); // farther it goes only where it bends like the sphere about p
        for (int round = 0; round < 8; ++round) {
            R step[2];
            newtonStep(p, at, step);
            const R way = std::max<R>(size(step[0]), size(step[1]));
            if (!(way < before / 2)) break;
            before = way;
            at[0] = std::clamp<R>(at[0] + step[0], -size_.x / 2, size_.x / 2);
            at[1] = std::clamp<R>(at[1] + step[1], -size_.z / 2, size_.z / 2);
        }
        const Vec3<R> finer = point(at[0], at[1]);
        return length(finer - p) <= length(told - p) + R(foot.slack) ? finer : told;
    }
    R distance(const Vec3<R>& p) const { return length(p - nearest(p)); }
    /// No farther than that from where p is put by the tangent plane below it: else it may be so near all the same.
    bool nearAt(const Vec3<R>& p, const R& most) const {
        const Jet b = at(std::clamp<R>(p.x, -size_.x / 2, size_.x / 2), std::clamp<R>(p.z, -size_.z / 2, size_.z / 2));
        const R way = (p.y - b.y) / (1 + b.x * b.x + b.z * b.z);
        const Vec3<R> q = point(std::clamp<R>(p.x + way * b.x, -size_.x / 2, size_.x / 2),
                                std::clamp<R>(p.z + way * b.z, -size_.z / 2, size_.z / 2));
        return length(p - q) <= most;
    }
    /// Positive above the surface, negative below; never negative beside the rectangle.
    R signedDistance(const Vec3<R>& p) const {
        const R distance = this->distance(p);
        return over(p) && p.y < at(p.x, p.z).y ? R(-distance) : distance;
    }

    /// Upwards, at a point of the surface.
    Vec3<R> normal(const Vec3<R>& p) const {
        const Jet jet = at(p.x, p.z);
        return unit(Vec3<R>(-jet.x, 1, -jet.z));
    }
    /// The smallest radius of curvature at a point of the surface.
    R bend(const Vec3<R>& p) const {
        using std::sqrt;
        const Jet b = at(p.x, p.z);
        const R square = 1 + b.x * b.x + b.z * b.z, w = sqrt(square);
        const R gauss = (b.xx * b.zz - b.xz * b.xz) / (square * square);
        const R mean = ((1 + b.z * b.z) * b.xx - 2 * b.x * b.z * b.xz + (1 + b.x * b.x) * b.zz) / (2 * square * w);
        return 1 / (size(mean) + sqrt(std::max<R>(mean * mean - gauss, 0)) + std::numeric_limits<R>::min());
    }

  private:
    using Powers = std::array<std::array<R, 4>, 3>;

    static R size(const R& x) { return x < 0 ? R(-x) : x; }
    Vec3<R> point(const R& x, const R& z) const { return {x, at(x, z).y, z}; }

    /// Cubic Bernstein polynomials and their first two derivatives over a length.
    static Powers powers(const R& x, const R& length) {
        const R t = x / length + R(0.5), s = 1 - t;
        Powers b{{{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
                  {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t},
                  {6 * s, 6 * t - 12 * s, 6 * s - 12 * t, 6 * t}}};
        for (int i = 0; i < 4; ++i) {
            b[1][i] /= length;
            b[2][i] /= length * length;
        }
        return b;
    }

    /// Of half the squared distance, along the rim where the patch ends and it would fall on.
    void newtonStep(const Vec3<R>& p, const R* at_, R* step) const {
        const Jet b = at(at_[0], at_[1]);
        const R rise = b.y - p.y, slope[2]{at_[0] - p.x + rise * b.x, at_[1] - p.z + rise * b.z};
        const R xx = 1 + b.x * b.x + rise * b.xx, xz = b.x * b.z + rise * b.xz, zz = 1 + b.z * b.z + rise * b.zz;
        const R half[2]{size_.x / 2, size_.z / 2};
        bool held[2];
        for (int i = 0; i < 2; ++i) held[i] = slope[i] > 0 ? at_[i] <= -half[i] : at_[i] >= half[i];
        step[0] = step[1] = 0;
        if (held[0] && held[1]) return;
        if (held[0] || held[1]) {
            const int free = held[0] ? 1 : 0;
            step[free] = -slope[free] / (free ? zz : xx);
            return;
        }
        const R det = xx * zz - xz * xz;
        step[0] = (xz * slope[1] - zz * slope[0]) / det;
        step[1] = (xz * slope[0] - xx * slope[1]) / det;
    }

    Vec3<R> size_;
    R net_[4][4]; ///< heights of the control points: [row along z][column along x]
    R low_, high_;
    PatchDistance near_;
};

} // namespace gnomon::oracle
