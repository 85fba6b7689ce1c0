// Boxes of shapes against their exact distances: they hold every point of the surface, and not much more.
#include "tracer/accel/bounds.h"

#include "lab/intersect/subjects.h"
#include "tracer/plan/shape_texels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gnomon {
namespace {

using oracle::ExactShape;
using oracle::RayClass;
using oracle::RayStream;
using Vec = oracle::Vec3<double>;

constexpr int kPoints = 1'000'000; ///< of each shape's surface

/// What rounding or a careless formula would get wrong.
std::vector<Shape> hardShapes(ShapeKind kind) {
    switch (kind) {
    case ShapeKind::Disc: return {makeShape(kind, {{0, 3, 0}, glm::normalize(glm::dvec3(1e-4, 1, 2e-6))}, {30})};
    case ShapeKind::Torus:
        return {makeShape(kind, {{0.1, 0.1, 0.1}, glm::normalize(glm::dvec3(3e-5, 0, 1))}, {1, 1e-6})};
    case ShapeKind::Cylinder: // the rounding of its ends turns it
        return {makeShape(kind, {{1000.3, 2.1, 1.7}, {1000.3001, 2.10003, 1.7}}, {5}),
                makeShape(kind, {{0, 0, 0}, {1, 1, 1e-3}}, {1e-6})};
    case ShapeKind::Cone: return {makeShape(kind, {{1000.3, 2.1, 1.7}, {1000.3001, 2.10003, 1.7}}, {5})};
    default: return {};
    }
}

/// Turned and off the origin, upright in it, far from it, and hard ones.
std::vector<Shape> shapesOf(ShapeKind kind) {
    std::vector<Shape> shapes = hardShapes(kind);
    for (const oracle::Subject& subject : oracle::subjects()) {
        if (subject.geometry.kind != kind) continue;
        shapes.push_back(placed(subject, RayClass::Uniform, 1));
        shapes.push_back(placed(subject, RayClass::Axis, 1));
        shapes.push_back(placed(subject, RayClass::Inside, 1e4));
    }
    return shapes;
}

class BoundsOfShape : public testing::TestWithParam<ShapeKind> {};

TEST_P(BoundsOfShape, HoldEveryPointOfTheSurface) {
    const std::vector<Shape> shapes = shapesOf(GetParam());
    for (const Shape& shape : shapes) {
        const ExactShape<double> exactShape(shape);
        const Bounds box = *boundsOf(shape);
        const auto band = (long double)(0x1p-21 * exactShape.size());
        RayStream stream(shape, RayClass::Uniform, 3, 1);
        int outside = 0;
        for (int n = kPoints / int(shapes.size()); n > 0; --n) {
            oracle::Vec3<long double> p = exactShape.middle() + oracle::Vec3<long double>(stream.surface().point);
            for (int i = 0; i < 3; ++i) outside += !(p[i] - band >= box.low[i] && p[i] + band <= box.high[i]);
        }
        EXPECT_EQ(outside, 0) << "of " << kPoints / int(shapes.size());
    }
}

using Far = oracle::Vec3<long double>;
using FarShape = ExactShape<long double>;

/// The nearest point of the shape: of a disc that of its rim.
Far ontoShape(const FarShape& shape, const Far& p) {
    if (shape.kind() != ShapeKind::Disc) return p - shape.distance(p) * shape.normal(p);
    return shape.radius() * unit(p - dot(p, shape.axis()) * shape.axis());
}

/// How far the shape reaches at least from its middle that way: the point of it nearest to one far off that way is
/// nearly the farthest, and from there nearer ones lead on.
long double reach(const FarShape& shape, Far p, const Far& way) {
    long double most = -1e30L;
    if (shape.kind() == ShapeKind::Triangle) {
        for (int i = 0; i < 3; ++i) most = std::max(most, dot(shape.vertex(i), way));
        return most;
    }
    for (long double step = 1e6L * shape.size(); step > 1e-5L * shape.size(); step *= 0.9L) {
        p = p + step * way;
        for (int i = 0; i < 3; ++i) p = ontoShape(shape, p);
        // The surface is no farther from p than its distance says.
        most = std::max(most, dot(p, way) - std::abs(shape.distance(p)));
    }
    return most;
}

TEST_P(BoundsOfShape, TouchTheSurfaceBut2ToTheMinus19OfTheSizeAndFourRoundings) {
    for (const Shape& shape : shapesOf(GetParam())) {
        const FarShape exactShape(shape);
        const Bounds box = *boundsOf(shape);
        Far middle = exactShape.middle();
        const long double farthest =
            std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)}) + exactShape.size();
        const long double most = 0x1p-19L * exactShape.size() + 4 * 0x1p-23L * farthest;
        RayStream stream(shape, RayClass::Uniform, 3, 2);
        for (int face = 0; face < 6; ++face) {
            const int axis = face / 2;
            Far way;
            way[axis] = face % 2 ? 1 : -1;
            const long double bound = face % 2 ? box.high[axis] - middle[axis] : middle[axis] - box.low[axis];
            long double room = 1e30L;
            for (int start = 0; start < 5; ++start)
                room = std::min(room, bound - reach(exactShape, Far(stream.surface().point), way));
            EXPECT_LE(room, most) << "face " << face;
            EXPECT_GE(room, 0x1p-21L * exactShape.size()) << "face " << face;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, BoundsOfShape,
                         testing::Values(ShapeKind::Sphere, ShapeKind::Disc, ShapeKind::Triangle, ShapeKind::Torus,
                                         ShapeKind::Box, ShapeKind::Cylinder, ShapeKind::Capsule, ShapeKind::Cone),
                         [](const auto& test) { return glslTypeOf(test.param); });

TEST(Bounds, AreNoneOfWhatHasNoEnd) {
    EXPECT_FALSE(boundsOf(makeShape(ShapeKind::Plane, {{0, 0, 0}, {0, 1, 0}})));
    EXPECT_FALSE(boundsOf({ShapeKind::LargeSphere, {}}));
}

TEST(Bounds, EmptyOnesAddNothing) {
    const Bounds box{{1, 2, 3}, {4, 5, 6}};
    EXPECT_EQ(merged(Bounds{}, box), box);
    EXPECT_EQ(merged(box, Bounds{}), box);
    EXPECT_EQ(merged(box, {{0, 3, 3}, {2, 9, 4}}), (Bounds{{0, 2, 3}, {4, 9, 6}}));
    EXPECT_EQ(halfArea(box), 27);
}

} // namespace
} // namespace gnomon
