/// The shadow model `silhouette` on the GPU against exact fractions of the light's disc, in double: closed forms where
/// there are some, else many rays of the oracle. Receivers look up along z at a light 6 away; a length over slope *
/// height is one in units of the disc.

#include "lab/batch/light_batch.h"
#include "lab/intersect/subjects.h"
#include "lab/reference/exact/exact_hit.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/plan/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace gnomon {
namespace {

using namespace test;
using namespace oracle;

constexpr double kPi = 3.14159265358979323846;
constexpr double kHigh = 6;
constexpr double kRadii[] = {0.05, 0.2, 0.5, 1, 2, 4};
constexpr double kAlone = 1e-3; ///< one caster, or several that do not overlap
constexpr double kRound = 2e-3; ///< with rims
constexpr double kUnited = 0.01;
constexpr double kSliver = 4e-3; ///< where one of several lies between the mask's points

double slopeOf(double radius, double distance = kHigh) {
    const double sine = std::min(radius / distance, 0.999);
    return sine / std::sqrt(1 - sine * sine);
}

/// Of the unit disc beyond the chord at r, over pi.
double tau(double r) {
    r = std::clamp(r, -1.0, 1.0);
    return (std::acos(r) - r * std::sqrt(1 - r * r)) / kPi;
}

/// Of the unit disc where x > a and y > b, over pi.
double quadrant(double a, double b) {
    const int steps = 20000;
    const double from = std::clamp(a, -1.0, 1.0), step = (1 - from) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double x = from + (i + 0.5) * step, w = std::sqrt(1 - x * x);
        sum += std::max(w - std::max(b, -w), 0.0) * step;
    }
    return sum / kPi;
}

/// Common area of the unit disc and one of radius r at distance d, over pi.
double lens(double r, double d) {
    if (d >= 1 + r) return 0;
    if (d <= std::abs(1 - r)) return std::min(1.0, r * r);
    const double a = std::acos((d * d + 1 - r * r) / (2 * d)), b = std::acos((d * d + r * r - 1) / (2 * d * r));
    return (a - 0.5 * std::sin(2 * a) + r * r * (b - 0.5 * std::sin(2 * b))) / kPi;
}

BatchLit lookingUp(glm::dvec3 point, double radius) {
    BatchLit lit;
    lit.point = point;
    lit.light = point + glm::dvec3(0, 0, kHigh);
    lit.radius = float(radius);
    return lit;
}

std::vector<double> visibilities(const std::vector<Shape>& shapes, const std::vector<BatchLit>& lit) {
    offscreen();
    Settings settings;
    settings.shadows = ShadowModel::Silhouette;
    Problems problems;
    LightBatch batch(sceneOf(shapes), settings, problems);
    EXPECT_TRUE(batch.valid()) << toString(problems);
    std::vector<double> answers(lit.size(), -1.0);
    if (!batch.valid()) return answers;
    const auto shades = batch.shade(lit);
    for (std::size_t i = 0; i < lit.size(); ++i) answers[i] = shades[i].visibility;
    return answers;
}

Shape box(glm::dvec3 low, glm::dvec3 high) {
    return makeShape(ShapeKind::Box, {0.5 * (low + high), 0.5 * (high - low)});
}
Shape ball(glm::dvec3 center, double radius) { return makeShape(ShapeKind::Sphere, {center}, {radius}); }
Shape plane(glm::dvec3 point, glm::dvec3 normal) { return makeShape(ShapeKind::Plane, {point, normal}); }

/// Receivers moved along x so that an edge at x = 0 and the height lies at -1.3 … 1.3 discs, for every radius; each
/// against `exact(x of the edge, slope)`.
void expectAlong(const std::vector<Shape>& shapes, double height, double bound,
                 const std::function<double(double, double)>& exact, double y = 0) {
    std::vector<BatchLit> lit;
    std::vector<double> expected;
    for (const double radius : kRadii)
        for (int i = -13; i <= 13; ++i) {
            const double slope = slopeOf(radius), x = (0.1 * i + 0.003) * height * slope;
            lit.push_back(lookingUp({-x, y * height * slope, 0}, radius));
            expected.push_back(exact(x, slope));
        }
    const auto answers = visibilities(shapes, lit);
    for (std::size_t i = 0; i < lit.size(); ++i)
        EXPECT_NEAR(answers[i], expected[i], bound) << "radius " << lit[i].radius << ", edge at " << -lit[i].point.x;
}

