/// Polynomials over [0, 1] by their Bernstein coefficients: where they change their sign, with certainty.
///
/// A polynomial has no more roots inside than its coefficients, in order, change their sign, and an even number fewer.
/// So a stretch without a change has none, one with one change has one, and others are halved (Descartes' rule of
/// signs).
#pragma once

#include <array>
#include <cmath>
#include <limits>

namespace gnomon::oracle {

template<class R, int N>
struct Bernstein {
    std::array<R, N + 1> at{}; ///< coefficients; the first and the last are the values at 0 and at 1

    /// By de Casteljau.
    R operator()(const R& t) const {
        std::array<R, N + 1> c = at;
        for (int n = N; n > 0; --n)
            for (int i = 0; i < n; ++i) c[i] += t * (c[i + 1] - c[i]);
        return c[0];
    }
    Bernstein<R, N - 1> slope() const {
        Bernstein<R, N - 1> slope;
        for (int i = 0; i < N; ++i) slope.at[i] = N * (at[i + 1] - at[i]);
        return slope;
    }
    std::array<Bernstein, 2> halves() const {
        std::array<Bernstein, 2> half;
        std::array<R, N + 1> c = at;
        for (int n = N; n >= 0; --n) {
            half[0].at[N - n] = c[0];
            half[1].at[n] = c[n];
            for (int i = 0; i < n; ++i) c[i] = (c[i] + c[i + 1]) / 2;
        }
        return half;
    }
    int signChanges() const {
        int changes = 0, before = 0;
        for (const R& c : at) {
            const int sign = (c > 0) - (c < 0);
            if (sign == 0) continue;
            changes += before == -sign;
            before = sign;
        }
        return changes;
    }
};

/// Positions in order.
template<class R, int Most>
struct Positions {
    std::array<R, Most> at{};
    int count = 0;

    void add(const R& t) {
        if (count < Most) at[count++] = t;
    }
    const R* begin() const { return at.data(); }
    const R* end() const { return at.data() + count; }
};

/// The one root in [low, high], within [0, 1], of what is below 0 (or not) before it: by Newton's method, and by halves
/// where that does not converge.
template<class R, int N>
R rootIn(const Bernstein<R, N>& p, R low, R high, bool belowBefore) {
    const Bernstein<R, N - 1> slope = p.slope();
    R t = (low + high) / 2;
    for (int i = 0; i < 4 * std::numeric_limits<R>::digits; ++i) {
        const R value = p(t);
        ((value < 0) == belowBefore ? low : high) = t;
        const R steep = slope(t), middle = (low + high) / 2;
        R next = steep != 0 ? R(t - value / steep) : middle;
        if (!(next >= low && next <= high) || i % 4 == 3) next = middle;
        const R way = next < t ? t - next : next - t;
        t = next;
        if (way <= std::numeric_limits<R>::epsilon() || middle == low || middle == high) break;
    }
    return t;
}

/// Adds where a polynomial over [low, high], told by its coefficients over that stretch, changes its sign inside.
/// Where there is more than one change within rounding it adds where they are, as many as they may be.
template<class R, int N, int Most>
void addSignChanges(const Bernstein<R, N>& p, const R& low, const R& high, Positions<R, Most>& positions) {
    const int changes = p.signChanges();
    if (changes == 0) return;
    const R middle = (low + high) / 2;
    if (changes == 1) {
        int first = 0;
        while (p.at[first] == 0) ++first;
        positions.add(low + (high - low) * rootIn(p, R(0), R(1), p.at[first] < 0));
    } else if (high - low < 4 * std::numeric_limits<R>::epsilon() || middle == low || middle == high) {
        for (int i = 0; i < changes; ++i) positions.add(middle);
    } else {
        const auto half = p.halves();
        addSignChanges(half[0], low, middle, positions);
        if (half[1].at[0] == 0) positions.add(middle); // inside neither half
        addSignChanges(half[1], middle, high, positions);
    }
}

template<class R, int N>
Positions<R, N> signChanges(const Bernstein<R, N>& p) {
    Positions<R, N> positions;
    addSignChanges(p, R(0), R(1), positions);
    return positions;
}

} // namespace gnomon::oracle
