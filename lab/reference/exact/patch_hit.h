/// Where a ray meets a height patch: every time, and how sure that is.
///
/// Over the rectangle the ray's height over the surface is a polynomial of degree 6 in t. Where its slope changes its
/// sign is told with certainty (bernstein.h); between these places it rises or falls throughout, so that two values of
/// unlike sign have one root between them and two alike have none. Near a decision two things are told from others: how
/// far the ray is from touching where it turns round over the surface, and how near it passes the rim's four curves.
#pragma once

#include "lab/reference/exact/bernstein.h"
#include "lab/reference/exact/patch_surface.h"

#include <vector>

namespace gnomon::oracle {

template<class R>
struct PatchHits {
    std::vector<R> t; ///< in order, of o + t d
    /// How far the ray is, across itself, from meeting the patch first elsewhere, or never, or at all.
    R tangency = R(1e30);
    /// The same for any of its hits.
    R margin = R(1e30);
    bool below = false; ///< it starts below the surface
};

/// One ray and one patch.
template<class R>
class PatchMeeting {
  public:
    PatchMeeting(const PatchSurface<R>& surface, const Vec3<R>& origin, const Vec3<R>& direction, const R& from)
        : surface_(surface), o_(origin), d_(direction), from_(from) {
        if (clip()) follow();
        passRims();
        passStart();
        hits_.margin = std::min<R>(hits_.margin, hits_.tangency);
    }
    PatchHits<R> hits() const { return hits_; }

  private:
    /// A place where the ray turns round over the surface, or where it ends.
    struct Turn {
        R t, off; ///< off: how far from the surface
    };

    Vec3<R> at(const R& t) const { return o_ + t * d_; }
    static R size(const R& x) { return x < 0 ? R(-x) : x; }

    /// To the stretch over the rectangle and not far above or below it.
    bool clip() {
        const Vec3<R>& size = surface_.size();
        const R room = std::max<R>(surface_.high() - surface_.low(), std::max<R>(size.x, size.z));
        const R low[3]{-size.x / 2, surface_.low() - room, -size.z / 2},
            high[3]{size.x / 2, surface_.high() + room, size.z / 2};
        low_ = from_;
        high_ = R(1e30);
        for (int i = 0; i < 3; ++i) {
            if (d_[i] == 0) {
                if (o_[i] < low[i] || o_[i] > high[i]) return false;
                continue;
            }
            const R a = (low[i] - o_[i]) / d_[i], b = (high[i] - o_[i]) / d_[i];
            low_ = std::max<R>(low_, std::min<R>(a, b));
            high_ = std::min<R>(high_, std::max<R>(a, b));
        }
        return low_ < high_;
    }

