/// The first place where a ray enters (or, started inside, leaves) a body given by its signed distance, in long double.
///
/// Independent of the shader: it knows only the distance. The stretch is sampled, every dip between samples is searched
/// for its minimum, every change of sign is bisected. `tangency` is how far the answer is from being another one: the
/// least |distance| at the bottom of any dip passed or entered.
#pragma once

#include <algorithm>
#include <cmath>

namespace gnomon::test {

using Real = long double;

struct FirstRoot {
    bool hit = false;
    Real t = 0;
    Real tangency = 1e30L;
};

/// The bottom of a dip in [low, high] by ternary search.
template<class Distance>
Real bottomOf(const Distance& f, Real low, Real high) {
    for (int i = 0; i < 90; ++i) {
        const Real a = low + (high - low) / 3, b = high - (high - low) / 3;
        (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
    }
    return (low + high) / 2;
}

template<class Distance>
Real bisect(const Distance& f, Real before, Real after) {
    const bool sign = f(before) < 0;
    for (int i = 0; i < 90; ++i) {
        const Real middle = (before + after) / 2;
        ((f(middle) < 0) == sign ? before : after) = middle;
    }
    return (before + after) / 2;
}

/// `distance(t)` along the ray; `inside`: the ray starts inside, and the root sought is where it leaves.
template<class Distance>
FirstRoot firstRoot(const Distance& distance, Real from, Real to, bool inside, int samples = 256) {
    const auto f = [&](Real t) { return inside ? -distance(t) : distance(t); }; // > 0 until the root
    FirstRoot found;
    const Real step = (to - from) / samples;
    Real before = f(from), here = f(from + step);
    if (before <= 0) before = 0; // starts on the surface, or within its rounding
    for (int i = 1; i < samples; ++i) {
        const Real t = from + step * i, next = f(t + step);
        const bool dip = here <= before && here <= next;
        if (dip || here <= 0) {
            // The dip that is passed or entered: its bottom tells how near the decision is.
            Real high = t + step;
            if (here <= 0)
                for (Real v = here, w = next; w < v && high < to; high += step) v = w, w = f(high + step);
            const Real bottom = bottomOf(f, t - step, high);
            found.tangency = std::min(found.tangency, std::abs(f(bottom)));
            if (f(bottom) <= 0) {
                found.hit = true;
                found.t = bisect(f, t - step, here <= 0 ? t : bottom);
                return found;
            }
        }
        before = here;
        here = next;
    }
    return found;
}

} // namespace gnomon::test