TEST(Silhouette, OfAPlaneIsAHalfPlane) {
    expectAlong({plane({0, 0, 0}, {1, 0, 0})}, kHigh, kAlone,
                [](double x, double slope) { return 1 - tau(std::abs(x) / (kHigh * slope)); });
}

TEST(Silhouette, OfAThickEdgeIsThatOfItsNearerRim) {
    expectAlong({box({0, -20, 3}, {20, 20, 5})}, 3, kAlone,
                [](double x, double slope) { return 1 - tau(std::min(x / 3, x / 5) / slope); });
}

constexpr double kThin = 1e-4;
double edgeAt(double x, double slope) { return tau(std::min(x / 3, x / (3 + kThin)) / slope); }

TEST(Silhouette, OfAStripIsBetweenItsEdges) {
    expectAlong({box({0, -20, 3}, {0.7, 20, 3 + kThin})}, 3, kAlone,
                [](double x, double slope) { return 2 - edgeAt(x, slope) - edgeAt(-x - 0.7, slope); });
}

TEST(Silhouette, OfASlitLeavesWhatIsBetween) {
    expectAlong({box({-20, -20, 3}, {0, 20, 3 + kThin}), box({0.4, -20, 3}, {20, 20, 3 + kThin})}, 3, kSliver,
                [](double x, double slope) { return std::max(0.0, 1 - edgeAt(-x, slope) - edgeAt(x + 0.4, slope)); });
}

TEST(Silhouette, OfManyStripsAddsUp) {
    std::vector<Shape> strips;
    for (int i = 0; i < 5; ++i) strips.push_back(box({0.3 * i, -20, 3}, {0.3 * i + 0.1, 20, 3 + kThin}));
    expectAlong(strips, 3, kSliver, [](double x, double slope) {
        double seen = 1;
        for (int i = 0; i < 5; ++i) {
            const double from = x + 0.3 * i;
            seen -= tau(from / (3 * slope)) - tau((from + 0.1) / (3 * slope));
        }
        return seen;
    });
}

TEST(Silhouette, OfACornerIsAQuadrant) {
    for (const double y : {-0.6, 0.25})
        expectAlong(
            {box({0, 0, 3}, {20, 20, 3 + kThin})}, 3, kAlone,
            [&](double x, double slope) { return 1 - quadrant(x / (3 * slope), -y); }, y);
}

TEST(Silhouette, OfCrossingPlanesLeavesAQuadrant) {
    for (const double y : {-0.6, -0.2})
        expectAlong(
            {plane({0, 0, 0}, {1, 0, 0}), plane({0, 0, 0}, {0, 1, 0})}, kHigh, kUnited,
            [&](double x, double slope) { return quadrant(-std::abs(x) / (kHigh * slope), -std::abs(y)); }, y);
}

TEST(Silhouette, OfAWedgeOnTheAxisIsItsAngle) {
    for (const double opening : {0.2, 1.0, 2.0, 2.8}) {
        std::vector<BatchLit> lit;
        for (const double radius : kRadii) lit.push_back(lookingUp({0, 0, 0}, radius));
        const double a = opening / 2;
        const auto answers = visibilities({makeShape(ShapeKind::Triangle, {{0, 0, 3},
                                                                           {900 * std::cos(a), -900 * std::sin(a), 3},
                                                                           {900 * std::cos(a), 900 * std::sin(a), 3}})},
                                          lit);
        for (const double answer : answers) EXPECT_NEAR(answer, 1 - opening / (2 * kPi), kAlone) << opening;
    }
}

TEST(Silhouette, OfADiscIsALens) {
    for (const double size : {0.3, 1.0, 3.0})
        expectAlong({makeShape(ShapeKind::Disc, {{0, 0, 3}, {0, 0, 1}}, {size})}, 3, kRound,
                    [&](double x, double slope) { return 1 - lens(size / (3 * slope), std::abs(x) / (3 * slope)); });
}

