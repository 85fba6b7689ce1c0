#include "tests/shader/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon::test {
namespace {

using Real = long double;
constexpr Real kNone = std::numeric_limits<Real>::infinity();

Vec vec(glm::dvec3 v) { return Vec(glm::vec3(v)); } // the shader's numbers are float32
Vec point(const Shape& s, int texel) { return vec(glm::dvec3(s.texels[texel])); }
Real scalar(const Shape& s, int texel) { return Real(float(s.texels[texel].w)); }

using Vec2 = glm::tvec2<Real>;

Real toStretch(Vec2 p, Vec2 a, Vec2 b) {
    const Real along = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), Real(0), Real(1));
    return glm::length(p - (a + along * (b - a)));
}

Real boxDistance(Vec outside) {
    const Real inside = std::max({outside.x, outside.y, outside.z});
    return glm::length(glm::max(outside, Vec(0))) + std::min<Real>(inside, 0);
}

/// Of the shapes about an axis, in the half plane of the axis: x away from it, y along it from `from`.
struct Profile {
    Vec2 p;
    Real length, radius;
};

Profile profile(const Shape& s, Vec p) {
    const Vec axis = point(s, 1) - point(s, 0), local = p - point(s, 0);
    const Real length = glm::length(axis), along = glm::dot(local, axis) / length;
    return {Vec2(glm::length(local - along * (axis / length)), along), length, scalar(s, 0)};
}

Real coneDistance(const Profile& q) {
    const Vec2 apex(0, q.length), rim(q.radius, 0);
    const bool inside = q.p.y > 0 && q.p.y < q.length && q.p.x * q.length < q.radius * (q.length - q.p.y);
    const Real away = std::min(toStretch(q.p, Vec2(0), rim), toStretch(q.p, rim, apex));
    return inside ? -away : away;
}

/// Signed distances, negative inside, of the closed shapes.
Real distance(const Shape& s, Vec p) {
    const Vec local = p - point(s, 0);
    if (s.kind == ShapeKind::Box) return boxDistance(glm::abs(local) - point(s, 1));
    if (s.kind == ShapeKind::Cylinder) {
        const Profile q = profile(s, p);
        return boxDistance(Vec(q.p.x - q.radius, std::abs(q.p.y - q.length / 2) - q.length / 2, -1e30L));
    }
    if (s.kind == ShapeKind::Capsule) {
        const Profile q = profile(s, p);
        return toStretch(q.p, Vec2(0), Vec2(0, q.length)) - q.radius;
    }
    if (s.kind == ShapeKind::Cone) return coneDistance(profile(s, p));
    if (s.kind == ShapeKind::Sphere) return glm::length(local) - scalar(s, 0);
    const Vec axis = glm::normalize(point(s, 1));
    const Real along = glm::dot(local, axis);
    const Real across = glm::length(local - along * axis);
    return std::hypot(across - scalar(s, 0), along) - scalar(s, 1);
}

Vec gradient(const Shape& s, Vec p) {
    const Real h = 1e-7L;
    Vec g;
    for (int i = 0; i < 3; ++i) {
        Vec step(0);
        step[i] = h;
        g[i] = distance(s, p + step) - distance(s, p - step);
    }
    return glm::normalize(g);
}

struct Candidate {
    Real t = kNone, margin = 1e30L;
    Vec normal{0};
    Real edge = 1e30L, turn = 0;
};

/// First change of sign of the distance between the bounds of a sphere about the shape.
Candidate closed(const Shape& s, Vec o, Vec d) {
    const Real reach = scalar(s, 0) + (s.kind == ShapeKind::Torus ? scalar(s, 1) : 0);
    const Vec toCenter = point(s, 0) - o;
    const Real middle = glm::dot(toCenter, d), gap = glm::length(toCenter - middle * d);
    if (gap > reach) return {kNone, gap - reach, {}};
    const Real half = std::sqrt(reach * reach - gap * gap) * (1 + 1e-12L) + 1e-12L;
    const Real from = std::max<Real>(middle - half, 0), to = middle + half;
    if (to <= 0) return {};
    const int samples = s.kind == ShapeKind::Sphere ? 64 : 512;
    Candidate found;
    const bool inside = distance(s, o + from * d) < 0;
    Real before = from, nearest = kNone;
    for (int i = 1; i <= samples; ++i) {
        const Real t = from + (to - from) * i / samples;
        const Real value = distance(s, o + t * d);
        nearest = std::min(nearest, std::abs(value));
        if ((value < 0) != inside) {
            Real low = before, high = t;
            for (int k = 0; k < 100; ++k) {
                const Real mid = (low + high) / 2;
                ((distance(s, o + mid * d) < 0) == inside ? low : high) = mid;
            }
            found.t = (low + high) / 2;
            found.normal = gradient(s, o + found.t * d);
            const Real cosine = std::abs(glm::dot(found.normal, d));
            found.margin = cosine * cosine * (s.kind == ShapeKind::Sphere ? scalar(s, 0) : scalar(s, 1)) / 2;
            return found;
        }
        before = t;
    }
    found.margin = nearest;
    return found;
}

/// How far a point of the surface is from the nearest edge, and how fast the normal turns about an apex.
void describeEdges(const Shape& s, Vec p, Candidate& candidate) {
    if (s.kind == ShapeKind::Box) {
        const Vec away = glm::abs(glm::abs(p - point(s, 0)) - point(s, 1));
        candidate.edge = std::max(std::min(away.x, away.y), std::min(std::max(away.x, away.y), away.z)); // the second
        return;
    }
    const Profile q = profile(s, p);
    if (s.kind == ShapeKind::Cylinder)
        candidate.edge = std::hypot(q.p.x - q.radius, q.length / 2 - std::abs(q.p.y - q.length / 2));
    if (s.kind == ShapeKind::Cone) {
        candidate.edge = std::min(std::hypot(q.p.x - q.radius, q.p.y), std::hypot(q.p.x, q.p.y - q.length));
        if (q.p.y > q.length * 1e-9L) candidate.turn = 1 / q.p.x;
    }
}

