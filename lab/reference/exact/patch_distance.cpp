#include "lab/reference/exact/patch_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gnomon::oracle {
namespace {

constexpr double kThree[]{1, 3, 3, 1}, kSix[]{1, 6, 15, 20, 15, 6, 1}; ///< binomial coefficients

/// A part of the square, [low, high] of u and of v. Where an axis is pinned low and high are one.
struct Part {
    double bound = 0; ///< the squared distance is no less
    double low[2]{0, 0}, high[2]{1, 1};
    bool pinned[2]{false, false};
    double rise[4][4]; ///< of the surface over q, in control points: [row along v][column along u]
};

struct Range {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    void add(double x) {
        least = std::min(least, x);
        most = std::max(most, x);
    }
};

/// The squared distance over a part, or a difference of it: what its coefficients tell.
struct Square {
    double at[7][7];

    Range all() const {
        Range range;
        for (const auto& row : at)
            for (const double x : row) range.add(x);
        return range;
    }
    /// Differences of coefficients along u so many times, along v so many.
    Range differences(int alongU, int alongV) const {
        Range range;
        for (int l = 0; l < 7 - alongV; ++l)
            for (int k = 0; k < 7 - alongU; ++k) range.add(difference(k, l, alongU, alongV));
        return range;
    }

  private:
    double difference(int k, int l, int alongU, int alongV) const {
        if (alongU == 2) return at[l][k] - 2 * at[l][k + 1] + at[l][k + 2];
        if (alongV == 2) return at[l][k] - 2 * at[l + 1][k] + at[l + 2][k];
        if (alongU == 1 && alongV == 1) return at[l][k] - at[l][k + 1] - at[l + 1][k] + at[l + 1][k + 1];
        return alongU == 1 ? at[l][k + 1] - at[l][k] : at[l + 1][k] - at[l][k];
    }
};

/// Value, slope and second derivatives of the squared distance at a point.
struct Jet {
    double value, slope[2], bend[2][2];
};

/// One search.
class Search {
  public:
    Search(const Heights& heights, glm::dvec2 size, glm::dvec3 q, double tolerance)
        : size_{size.x, size.y}, q_{q.x, q.z}, tolerance_(tolerance) {
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) whole_.rise[j][i] = heights[std::size_t(4 * j + i)] - q.y;
    }

    Foot run() {
        parts_.reserve(256);
        const double start[2]{std::clamp(q_[0] / size_[0], 0.0, 1.0), std::clamp(q_[1] / size_[1], 0.0, 1.0)};
        descend(start, whole_);
        look(whole_);
        const double rounding = 1e-15 * std::sqrt(squareOf(whole_).all().most);
        double gap = 0; // from what the distance may be anywhere
        while (!parts_.empty()) {
            std::pop_heap(parts_.begin(), parts_.end(), later);
            const Part part = parts_.back();
            parts_.pop_back();
            gap = std::max(0.0, std::sqrt(best_) - std::sqrt(part.bound));
            if (gap <= std::max(tolerance_, 4 * rounding)) break;
            halve(part);
            gap = 0;
        }
        return {std::sqrt(best_), foot_[0], foot_[1], gap + rounding, looked_};
    }

  private:
    static bool later(const Part& a, const Part& b) { return a.bound > b.bound; }

    /// Keeps a part that may hold what is nearer than the best so far.
    void look(Part part) {
        ++looked_;
        if (boxBound(part) >= best_) return;
        const Square square = squareOf(part);
        const Range all = square.all();
        part.bound = std::max(all.least, part.bound);
        if (part.bound >= best_) return;
        offerCorners(part, square);
        const double rounding = 1e-14 * all.most; // of coefficients, all of them sums of squares but for it
        for (int axis = 0; axis < 2; ++axis) {
            if (part.pinned[axis]) continue;
            const Range slope = square.differences(axis == 0, axis == 1);
            if (slope.least > rounding) {
                if (part.low[axis] > 0) return; // what is before it is nearer
                return look(pinned(part, axis, 0));
            }
            if (slope.most < -rounding) {
                if (part.high[axis] < 1) return;
                return look(pinned(part, axis, 1));
            }
        }
        if (convex(part, square, rounding)) part.bound = std::max(part.bound, leastOfConvex(part));
        if (part.bound >= best_) return;
        parts_.push_back(part);
        std::push_heap(parts_.begin(), parts_.end(), later);
    }