    /// The ray's height over the surface from low_ to high_: of the part of the patch whose diagonal it follows.
    Bernstein<R, 6> heightOver() const {
        const Vec3<R> first = at(low_), last = at(high_);
        const R u[2]{part(first.x, surface_.size().x), part(last.x, surface_.size().x)},
            v[2]{part(first.z, surface_.size().z), part(last.z, surface_.size().z)};
        R along[4][4], net[4][4];
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
                along[j][i] = blossom(u, i, [&](int n) -> const R& { return surface_.control(n, j); });
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) net[j][i] = blossom(v, j, [&](int n) -> const R& { return along[n][i]; });
        static constexpr int kThree[]{1, 3, 3, 1}, kSix[]{1, 6, 15, 20, 15, 6, 1};
        Bernstein<R, 6> over;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) over.at[i + j] -= R(kThree[i] * kThree[j]) * net[j][i] / kSix[i + j];
        for (int k = 0; k < 7; ++k) over.at[k] += first.y + (last.y - first.y) * k / 6;
        return over;
    }
    static R part(const R& x, const R& length) { return std::clamp<R>(x / length + R(0.5), 0, 1); }
    /// A cubic's polar form of the second end so many times, and of the first for the rest: a control value between.
    template<class Control>
    static R blossom(const R* ends, int second, const Control& control) {
        R c[4]{control(0), control(1), control(2), control(3)};
        for (int n = 3; n > 0; --n) {
            const R& t = ends[n <= second];
            for (int i = 0; i < n; ++i) c[i] = (1 - t) * c[i] + t * c[i + 1];
        }
        return c[0];
    }

    void follow() {
        const Bernstein<R, 6> over = heightOver();
        turns_.push_back(turn(over, 0));
        R before = 0;
        const auto goOn = [&](const R& next) {
            const R a = over(before), b = over(next);
            turns_.push_back(turn(over, next));
            if ((a < 0) != (b < 0)) {
                hits_.t.push_back(low_ + (high_ - low_) * rootIn(over, before, next, a < 0));
                if (entered_ == 0) entered_ = turns_.size() - 1;
            }
            before = next;
        };
        for (const R& next : signChanges(over.slope())) goOn(next);
        goOn(R(1));
        // A start or an end is decided by the start's own distance and by the rim's.
        for (std::size_t i = 1; i + 1 < turns_.size(); ++i) {
            hits_.margin = std::min<R>(hits_.margin, turns_[i].off);
            if (entered_ == 0 || i <= entered_) hits_.tangency = std::min<R>(hits_.tangency, turns_[i].off);
        }
    }
    Turn turn(const Bernstein<R, 6>& over, const R& part) const {
        using std::sqrt;
        const R t = low_ + (high_ - low_) * part;
        const Vec3<R> p = at(t);
        const auto jet = surface_.at(p.x, p.z);
        return {t, R(size(over(part)) / sqrt(1 + jet.x * jet.x + jet.z * jet.z))};
    }

    /// Seen along the ray a rim's curve is a plane cubic, and nearest where the square of its distance turns round.
    void passRims() {
        for (int side = 0; side < 4; ++side) {
            Bernstein<R, 3> across[3];
            Bernstein<R, 6> square;
            for (int i = 0; i < 4; ++i) {
                const Vec3<R> p =
                    side < 2 ? surface_.controlPoint(side * 3, i) : surface_.controlPoint(i, side * 3 - 6);
                const Vec3<R> off = cross(p - o_, d_);
                for (int axis = 0; axis < 3; ++axis) across[axis].at[i] = off[axis];
            }
            static constexpr int kThree[]{1, 3, 3, 1}, kSix[]{1, 6, 15, 20, 15, 6, 1};
            for (const auto& c : across)
                for (int i = 0; i < 4; ++i)
                    for (int j = 0; j < 4; ++j)
                        square.at[i + j] += R(kThree[i] * kThree[j]) * c.at[i] * c.at[j] / kSix[i + j];
            passRim(side, 0);
            for (const R& place : signChanges(square.slope())) passRim(side, place);
            passRim(side, 1);
        }
    }
    void passRim(int side, const R& place) {
        using std::sqrt;
        const Vec3<R>& size = surface_.size();
        const R end = side % 2 ? R(0.5) : R(-0.5), along = place - R(0.5);
        const R x = size.x * (side < 2 ? end : along), z = size.z * (side < 2 ? along : end);
        const Vec3<R> off = Vec3<R>(x, surface_.at(x, z).y, z) - o_;
        const R t = dot(off, d_) / dot(d_, d_), distance = length(off - t * d_);
        if (t < from_) return; // what is behind the start is no nearer than the start itself
        hits_.margin = std::min<R>(hits_.margin, distance);
        if (entered_ > 0)
            for (std::size_t i = entered_; i < turns_.size() && turns_[i].t < t; ++i)
                if (turns_[i].off > distance) return; // it has met the surface for certain before
        hits_.tangency = std::min<R>(hits_.tangency, distance);
    }
    void passStart() {
        const Vec3<R> p = at(from_);
        const Vec3<R>& size = surface_.size();
        hits_.below = surface_.over(p) && p.y < surface_.at(p.x, p.z).y;
        R square = 0;
        const auto beyond = [&](const R& x, const R& low, const R& high) {
            const R gap = std::max<R>(std::max<R>(low - x, x - high), 0);
            square += gap * gap;
        };
        beyond(p.x, -size.x / 2, size.x / 2);
        beyond(p.y, surface_.low(), surface_.high());
        beyond(p.z, -size.z / 2, size.z / 2);
        if (square < hits_.tangency * hits_.tangency)
            hits_.tangency = std::min<R>(hits_.tangency, surface_.distance(p));
    }

    const PatchSurface<R>& surface_;
    Vec3<R> o_, d_;
    R from_, low_ = 0, high_ = 0;
    std::vector<Turn> turns_;
    std::size_t entered_ = 0; ///< the turn behind the first hit; 0: none
    PatchHits<R> hits_;
};

/// The hits of o + t d with t > from, in coordinates about the patch's centre. The ray should be told from a point near
/// to it: 1e-16 of what separates o from the patch is lost.
template<class R>
PatchHits<R> hitsOf(const PatchSurface<R>& surface, const Vec3<R>& origin, const Vec3<R>& direction, const R& from) {
    return PatchMeeting<R>(surface, origin, direction, from).hits();
}

} // namespace gnomon::oracle
