/// What a ray of float32 numbers meets of one body, exactly.
#pragma once

#include "lab/reference/exact/body.h"
#include "lab/reference/exact/first_root.h"

namespace gnomon::oracle {

template<class R>
struct Line {
    Vec3<R> p; ///< the point of the line nearest to the body's middle, relative to it
    Vec3<R> d;
    Wide<R> middle; ///< t of p
    R start;        ///< the ray's start, relative to p in t

    Vec3<R> at(const R& s) const { return p + s * d; }
    /// Relative to p of a float32 t.
    R local(float t) const { return R(Wide<R>(t) - middle); }
};

/// Where the ray enters the body first, or leaves it where it starts inside.
template<class R>
struct ExactHit {
    bool hit = false, inside = false;
    Wide<R> t = 0;
    R s = 0;               ///< of the hit along the Line
    R tangency = R(1e30);  ///< how far the ray is from deciding otherwise, across itself, in scene units
    Vec3<R> point, normal; ///< relative to the body's middle; outward
};

template<class R>
Line<R> lineOf(const Body<R>& body, const Vec3<Wide<R>>& origin, const Vec3<Wide<R>>& direction) {
    const Vec3<Wide<R>> o = origin - body.middle();
    const Wide<R> middle = -dot(o, direction) / dot(direction, direction);
    return {Vec3<R>(o + middle * direction), Vec3<R>(direction), middle, R(-middle)};
}
template<class R>
Line<R> lineOf(const Body<R>& body, glm::vec3 origin, glm::vec3 direction) {
    return lineOf(body, Vec3<Wide<R>>(origin), Vec3<Wide<R>>(direction));
}

/// `from`: looks for hits later than the start by this much of t; 0, or past what a start on the surface is uncertain
/// by.
template<class R>
ExactHit<R> exactHitOfClosed(const Body<R>& body, const Line<R>& line, R from, int samples) {
    using std::sqrt;
    ExactHit<R> hit;
    const R step = length(line.d), reach = body.size() * R(1.01), gap = length(line.p);
    const R first = std::max<R>(line.start + from, -reach / step), last = reach / step;
    if (gap > reach || first >= last) {
        hit.tangency = std::max<R>(gap - body.size(), first >= last ? reach - body.size() : R(0));
        return hit;
    }
    const R atStart = body.distance(line.at(first));
    hit.inside = atStart < 0;
    const auto along = [&](const R& s) {
        const R f = body.distance(line.at(s));
        return hit.inside ? R(-f) : f;
    };
    const FirstRoot<R> root = firstRoot<R>(along, first, last, samples);
    hit.hit = root.hit;
    hit.s = root.t;
    hit.tangency =
        std::min<R>(root.tangency, hit.inside ? R(-atStart) : atStart); // a start on the surface: either side
    return hit;
}

/// A plane is met once: the equation is linear. The rim decides the rest.
template<class R>
ExactHit<R> exactHitOfFlat(const Body<R>& body, const Line<R>& line) {
    ExactHit<R> hit;
    const auto size = [](const R& x) { return x < 0 ? R(-x) : x; };
    const R facing = dot(line.d, body.axis()), above = dot(line.p, body.axis());
    const R startAbove = size(R(above + line.start * facing));
    if (facing != 0) hit.s = -above / facing;
    if (facing != 0 && hit.s > line.start) {
        const R within = body.withinRim(line.at(hit.s));
        hit.hit = within >= 0;
        hit.tangency = size(R(within * facing));
        if (hit.hit) hit.tangency = std::min<R>(hit.tangency, startAbove); // or it starts behind
    } else { // along the plane or away from it: how high it is by the time that it is over the body
        hit.tangency = startAbove + size(facing) * std::max<R>(-body.withinRim(line.at(line.start)), 0);
    }
    if (body.kind() == ShapeKind::Plane) hit.tangency = std::min<R>(hit.tangency, size(facing) * size(line.start));
    return hit;
}

/// `finer`: so many times the samples that the body's own turns need.
template<class R>
ExactHit<R> exactHit(const Body<R>& body, const Line<R>& line, R from = 0, int finer = 1) {
    const int samples = finer * (body.convex() ? 16 : 256); // along a convex body's rays there is one dip only
    ExactHit<R> hit = body.closed() ? exactHitOfClosed(body, line, from, samples) : exactHitOfFlat(body, line);
    hit.t = line.middle + Wide<R>(hit.s);
    hit.point = line.at(hit.s);
    if (hit.hit) hit.normal = body.normal(hit.point);
    return hit;
}

} // namespace gnomon::oracle