/// Fraction of the disc that rays of the oracle see, on a grid of equal cells.
double seenByRays(const std::vector<Shape>& shapes, const BatchLit& lit, int rings = 48, int spokes = 96) {
    std::vector<ExactShape<double>> exactShapes;
    for (const Shape& shape : shapes) exactShapes.emplace_back(shape);
    const glm::dvec3 toLight = glm::dvec3(lit.light) - glm::dvec3(lit.point);
    const double distance = glm::length(toLight), slope = slopeOf(lit.radius, distance);
    const glm::dvec3 axis = toLight / distance,
                     first = glm::normalize(
                         glm::cross(axis, std::abs(axis.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0))),
                     second = glm::cross(axis, first);
    int seen = 0;
    for (int ring = 0; ring < rings; ++ring)
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const double r = std::sqrt((ring + 0.5) / rings), phi = 2 * kPi * (spoke + 0.5 + 0.382 * ring) / spokes;
            const glm::dvec3 d = axis + slope * r * (std::cos(phi) * first + std::sin(phi) * second);
            bool blocked = false;
            for (std::size_t i = 0; i < exactShapes.size() && !blocked; ++i) {
                using W = Wide<double>;
                const auto line = lineOf(exactShapes[i], Vec3<W>(glm::dvec3(lit.point)), Vec3<W>(d));
                const ExactHit<double> hit = exactHit(exactShapes[i], line);
                blocked = hit.hit && hit.t < distance;
            }
            seen += !blocked;
        }
    return double(seen) / (rings * spokes);
}

struct Errors {
    double rms = 0, worst = 0;
};
Errors againstRays(const std::vector<Shape>& shapes, const std::vector<BatchLit>& lit) {
    const auto answers = visibilities(shapes, lit);
    Errors errors;
    for (std::size_t i = 0; i < lit.size(); ++i) {
        const double error = std::abs(answers[i] - seenByRays(shapes, lit[i]));
        errors.rms += error * error / double(lit.size());
        errors.worst = std::max(errors.worst, error);
    }
    errors.rms = std::sqrt(errors.rms);
    return errors;
}

/// A turned shape of about unit size in the middle, the light about it on all sides and at all sizes.
std::vector<BatchLit> aboutTheMiddle(std::uint64_t seed, int count, double least = 1.6) {
    RayStream dice(ball({0, 0, 0}, 1), RayClass::Uniform, 3, seed);
    std::vector<BatchLit> lit;
    for (int i = 0; i < count; ++i) {
        const Vec3<double> out = dice.direction(), off = dice.direction();
        const double away = dice.number(least, 4), beyond = dice.number(least, 4);
        BatchLit one;
        const glm::dvec3 point(away * out.x, away * out.y, away * out.z);
        const glm::dvec3 shift = dice.number(0, 1.2) * glm::dvec3(off.x, off.y, off.z);
        one.point = point;
        one.light = shift - beyond / away * point;
        one.radius = float(std::pow(10.0, dice.number(-1.3, 0.3)));
        one.normal = glm::normalize(one.light - one.point);
        lit.push_back(one);
    }
    return lit;
}

class SilhouetteOf : public testing::TestWithParam<Subject> {};

