/// What a ray of float32 numbers meets of one shape, exactly.
#pragma once

#include "lab/reference/exact/exact_shape.h"
#include "lab/reference/exact/first_root.h"
#include "lab/reference/exact/patch_hit.h"

namespace gnomon::oracle {

template<class R>
struct Line {
    Vec3<R> p; ///< the point of the line nearest to the shape's middle, relative to it
    Vec3<R> d;
    Wide<R> middle; ///< t of p
    R start;        ///< the ray's start, relative to p in t

    Vec3<R> at(const R& s) const { return p + s * d; }
    /// Relative to p of a float32 t.
    R local(float t) const { return R(Wide<R>(t) - middle); }
};

/// Where the ray enters the shape first, or leaves it where it starts inside: below a patch.
template<class R>
struct ExactHit {
    bool hit = false, inside = false;
    Wide<R> t = 0;
    R s = 0;               ///< of the hit along the Line
    R tangency = R(1e30);  ///< how far the ray is from deciding otherwise, across itself, in scene units
    Vec3<R> point, normal; ///< relative to the shape's middle; outward
};

template<class R>
Line<R> lineOf(const ExactShape<R>& shape, const Vec3<Wide<R>>& origin, const Vec3<Wide<R>>& direction) {
    const Vec3<Wide<R>> o = origin - shape.middle();
    const Wide<R> middle = -dot(o, direction) / dot(direction, direction);
    return {Vec3<R>(o + middle * direction), Vec3<R>(direction), middle, R(-middle)};
}
template<class R>
Line<R> lineOf(const ExactShape<R>& shape, glm::vec3 origin, glm::vec3 direction) {
    return lineOf(shape, Vec3<Wide<R>>(origin), Vec3<Wide<R>>(direction));
}

/// `from`: looks for hits later than the start by this much of t; 0, or past what a start on the surface is uncertain
/// by.
template<class R>
ExactHit<R> exactHitOfClosed(const ExactShape<R>& shape, const Line<R>& line, R from, int samples) {
    using std::sqrt;
    ExactHit<R> hit;
    const R step = length(line.d), reach = shape.size() * R(1.01), gap = length(line.p);
    const R first = std::max<R>(line.start + from, -reach / step), last = reach / step;
    if (gap > reach || first >= last) {
        hit.tangency = std::max<R>(gap - shape.size(), first >= last ? reach - shape.size() : R(0));
        return hit;
    }
    const R atStart = shape.distance(line.at(first));
    hit.inside = atStart < 0;
    const auto along = [&](const R& s) {
        const R f = shape.distance(line.at(s));
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
ExactHit<R> exactHitOfFlat(const ExactShape<R>& shape, const Line<R>& line) {
    ExactHit<R> hit;
    const auto size = [](const R& x) { return x < 0 ? R(-x) : x; };
    const R facing = dot(line.d, shape.axis()), above = dot(line.p, shape.axis());
    const R startAbove = size(R(above + line.start * facing));
    if (facing != 0) hit.s = -above / facing;
    if (facing != 0 && hit.s > line.start) {
        const R within = shape.withinRim(line.at(hit.s));
        hit.hit = within >= 0;
        hit.tangency = size(R(within * facing));
        if (hit.hit) hit.tangency = std::min<R>(hit.tangency, startAbove); // or it starts behind
    } else { // along the plane or away from it: how high it is by the time that it is over the shape
        hit.tangency = startAbove + size(facing) * std::max<R>(-shape.withinRim(line.at(line.start)), 0);
    }
    if (shape.kind() == ShapeKind::Plane) hit.tangency = std::min<R>(hit.tangency, size(facing) * size(line.start));
    return hit;
}

/// By isolated roots (patch_hit.h).
template<class R>
ExactHit<R> exactHitOfPatch(const ExactShape<R>& shape, const Line<R>& line, R from) {
    const R first = line.start + from;
    const PatchHits<R> hits = hitsOf(shape.patch(), shape.alongAxes(line.p), shape.alongAxes(line.d), first);
    ExactHit<R> hit;
    hit.hit = !hits.t.empty();
    if (hit.hit) hit.s = hits.t.front();
    hit.inside = hits.below;
    hit.tangency = hits.tangency;
    return hit;
}

/// `finer`: so many times the samples that the shape's own turns need.
template<class R>
ExactHit<R> exactHit(const ExactShape<R>& shape, const Line<R>& line, R from = 0, int finer = 1) {
    const int samples = finer * (shape.convex() ? 16 : 256); // along a convex shape's rays there is one dip only
    ExactHit<R> hit = shape.closed() ? exactHitOfClosed(shape, line, from, samples)
                      : shape.flat() ? exactHitOfFlat(shape, line)
                                     : exactHitOfPatch(shape, line, from);
    hit.t = line.middle + Wide<R>(hit.s);
    hit.point = line.at(hit.s);
    if (hit.hit) hit.normal = shape.normal(hit.point);
    return hit;
}

} // namespace gnomon::oracle