/// The distance from a convex body is convex along a ray: its least value is found by ternary search and says whether
/// the ray hits and how narrowly; on each side of it there is at most one change of sign.
Candidate convex(const Shape& s, Vec o, Vec d) {
    const Vec middle = s.kind == ShapeKind::Box ? point(s, 0) : (point(s, 0) + point(s, 1)) / Real(2);
    const Real reach =
        s.kind == ShapeKind::Box ? glm::length(point(s, 1)) : glm::length(point(s, 1) - point(s, 0)) / 2 + scalar(s, 0);
    const Real closest = glm::dot(middle - o, d), gap = glm::length(middle - o - closest * d);
    const Real from = std::max<Real>(closest - reach - 1, 0), to = closest + reach + 1;
    if (gap > reach) return {kNone, gap - reach, {}};
    if (to <= 0) return {};
    const auto at = [&](Real t) { return distance(s, o + t * d); };
    Real low = from, high = to;
    for (int k = 0; k < 70; ++k) {
        const Real a = low + (high - low) / 3, b = high - (high - low) / 3;
        const bool before = at(a) < at(b);
        (before ? high : low) = before ? b : a;
    }
    const Real deepest = (low + high) / 2, least = at(deepest);
    Candidate found;
    found.margin = std::abs(least);
    if (!(least < 0)) return found;
    const bool inside = at(from) < 0;
    low = inside ? deepest : from;
    high = inside ? to : deepest;
    for (int k = 0; k < 64; ++k) {
        const Real mid = (low + high) / 2;
        ((at(mid) < 0) == inside ? low : high) = mid;
    }
    found.t = (low + high) / 2;
    found.normal = gradient(s, o + found.t * d);
    describeEdges(s, o + found.t * d, found);
    return found;
}

Candidate flat(const Shape& s, Vec o, Vec d, Vec anchor, Vec normal) {
    const Real facing = glm::dot(normal, d);
    const Real t = glm::dot(normal, anchor - o) / facing;
    if (!(t > 0)) return {};
    const Vec p = o + t * d;
    Candidate candidate{t, 1e30L, normal};
    if (s.kind == ShapeKind::Disc) {
        const Real rim = scalar(s, 0) - glm::length(p - anchor);
        candidate.margin = std::abs(rim * facing);
        if (rim < 0) candidate.t = kNone;
    }
    if (s.kind == ShapeKind::Triangle) {
        Real least = kNone;
        for (int i = 0; i < 3; ++i) {
            const Vec a = point(s, i), b = point(s, (i + 1) % 3);
            least = std::min(least, glm::dot(glm::cross(normal, glm::normalize(b - a)), p - a));
        }
        candidate.margin = std::abs(least * facing);
        if (least < 0) candidate.t = kNone;
    }
    return candidate;
}

Candidate meet(const Shape& s, Vec o, Vec d) {
    switch (s.kind) {
    case ShapeKind::Sphere:
    case ShapeKind::Torus: return closed(s, o, d);
    case ShapeKind::Box:
    case ShapeKind::Cylinder:
    case ShapeKind::Capsule:
    case ShapeKind::Cone: return convex(s, o, d);
    case ShapeKind::Plane:
    case ShapeKind::Disc: return flat(s, o, d, point(s, 0), glm::normalize(point(s, 1)));
    case ShapeKind::Triangle: {
        const Vec a = point(s, 0);
        return flat(s, o, d, a, glm::normalize(glm::cross(point(s, 1) - a, point(s, 2) - a)));
    }
    case ShapeKind::Globe: break; // what a sphere may be drawn as, never a scene's own: tests/shader/globe_test.cpp
    }
    return {};
}

} // namespace

long double signedDistance(const Shape& shape, Vec p) { return distance(shape, p); }

OracleHit oracleHit(const std::vector<Shape>& shapes, Vec o, Vec d) {
    OracleHit hit;
    hit.t = kNone;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Candidate candidate = meet(shapes[i], o, d);
        hit.margin = std::min(hit.margin, candidate.margin);
        // Two surfaces at nearly one distance: which is first may be rounding.
        if (candidate.t < kNone && hit.t < kNone) hit.margin = std::min(hit.margin, std::abs(candidate.t - hit.t));
        if (candidate.t >= hit.t) continue;
        hit.object = int(i);
        hit.t = candidate.t;
        hit.edge = candidate.edge;
        hit.turn = candidate.turn;
        hit.normal = glm::dot(candidate.normal, d) > 0 ? -candidate.normal : candidate.normal;
    }
    hit.point = hit.object < 0 ? Vec(0) : o + hit.t * d;
    return hit;
}

void pixelRay(const CameraPose& pose, int x, int y, int width, int height, Vec& origin, Vec& direction) {
    const CameraFrame frame = frameOf(pose);
    const Real u = 2 * (Real(x) + 0.5L) / width - 1, v = 1 - 2 * (Real(y) + 0.5L) / height;
    origin = vec(frame.eye);
    direction = glm::normalize(vec(frame.forward) + u * vec(frame.right * frame.halfHeight * (double(width) / height)) +
                               v * vec(frame.up * frame.halfHeight));
}

} // namespace gnomon::test