TEST_P(SilhouetteOf, AloneIsWhatRaysSee) {
    const Subject& subject = GetParam();
    const Shape shape = placed(subject, RayClass::Uniform, 3);
    const glm::dvec3 middle(0.3, -0.7, 1.1);
    auto lit = aboutTheMiddle(7, 120, shape.kind == ShapeKind::Torus ? 2.2 : 1.6); // outside of it
    for (BatchLit& one : lit) one.point += middle, one.light += middle;
    const Errors errors = againstRays({shape}, lit);
    std::printf("%-18s rms %.4f worst %.4f\n", subject.name().c_str(), errors.rms, errors.worst);
    // The grid of rays itself is good to .003 (.001 rms).
    EXPECT_LE(errors.rms, shape.kind == ShapeKind::Torus ? 0.002 : 0.001);
    EXPECT_LE(errors.worst, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Shapes, SilhouetteOf, testing::ValuesIn(subjects()),
                         [](const auto& test) { return test.param.name(); });

/// Shapes of all convex kinds but the plane, from 0.4 to 1 in size, about the middle.
std::vector<Shape> crowd(std::uint64_t seed, int count) {
    RayStream dice(ball({0, 0, 0}, 1), RayClass::Uniform, 3, seed);
    const auto point = [&](double reach) {
        return glm::dvec3(dice.number(-reach, reach), dice.number(-reach, reach), dice.number(-reach, reach));
    };
    std::vector<Shape> shapes;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 center = point(0.9), end = center + point(0.5);
        const double size = dice.number(0.15, 0.5);
        const Vec3<double> up = dice.direction();
        const glm::dvec3 axis(up.x, up.y, up.z);
        switch (int(dice.number(0, 7))) {
        case 0: shapes.push_back(ball(center, size)); break;
        case 1: shapes.push_back(makeShape(ShapeKind::Disc, {center, axis}, {size})); break;
        case 2:
            shapes.push_back(makeShape(ShapeKind::Triangle, {center, center + point(0.7), center + point(0.7)}));
            break;
        case 3: shapes.push_back(makeShape(ShapeKind::Box, {center, {size, 0.5 * size, 0.2}})); break;
        case 4: shapes.push_back(makeShape(ShapeKind::Cylinder, {center, end}, {0.5 * size})); break;
        case 5: shapes.push_back(makeShape(ShapeKind::Capsule, {center, end}, {0.5 * size})); break;
        default: shapes.push_back(makeShape(ShapeKind::Cone, {center, end}, {size})); break;
        }
    }
    return shapes;
}

TEST(Silhouette, OfACrowdIsWhatRaysSee) {
    double squares = 0, worst = 0;
    for (int i = 0; i < 6; ++i) {
        const Errors errors = againstRays(crowd(std::uint64_t(i), i + 1), aboutTheMiddle(std::uint64_t(50 + i), 200));
        std::printf("%d shapes: rms %.4f worst %.4f\n", i + 1, errors.rms, errors.worst);
        squares += errors.rms * errors.rms / 6;
        worst = std::max(worst, errors.worst);
    }
    EXPECT_LE(std::sqrt(squares), 0.002);
    EXPECT_LE(worst, 0.015);
}

TEST(Silhouette, CountsTwoOfOneSilhouetteOnce) {
    std::vector<BatchLit> lit;
    for (const double radius : kRadii)
        for (int i = 0; i < 20; ++i) lit.push_back(lookingUp({0.15 * i, 0, 0}, radius));
    const auto once = visibilities({ball({0, 0, 3}, 0.5)}, lit);
    const auto twice = visibilities({ball({0, 0, 3}, 0.5), ball({0, 0, 3}, 0.5)}, lit);
    for (std::size_t i = 0; i < lit.size(); ++i) EXPECT_NEAR(twice[i], once[i], kAlone) << i;
}

TEST(Silhouette, IsOfWhatLiesBetweenPointAndLightOnly) {
    std::vector<BatchLit> lit;
    for (const double radius : kRadii) lit.push_back(lookingUp({0, 0, 0}, radius));
    const std::vector<Shape> apart{ball({0, 0, -2}, 1),
                                   ball({0, 0, 8}, 1.5),
                                   box({-1, -1, 7}, {1, 1, 8}),
                                   box({-1, -1, -3}, {1, 1, -1}),
                                   plane({0, 0, 9}, {0, 0, 1}),
                                   makeShape(ShapeKind::Disc, {{0, 0, 6.5}, {0, 0, 1}}, {2}),
                                   makeShape(ShapeKind::Capsule, {{-1, 0, -1}, {1, 0, -1}}, {0.5}),
                                   makeShape(ShapeKind::Torus, {{0, 0, -2}, {0, 0, 1}}, {1, 0.5})};
    for (const double answer : visibilities(apart, lit)) EXPECT_NEAR(answer, 1, 1e-6);
    for (const Shape& whole : {ball({0, 0, 3}, 2.9), box({-20, -20, 3}, {20, 20, 9}), box({-20, -20, -9}, {20, 20, 2}),
                               ball({0, 0, 0.5}, 1), plane({0, 0, 1}, {0, 0, 1})})
        for (const double answer : visibilities({whole}, lit)) EXPECT_NEAR(answer, 0, 1e-4);
}