    double boxBound(const Part& part) const {
        Range rise;
        for (const auto& row : part.rise)
            for (const double x : row) rise.add(x);
        double square = 0;
        const auto add = [&](double low, double high) {
            const double gap = std::max({low, -high, 0.0});
            square += gap * gap;
        };
        add(rise.least, rise.most);
        for (int axis = 0; axis < 2; ++axis) add(offset(axis, part.low[axis]), offset(axis, part.high[axis]));
        return square;
    }
    double offset(int axis, double t) const { return t * size_[axis] - q_[axis]; }

    Square squareOf(const Part& part) const {
        double scaled[4][4];
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) scaled[j][i] = kThree[j] * kThree[i] * part.rise[j][i];
        Square square{};
        for (int j = 0; j < 4; ++j)
            for (int m = j; m < 4; ++m)
                for (int i = 0; i < 4; ++i) {
                    const double twice = (m == j ? 1 : 2) * scaled[j][i];
                    for (int n = 0; n < 4; ++n) square.at[j + m][i + n] += twice * scaled[m][n];
                }
        double across[2][7];
        for (int axis = 0; axis < 2; ++axis) {
            const double a = offset(axis, part.low[axis]), b = offset(axis, part.high[axis]);
            for (int k = 0; k < 7; ++k)
                across[axis][k] =
                    ((6 - k) * (5 - k) * a * a + 2 * k * (6 - k) * a * b + k * (k - 1) * b * b) * (1 / 30.0);
        }
        for (int l = 0; l < 7; ++l)
            for (int k = 0; k < 7; ++k)
                square.at[l][k] = square.at[l][k] / (kSix[l] * kSix[k]) + across[0][k] + across[1][l];
        return square;
    }

    void offerCorners(const Part& part, const Square& square) {
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                if (square.at[6 * j][6 * i] >= best_) continue;
                const double corner[2]{i ? part.high[0] : part.low[0], j ? part.high[1] : part.low[1]};
                descend(corner, whole_);
            }
    }

    static Part pinned(Part part, int axis, int end) {
        part.pinned[axis] = true;
        part.low[axis] = part.high[axis] = end;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                if (axis == 0) part.rise[j][i] = part.rise[j][3 * end];
                if (axis == 1 && j != 3 * end) part.rise[j][i] = part.rise[3 * end][i];
            }
        return part;
    }

    /// Of second derivatives, which are differences of coefficients 30 or 36 times.
    static bool convex(const Part& part, const Square& square, double rounding) {
        const double u = part.pinned[0] ? 1 : 30 * (square.differences(2, 0).least - 2 * rounding);
        const double v = part.pinned[1] ? 1 : 30 * (square.differences(0, 2).least - 2 * rounding);
        if (u <= 0 || v <= 0) return false;
        if (part.pinned[0] || part.pinned[1]) return true;
        const Range mixed = square.differences(1, 1);
        const double most = 36 * (std::max(mixed.most, -mixed.least) + 2 * rounding);
        return u * v > most * most;
    }

    double leastOfConvex(const Part& part) {
        double middle[2];
        for (int axis = 0; axis < 2; ++axis) middle[axis] = (part.low[axis] + part.high[axis]) / 2;
        const Jet jet = descend(middle, part);
        double least = jet.value;
        for (int axis = 0; axis < 2; ++axis) {
            const double g = jet.slope[axis], t = at_[axis];
            least += std::min(g * (part.low[axis] - t), g * (part.high[axis] - t));
        }
        return least;
    }

    void halve(const Part& part) {
        const int axis = longer(part);
        Part half[2]{part, part};
        const double middle = (part.low[axis] + part.high[axis]) / 2;
        half[0].high[axis] = half[1].low[axis] = middle;
        for (int n = 0; n < 4; ++n) {
            const auto of = [&](int side, int i) -> double& {
                return axis == 0 ? half[side].rise[n][i] : half[side].rise[i][n];
            };
            const double a = of(0, 0), b = of(0, 1), c = of(0, 2), d = of(0, 3);
            const double ab = (a + b) / 2, bc = (b + c) / 2, cd = (c + d) / 2, abc = (ab + bc) / 2, bcd = (bc + cd) / 2;
            of(0, 1) = ab;
            of(0, 2) = abc;
            of(0, 3) = of(1, 0) = (abc + bcd) / 2;
            of(1, 1) = bcd;
            of(1, 2) = cd;
        }
        look(half[0]);
        look(half[1]);
    }
    /// The axis along which a part extends farther in space.
    int longer(const Part& part) const {
        double most[2]{0, 0};
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 3; ++i) {
                most[0] = std::max(most[0], std::abs(part.rise[j][i + 1] - part.rise[j][i]));
                most[1] = std::max(most[1], std::abs(part.rise[i + 1][j] - part.rise[i][j]));
            }
        for (int axis = 0; axis < 2; ++axis)
            most[axis] = part.pinned[axis] ? -1 : 3 * most[axis] + (part.high[axis] - part.low[axis]) * size_[axis];
        return most[0] >= most[1] ? 0 : 1;
    }

    Jet jetAt(const double* t) const {
        double basis[2][3][4];
        for (int axis = 0; axis < 2; ++axis) {
            const double b = t[axis], a = 1 - b;
            double(&of)[3][4] = basis[axis];
            of[0][0] = a * a * a, of[0][1] = 3 * a * a * b, of[0][2] = 3 * a * b * b, of[0][3] = b * b * b;
            of[1][0] = -3 * a * a, of[1][1] = 3 * a * (a - 2 * b), of[1][2] = 3 * b * (2 * a - b), of[1][3] = 3 * b * b;
            of[2][0] = 6 * a, of[2][1] = 6 * b - 12 * a, of[2][2] = 6 * a - 12 * b, of[2][3] = 6 * b;
        }
        double d[3][3]{}; // derivatives of the rise: [along u][along v]
        for (int j = 0; j < 4; ++j)
            for (int n = 0; n < 3; ++n) {
                double along = 0;
                for (int i = 0; i < 4; ++i) along += basis[0][n][i] * whole_.rise[j][i];
                for (int m = 0; m + n < 3; ++m) d[n][m] += basis[1][m][j] * along;
            }
        const double x = offset(0, t[0]), z = offset(1, t[1]), r = d[0][0];
        Jet jet;
        jet.value = x * x + r * r + z * z;
        jet.slope[0] = 2 * (x * size_[0] + r * d[1][0]);
        jet.slope[1] = 2 * (z * size_[1] + r * d[0][1]);
        jet.bend[0][0] = 2 * (size_[0] * size_[0] + d[1][0] * d[1][0] + r * d[2][0]);
        jet.bend[1][1] = 2 * (size_[1] * size_[1] + d[0][1] * d[0][1] + r * d[0][2]);
        jet.bend[0][1] = jet.bend[1][0] = 2 * (d[1][0] * d[0][1] + r * d[1][1]);
        return jet;
    }

    /// Newton's method within a part, downhill only; leaves at_ where it ends. Offers that to the best.
    Jet descend(const double* start, const Part& within) {
        std::copy_n(start, 2, at_);
        Jet here = jetAt(at_);
        for (int round = 0; round < 12; ++round) {
            double step[2];
            newtonStep(here, within, step);
            bool lower = false;
            for (int half = 0; half < 4 && !lower; ++half) {
                double next[2];
                for (int axis = 0; axis < 2; ++axis)
                    next[axis] = std::clamp(at_[axis] + step[axis], within.low[axis], within.high[axis]);
                const Jet there = jetAt(next);
                if (there.value < here.value) {
                    lower = true;
                    std::copy_n(next, 2, at_);
                    here = there;
                }
                step[0] /= 4, step[1] /= 4;
            }
            if (!lower) break;
        }
        if (here.value < best_) {
            best_ = here.value;
            std::copy_n(at_, 2, foot_);
        }
        return here;
    }
    /// An axis rests where the slope leads out of the part.
    void newtonStep(const Jet& jet, const Part& within, double* step) const {
        bool free[2];
        for (int axis = 0; axis < 2; ++axis) {
            const bool out = jet.slope[axis] > 0 ? at_[axis] <= within.low[axis] : at_[axis] >= within.high[axis];
            free[axis] = !out && within.low[axis] < within.high[axis];
            step[axis] = 0;
        }
        const double(&h)[2][2] = jet.bend;
        const double steep = size_[0] * size_[0] + size_[1] * size_[1];
        if (free[0] && free[1]) {
            // The less of the two bends that the matrix has, made positive.
            const double mean = (h[0][0] + h[1][1]) / 2, least = mean - std::hypot((h[0][0] - h[1][1]) / 2, h[0][1]);
            const double shift = std::max(0.0, 0.05 * steep - least);
            const double a = h[0][0] + shift, c = h[1][1] + shift, det = a * c - h[0][1] * h[0][1];
            step[0] = (h[0][1] * jet.slope[1] - c * jet.slope[0]) / det;
            step[1] = (h[0][1] * jet.slope[0] - a * jet.slope[1]) / det;
            // What one bound cuts off changes what is best along the other axis.
            for (int axis = 0; axis < 2; ++axis) {
                const double end = std::clamp(at_[axis] + step[axis], within.low[axis], within.high[axis]) - at_[axis];
                if (end == step[axis]) continue;
                const int other = 1 - axis;
                step[axis] = end;
                step[other] = -(jet.slope[other] + h[0][1] * end) / (h[other][other] + shift);
                break;
            }
        } else
            for (int axis = 0; axis < 2; ++axis)
                if (free[axis]) step[axis] = -jet.slope[axis] / std::max(std::abs(h[axis][axis]), 0.05 * steep);
    }

    double size_[2], q_[2], tolerance_;
    Part whole_;
    std::vector<Part> parts_; ///< a heap, the least bound on top
    double best_ = std::numeric_limits<double>::infinity(), foot_[2]{0, 0}, at_[2]{0, 0};
    int looked_ = 0;
};

} // namespace

