/// Sets of spheres, rays among them, and what such a ray meets first when all of them are asked.
#pragma once

#include "tracer/accel/bounds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace gnomon::test {

inline constexpr float kNothing = 3e38f;

/// The same numbers with every library.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}
    double number(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
    glm::dvec3 point(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }

  private:
    std::mt19937_64 random_;
};

/// How many of `count` random rays a test takes: sanitizers watch what is read and written, for which a fifth will do.
inline int sampled(double count) {
#ifdef GNOMON_SANITIZED
    count /= 5;
#endif
    return int(count);
}

using Spheres = std::vector<Shape>;

/// Of float32 values.
inline Shape sphere(glm::dvec3 center, double radius) {
    return inFloat(makeShape(ShapeKind::Sphere, {center}, {radius}));
}

/// In a cube of half side 1. `cover` is how many of them a line through the middle meets, whatever their number.
inline Spheres inACube(int count, double cover, std::uint64_t seed = 1) {
    Dice dice(seed);
    const double radius = std::sqrt(cover * 4 / (3.14159265 * count));
    Spheres all;
    for (int i = 0; i < count; ++i) all.push_back(sphere(dice.point(1), radius));
    return all;
}

/// On the ground about the origin.
inline Spheres onTheGround(int count) {
    Dice dice(2);
    Spheres all;
    for (int i = 0; i < count; ++i)
        all.push_back(sphere({dice.number(-1, 1), 0, dice.number(-1, 1)}, 0.4 / std::sqrt(count)));
    return all;
}

inline Spheres clustered(int count) {
    Dice dice(3);
    Spheres all;
    glm::dvec3 middle(0);
    for (int i = 0; i < count; ++i) {
        if (i % 40 == 0) middle = dice.point(1);
        all.push_back(sphere(middle + dice.point(0.02), 0.004 * std::exp2(dice.number(-3, 1))));
    }
    return all;
}

inline Spheres regular(int side) {
    Spheres all;
    for (int i = 0; i < side * side * side; ++i)
        all.push_back(sphere(glm::dvec3(i % side, i / side % side, i / side / side) * (2.0 / side) - 1.0, 0.6 / side));
    return all;
}

inline Spheres allEqual(int count) { return Spheres(std::size_t(count), sphere({0.25, -0.5, 0.125}, 0.5)); }

inline Spheres inALine(int count) {
    Spheres all;
    for (int i = 0; i < count; ++i) all.push_back(sphere({2.0 * i / count - 1, 0, 0}, 0.9 / count));
    return all;
}

/// Each a thousandth farther out and larger than the last: the middles crowd at one end.
inline Spheres growing(int count) {
    Spheres all;
    for (int i = 0; i < count; ++i) {
        const double scale = std::pow(1e-6, double(i) / count);
        all.push_back(sphere({scale, -scale, 0.5 * scale}, 0.1 * scale));
    }
    return all;
}

inline const std::map<std::string, Spheres>& clouds() {
    static const std::map<std::string, Spheres> all{
        {"1", inACube(1, 0.2)},        {"2", inACube(2, 0.2)},           {"3", inACube(3, 0.5)},
        {"9", inACube(9, 1)},          {"random", inACube(300, 1)},      {"random 10000", inACube(10000, 1)},
        {"ground", onTheGround(2000)}, {"clustered", clustered(2000)},   {"regular", regular(9)},
        {"equal", allEqual(100)},      {"equal 10000", allEqual(10000)}, {"line", inALine(1000)},
        {"growing", growing(500)}};
    return all;
}

inline std::vector<Bounds> boundsOfAll(const std::vector<Shape>& shapes) {
    std::vector<Bounds> bounds;
    for (const Shape& shape : shapes) bounds.push_back(*boundsOf(shape));
    return bounds;
}

struct Ray {
    glm::vec3 origin, direction;
};

/// From up to `distance` away from `middle`, towards some place within 1 of it or past one of the spheres.
inline Ray rayAmong(Dice& dice, const Spheres& balls, double distance, glm::dvec3 middle = glm::dvec3(0)) {
    const glm::dvec3 from = middle + dice.point(1) * distance;
    const Shape& ball = balls[std::size_t(dice.number(0, double(balls.size())))];
    const glm::dvec3 center = pointOf(ball, "center");
    const glm::dvec3 to =
        dice.number(0, 1) < 0.5 ? middle + dice.point(1) : center + dice.point(lengthOf(ball, "radius"));
    glm::dvec3 way = to - from;
    if (dice.number(0, 1) < 0.1) way[int(dice.number(0, 3))] = 0; // along a box's faces
    return {from, glm::normalize(way)};
}

/// In double: to float32 rays and spheres as good as exact. Negative: no hit.
inline double distanceTo(const Shape& ball, const Ray& ray) {
    const glm::dvec3 o = glm::dvec3(ray.origin) - pointOf(ball, "center"), d(ray.direction);
    const double radius = lengthOf(ball, "radius"), a = glm::dot(d, d), middle = -glm::dot(o, d) / a;
    const double gap = glm::length(o + middle * d);
    const double square = (radius - gap) * (radius + gap) / a;
    if (square < 0) return -1;
    const double half = std::sqrt(square);
    return middle - half > 0 ? middle - half : middle + half;
}

/// What a walk has come to. Ties go to the lower number, so that any order of asking finds the same.
struct Nearest {
    double t = kNothing;
    int primitive = -1;

    void offer(int other, double otherT) {
        if (!(otherT > 0) || otherT > t || (otherT == t && other > primitive)) return;
        t = otherT;
        primitive = other;
    }
};

inline Nearest asked(const Spheres& balls, const Ray& ray) {
    Nearest nearest;
    for (std::size_t i = 0; i < balls.size(); ++i) nearest.offer(int(i), distanceTo(balls[i], ray));
    return nearest;
}

} // namespace gnomon::test
