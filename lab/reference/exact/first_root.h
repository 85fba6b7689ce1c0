/// The first position where a function along a ray falls through 0, given nothing but its values.
///
/// The stretch is sampled, every dip between samples is searched for its bottom, every change of sign is bisected.
/// `tangency` is how far the answer is from being another one: the least |value| at the bottom of any dip passed or
/// entered. A root that all samples step over would be taken for a miss, and so would be told as the GPU's false hit:
/// the oracle's own fault shows, too.
#pragma once

#include <algorithm>
#include <limits>

namespace gnomon::oracle {

template<class R>
struct FirstRoot {
    bool hit = false;
    R t = 0;
    R tangency = R(1e30);
};

/// The bottom of a dip in [low, high] by golden section.
template<class R, class Function>
R bottomOf(const Function& f, R low, R high) {
    const R golden = R(0.6180339887498949L);
    const int digits = std::numeric_limits<R>::digits;
    R a = high - golden * (high - low), b = low + golden * (high - low);
    R fa = f(a), fb = f(b);
    for (int i = 0; i < digits; ++i) { // half the digits of a smooth bottom take 1.44 steps each, a sharp one's all
        if (fa < fb) {
            high = b;
            b = a;
            fb = fa;
            a = high - golden * (high - low);
            fa = f(a);
        } else {
            low = a;
            a = b;
            fa = fb;
            b = low + golden * (high - low);
            fb = f(b);
        }
    }
    return fa < fb ? a : b;
}

template<class R, class Function>
R bisect(const Function& f, R before, R after) {
    const bool sign = f(before) < 0;
    for (int i = 0; i < std::numeric_limits<R>::digits; ++i) {
        const R middle = (before + after) / 2;
        ((f(middle) < 0) == sign ? before : after) = middle;
    }
    return (before + after) / 2;
}

/// `f` is positive from `from` to the root sought.
template<class R, class Function>
FirstRoot<R> firstRoot(const Function& f, R from, R to, int samples) {
    FirstRoot<R> found;
    const R step = (to - from) / samples;
    R before = std::max<R>(f(from), 0); // a start within the surface's rounding counts as on it
    R here = before;
    for (int i = 0; i <= samples; ++i) { // the last looks one step beyond: a root before `to` has a sample behind it
        const R t = from + step * i;
        const R next = f(t + step);
        const bool dip = here <= before && here <= next; // at the start: perhaps, before the first sample
        if (dip || here <= 0) {
            // The dip that is passed or entered: its bottom tells how near the decision is.
            R high = t + step;
            if (here <= 0)
                for (R v = here, w = next; w < v && high < to; high += step) v = w, w = f(high + step);
            const R low = i == 0 ? from : R(t - step), bottom = bottomOf(f, low, high), least = f(bottom);
            found.tangency = std::min<R>(found.tangency, least < 0 ? R(-least) : least);
            if (least <= 0) {
                found.hit = true;
                found.t = bisect(f, low, here <= 0 && i > 0 ? t : bottom);
                return found;
            }
        }
        before = here;
        here = next;
    }
    return found;
}

} // namespace gnomon::oracle