PatchDistance::PatchDistance(const Heights& heights, glm::dvec3 center, glm::dvec3 size)
    : heights_(heights), center_(center), size_(size) {
    for (double& height : heights_) height *= size.y;
    const auto [least, greatest] = std::minmax_element(heights_.begin(), heights_.end());
    tolerance_ = 1e-10 * std::max({size.x, size.z, *greatest - *least});
}

Foot PatchDistance::nearest(glm::dvec3 q) const {
    const glm::dvec3 corner = q - center_ + glm::dvec3(size_.x / 2, 0, size_.z / 2);
    return Search(heights_, {size_.x, size_.z}, corner, tolerance_).run();
}

double PatchDistance::signedDistance(glm::dvec3 q) const {
    const double distance = nearest(q).distance;
    const glm::dvec2 at = glm::dvec2(q.x - center_.x, q.z - center_.z) / glm::dvec2(size_.x, size_.z) + 0.5;
    if (at.x < 0 || at.x > 1 || at.y < 0 || at.y > 1) return distance;
    const auto cubic = [](double a, double b, double c, double d, double t) {
        const double s = 1 - t;
        return s * s * s * a + 3 * s * t * (s * b + t * c) + t * t * t * d;
    };
    double row[4];
    for (std::size_t j = 0; j < 4; ++j)
        row[j] = cubic(heights_[4 * j], heights_[4 * j + 1], heights_[4 * j + 2], heights_[4 * j + 3], at.x);
    return q.y < center_.y + cubic(row[0], row[1], row[2], row[3], at.y) ? -distance : distance;
}

} // namespace gnomon::oracle
