/// An ellipsoid in its own axes, about its middle.
#pragma once

#include "lab/reference/exact/vec3.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon::oracle {

/// The foot q of p has p - q = s q / radii². Newton's method for 1 / |q / radii| = 1, nearly a straight line in s, from
/// where it is too small: it bends so that no step passes the root.
template<class R>
R ellipsoidDistance(const Vec3<R>& radii, const Vec3<R>& p) {
    using std::sqrt;
    const auto size = [](const R& x) { return x < 0 ? R(-x) : x; };
    const R least = std::min<R>(radii.x, std::min<R>(radii.y, radii.z));
    Vec3<R> weighed, gap;
    R s = 0;
    for (int i = 0; i < 3; ++i) {
        weighed[i] = radii[i] * std::max<R>(size(p[i]), least * std::numeric_limits<R>::epsilon());
        gap[i] = (radii[i] - least) * (radii[i] + least); // told from the pole at s = -least²
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
        off[i] = size(p[i]) - radii[i] * part;
        normal[i] = part / radii[i];
    }
    return dot(off, unit(normal));
}

/// The normal through a point of the surface meets the plane across the shortest axis so far inside.
template<class R>
R ellipsoidDepth(const Vec3<R>& radii, const Vec3<R>& p) {
    const R least = std::min<R>(radii.x, std::min<R>(radii.y, radii.z));
    Vec3<R> gradient;
    for (int i = 0; i < 3; ++i) gradient[i] = p[i] / (radii[i] * radii[i]);
    return least * least * length(gradient);
}

/// From trace and determinant of the shape operator of q / radii² at a point of the surface.
template<class R>
R ellipsoidBend(const Vec3<R>& radii, const Vec3<R>& p) {
    using std::sqrt;
    Vec3<R> gradient, bends;
    for (int i = 0; i < 3; ++i) {
        bends[i] = 1 / (radii[i] * radii[i]);
        gradient[i] = p[i] * bends[i];
    }
    const R steep = length(gradient);
    R trace = 0;
    for (int i = 0; i < 3; ++i) trace += bends[i] * (1 - gradient[i] * gradient[i] / (steep * steep)) / steep;
    const R gauss = bends.x * bends.y * bends.z / (steep * steep * steep * steep);
    return 2 / (trace + sqrt(std::max<R>(trace * trace - 4 * gauss, 0)));
}

} // namespace gnomon::oracle
