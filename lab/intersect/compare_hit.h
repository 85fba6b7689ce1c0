/// Holds the GPU's answer to a ray against the exact one.
#pragma once

#include "lab/batch/ray_batch.h"
#include "lab/reference/exact/exact_hit.h"

#include <cstdint>
#include <vector>

namespace gnomon::oracle {

/// What the header of a shape's file states.
struct Bounds {
    double band;   ///< no wrong decision farther than this from tangency, in scales (see Scale)
    double ray;    ///< of o + t d off the surface, in ulp of the distance
    double point;  ///< of the surface point off the surface, in roundings
    double normal; ///< of the normal from the exact one at the surface point: the turn of so many roundings' shift
};
Bounds boundsOf(ShapeKind);

/// What float32 can be held to for one ray. A rounding is 2^-23 of the shape's size and of the coordinates that its
/// points are written in. A plane has no size and scales with the distance; the plane of a sliver of a triangle turns
/// by a rounding over its height.
struct Scale {
    double band;     ///< the size
    double distance; ///< whose ulp counts: of the hit, of three sizes at least
    double rounding;
    double bend; ///< smallest radius of curvature; of a flat shape its smallest height
};
/// `p`: the told surface point, from the middle. `extent`: the radius of all of a scene's triangles together, which one
/// of them is as exact as.
Scale scaleOf(const ExactShape<double>&, const Line<double>&, const ExactHit<double>&, const Vec3<double>& p,
              double extent = 0);

/// One answer, compared. Errors are 0 where either side misses.
struct Verdict {
    bool decided = false; ///< exactly far enough from tangency that float32 has to be right
    bool hit = false;     ///< by both
    bool missed = false, invented = false;
    /// A hit, but t or the surface point is neither on the first sheet nor on the way along it; or, near a decision or
    /// not, no number or of another object than the one there is.
    bool elsewhere = false;
    double margin = 0; ///< of a decision unlike the exact one, in the band or not: how far from tangency, in scales
    double t = 0;      ///< |t - exact|, ulp
    double ray = 0;    ///< |distance of o + t d|, ulp
    double point = 0;  ///< |distance of the surface point|, roundings
    double normal = 0; ///< |normal - exact normal at the surface point|, roundings over the bend

    bool wrong() const { return missed || invented || elsewhere; }
};
Verdict compareHit(const ExactShape<double>&, const BatchRay&, const BatchHit&);
/// The same where the exact answer is known. The answer's object is 0 if it is this shape.
Verdict compareHit(const ExactShape<double>&, const Line<double>&, const ExactHit<double>&, const BatchHit&,
                   double extent = 0);

/// Somewhere on the way along the line from where it meets the surface to s it is farther than `slack` off the surface.
bool leavesSurface(const ExactShape<double>&, const Line<double>&, double met, double s, double slack);

/// Median, 99.9 % and largest of some values.
struct Spread {
    double median = 0, most = 0, worst = 0;
};
Spread spreadOf(std::vector<double> values);

/// Many verdicts.
struct Tally {
    std::int64_t rays = 0, decided = 0;
    std::int64_t hits = 0; ///< decided ones, whose errors follow
    std::int64_t missed = 0, invented = 0, elsewhere = 0;
    Spread t, ray, point, normal;
    double worstMargin = 0;
    std::vector<std::size_t> wrongRays;

    std::int64_t wrong() const { return missed + invented + elsewhere; }
    double decidedFraction() const { return rays ? double(decided) / double(rays) : 0; }
};
bool within(const Tally&, const Bounds&);
/// On all cores; one answer a ray.
Tally compareHits(const Shape&, const std::vector<BatchRay>&, const std::vector<BatchHit>&);

} // namespace gnomon::oracle