TEST(Silhouette, IsNoneWherePointAndLightAreOne) {
    BatchLit lit = lookingUp({1, 2, 3}, 0.5);
    lit.light = lit.point;
    EXPECT_EQ(visibilities({ball({0, 0, 0}, 1)}, {lit})[0], 1);
}

TEST(Silhouette, OfTheReceiverIsItsHorizon) {
    // On top of a unit ball, the light low: its disc is cut by the tangent plane.
    std::vector<BatchLit> lit;
    std::vector<double> expected;
    for (const double height : {-0.5, 0.0, 0.3, 0.9, 2.0}) {
        BatchLit one;
        one.point = {0, 0, 1};
        one.light = {8, 0, 1 + height};
        one.radius = 1;
        one.object = 0;
        lit.push_back(one);
        const double distance = std::sqrt(64 + height * height), slope = slopeOf(1, distance);
        expected.push_back(1 - tau(height / 8 / slope));
    }
    lit[0].normal = {0, 0, 1};
    const auto answers = visibilities({ball({0, 0, 0}, 1)}, lit);
    for (std::size_t i = 1; i < lit.size(); ++i) EXPECT_NEAR(answers[i], expected[i], kAlone);
}

TEST(Silhouette, DoesNotKnowTheSceneScale) {
    auto shapes = crowd(3, 5);
    const auto lit = aboutTheMiddle(9, 300);
    const auto before = visibilities(shapes, lit);
    for (const double scale : {1e-3, 1024.0}) {
        auto larger = crowd(3, 5);
        for (Shape& shape : larger)
            for (const ShapeField& field : shapeRow(shape.kind).fields)
                for (double& value : valuesOf(shape, field.key))
                    if (field.type != FieldType::Direction) value *= scale;
        auto moved = lit;
        for (BatchLit& one : moved) one.point *= scale, one.light *= scale, one.radius *= float(scale);
        const auto after = visibilities(larger, moved);
        for (std::size_t i = 0; i < lit.size(); ++i) EXPECT_NEAR(after[i], before[i], 0.01) << i;
    }
}

TEST(Silhouette, NeverShowsMoreAsABallGrows) {
    std::vector<Shape> balls;
    for (int i = 0; i < 30; ++i) balls.push_back(ball({40.0 * i, 0.4, 3}, 0.05 * (i + 1)));
    for (const double radius : kRadii) {
        std::vector<BatchLit> lit;
        for (int i = 0; i < 30; ++i) lit.push_back(lookingUp({40.0 * i, 0, 0}, radius));
        const auto answers = visibilities(balls, lit);
        for (std::size_t i = 1; i < lit.size(); ++i) EXPECT_LE(answers[i], answers[i - 1] + 2e-5) << radius << ' ' << i;
    }
}

TEST(Silhouette, IsTheSameFarFromTheWorldsOrigin) {
    const Scene scene = sceneFrom(R"({"camera": {"eye": [0, 7, 9], "target": [0, 0.3, 0], "fov": 45},
        "lights": [{"point": {"position": [3, 7, 2]}}],
        "objects": [{"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}},
            {"sphere": {"center": [-2, 1, 0], "radius": 0.8}}, {"box": {"center": [0, 0.6, 2],
                "half_size": [0.5, 0.6, 0.4]}},
            {"capsule": {"from": [1, 0.6, 0], "to": [2, 1.6, 1], "radius": 0.3}}]})");
    Settings settings;
    settings.size = {96, 72};
    settings.lightRadius = 1;
    settings.shadows = ShadowModel::Silhouette;
    const FloatImage here = outputOf(scene, settings, Aov::Visibility);
    const FloatImage there = outputOf(moved(scene, {1e5, -1e5, 1e5}), settings, Aov::Visibility);
    int unlike = 0, soft = 0;
    for (std::size_t i = 0; i < here.pixels.size(); ++i) {
        unlike += std::abs(here.pixels[i] - there.pixels[i]) > 2e-3;
        soft += here.pixels[i] > 0.01 && here.pixels[i] < 0.99;
    }
    EXPECT_GT(soft, 200);
    EXPECT_LE(unlike, 6) << "pixels whose ray meets another object";
}

} // namespace
} // namespace gnomon
