/// A sphere so large that the camera stands on its ground, in long double.
#pragma once

#include "lab/reference/exact/scene_hit.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <string>

namespace gnomon::test {

using oracle::Vec;
using Real = long double;

inline Real ulp(Real x) { return std::ldexp(1.0L, std::ilogb(x) - 23); }

inline std::string format(const char* pattern, ...) {
    char text[1000];
    va_list values;
    va_start(values, pattern);
    std::vsnprintf(text, sizeof text, pattern, values);
    va_end(values);
    return text;
}

inline std::string text(Vec v) { return format("[%.17Lg, %.17Lg, %.17Lg]", v.x, v.y, v.z); }

/// A sphere that passes the origin closely, with a tilted ground and numbers that float32 does not hold.
struct Ground {
    Real radius;
    Vec up, along, across; ///< at the origin
    Vec center;

    explicit Ground(Real r) : radius(r * 1.0000001234567L), up(glm::normalize(Vec(0.3123L, 0.8765L, -0.4321L))) {
        along = glm::normalize(glm::cross(up, Vec(0, 0, 1)));
        across = glm::cross(along, up);
        const glm::dvec3 held(Vec(0.1234567L, -0.2345678L, 0.3456789L) - radius * up);
        radius = double(radius); // what the scene's doubles hold
        center = Vec(held);
    }
    Real distance(Vec p) const { return glm::length(p - center) - radius; }
    /// The point `height` above the ground, x along it and z across it from the place under the eye.
    Vec over(Real x, Real z, Real height) const {
        return center + (radius + height) * glm::normalize(radius * up + x * along + z * across);
    }
    /// The camera stands so near to the ground that it is drawn in its anchored form, about the point over(0, 0, 0).
    std::string json(const std::string& more = "") const {
        return R"({"camera": {"eye": )" + text(over(0, 0, radius / 1000)) + R"(, "target": )" + text(over(1, 0, 0)) +
               R"(}, "objects": [)" + sphere() + more + "]}";
    }
    std::string sphere() const {
        return R"({"sphere": {"center": )" + text(center) + format(R"(, "radius": %.17Lg}})", radius);
    }
};

/// How far float32 may put the surface off at a point D from the anchor: the bent plane's terms are D and D² / 2r
/// large.
inline Real boundAt(const Ground& ground, Vec p) {
    const Real away = glm::length(p - ground.over(0, 0, 0));
    return std::ldexp(away * (1 + away / (2 * ground.radius)), -22);
}

/// Both roots along a ray, and how far it is from tangency, about the closest approach to the centre.
struct Chord {
    Real entry = 0, leave = 0;
    Real depth;  ///< of the closest approach below the surface; negative where the ray passes by
    Vec deepest; ///< the point of closest approach
    Real t;      ///< where that is

    Chord(Vec center, Real radius, Vec o, Vec d) {
        const Vec toOrigin = o - center;
        const Real a = glm::dot(d, d);
        t = -glm::dot(toOrigin, d) / a;
        const Real gap = glm::length(toOrigin + t * d);
        depth = radius - gap;
        deepest = o + t * d;
        const Real half = depth > 0 ? std::sqrt(depth * (radius + gap) / a) : 0;
        entry = t - half;
        leave = t + half;
    }
};

} // namespace gnomon::test
