/// Every shape's distance on the GPU against the exact one, and its gradient: about the shape, by its surface, 1000
/// sizes away, on its axis, at its centre, edges and vertices.
///
/// A rounding is 2^-23 of the point's distance from the shape's middle and of the shape's size. A gradient may be off
/// by so many roundings of its own and by what as many of the point turn it; where it turns by more than 1/20 within 8
/// of them, as about an edge and on a medial axis, only its length is compared. GNOMON_RAYS says how many points a
/// shape gets: 200 000 by default.

#include "lab/batch/distance_batch.h"
#include "lab/intersect/subjects.h"
#include "lab/reference/exact/scene_hit.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/plan/drawn.h"
#include "tracer/plan/prepared_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <set>

namespace gnomon {
namespace {

using namespace test;
using namespace oracle;
using Real = long double;
using Point = Vec3<Real>;
using Exact = std::function<Real(const Point&)>; // of a point relative to the shape's middle

constexpr Real kRounding = 0x1p-23L;
constexpr Real kLength = 3; ///< roundings of a gradient's length

/// What the header of a shape's file states, in roundings.
struct Bounds {
    Real distance, gradient = 2;
};
Bounds boundsOf(ShapeKind kind) {
    switch (kind) {
    case ShapeKind::Sphere:
    case ShapeKind::Plane:
    case ShapeKind::Box: return {1.5L};
    case ShapeKind::Disc:
    case ShapeKind::Torus:
    case ShapeKind::Capsule: return {2};
    case ShapeKind::RotatedBox: return {2.5L, 3};
    case ShapeKind::Ellipsoid: return {3, 4};
    case ShapeKind::Triangle:
    case ShapeKind::SmoothTriangle: return {2.5L, 3};
    case ShapeKind::Cylinder: return {2.5L};
    case ShapeKind::Cone: return {3};
    case ShapeKind::LargeSphere:
    case ShapeKind::HeightPatch: // what its field's samples make of it: tests/shader/field_test.cpp
    case ShapeKind::SpacePatch:  // has no distance
    case ShapeKind::Mandelbulb: // an estimate: tests/shader/solid_test.cpp, as all solids
    case ShapeKind::Solid: break;
    }
    return {3.5L};
}

int pointsAShape() {
    const char* asked = std::getenv("GNOMON_RAYS");
    return asked ? std::atoi(asked) : 200000;
}

enum class Region { Around, Near, Far, Axis, Edge };
constexpr std::array<Region, 5> kRegions{Region::Around, Region::Near, Region::Far, Region::Axis, Region::Edge};
constexpr const char* kRegionNames[] = {"around", "near", "far", "axis", "edge"};

/// An endless, reproducible stream of points about one placed shape. Every second one is near the one before.
class Points {
  public:
    explicit Points(const Shape& placed)
        : shape_(placed), stream_(placed, RayClass::Uniform, 3, 21), axis_(shape_.axis()) {
        if (length(axis_) == 0) axis_ = {0, 0, 1};
        std::set<double> measures{0};
        for (const double value : placed.values) measures.insert({value, -value});
        if (placed.kind == ShapeKind::Torus)
            for (const double side : {-1.0, 1.0})
                for (const double tube : {-1.0, 1.0}) measures.insert(side * (shape_.radius() + tube * shape_.minor()));
        measures_.assign(measures.begin(), measures.end());
    }

    BatchPoint next(Region region) {
        near_ = !near_;
        if (near_)
            last_ = anywhere(region);
        else if (region != Region::Edge)
            last_ = last_ + std::pow(10.0, stream_.number(-7, 0)) * shape_.size() * stream_.direction();
        const Vec3<double> viewpoint = (stream_.number(0, 1) < 0.5 ? -2.0 : 2.0) * axis_ + 1.5 * stream_.direction();
        return {inWorld(last_), inWorld(viewpoint)};
    }

  private:
    glm::vec3 inWorld(const Vec3<double>& p) const { return toFloat(shape_.middle() + Point(p)); }
    Vec3<double> anywhere(Region region) {
        const double size = shape_.size();
        const auto some = [&](double most) { return stream_.number(-most, most) * size; };
        switch (region) {
        case Region::Around: return {some(4), some(4), some(4)};
        case Region::Near: {
            const Vec3<double> spot = stream_.surface().point; // of a flat shape on its rim
            return (shape_.closed() ? 1 : stream_.number(0, 1)) * spot + some(1e-3) * stream_.direction();
        }
        case Region::Far: return 1000 * size * stream_.direction();
        case Region::Axis: return some(3) * axis_;
        case Region::Edge: break; // of an upright shape: its centre, edges and vertices, and much between them
        }
        const auto measure = [&] { return measures_[std::size_t(stream_.number(0, double(measures_.size())))]; };
        const Vec3<double> held(-shape_.middle());
        return held + Vec3<double>(measure(), measure(), measure());
    }

    ExactShape<double> shape_;
    RayStream stream_;
    Vec3<double> axis_, last_;
    std::vector<double> measures_;
    bool near_ = false;
};

Point gradientOf(const Exact& exact, const Point& p, Real step) {
    Point g;
    for (int i = 0; i < 3; ++i) {
        Point before = p, after = p;
        before[i] -= step;
        after[i] += step;
        g[i] = (exact(after) - exact(before)) / (2 * step);
    }
    return g;
}

/// How far the exact gradient turns within `reach` of a point; large where it jumps.
Real turnAbout(const Exact& exact, const Point& p, const Point& gradient, Real reach) {
    Real most = 0;
    for (int i = 0; i < 3; ++i)
        for (const Real side : {-reach, reach}) {
            Point beside = p;
            beside[i] += side;
            most = std::max(most, length(gradientOf(exact, beside, reach * 1e-4L) - gradient));
        }
    return most;
}

/// What is no number is the worst.
void worst(Real& most, Real error) { most = std::max(most, std::isnan(error) ? 1e30L : error); }

/// The worst of many answers, in roundings.
struct Errors {
    std::int64_t points = 0, smooth = 0; ///< smooth: where no medial axis or edge is within rounding
    Real distance = 0, gradient = 0, unit = 0, steep = 0;

    /// `stiff`: by how many roundings those of the shape's own numbers turn the gradient.
    void compare(const Exact& exact, const Point& p, Real scale, const glm::vec4& answer, Real stiff) {
        constexpr Real kReach = 8;
        ++points;
        const Point got{glm::dvec3(answer)};
        worst(distance, std::abs(answer.w - exact(p)) / (kRounding * scale));
        worst(unit, std::abs(length(got) - 1) / kRounding);
        const Point wanted = gradientOf(exact, p, scale * kRounding * 1e-3L);
        const Real off = length(got - wanted);
        ++smooth;
        if (off / kRounding <= gradient) return; // what follows makes it less
        const Real turn = turnAbout(exact, p, wanted, kReach * scale * kRounding);
        if (turn > 0.05L)
            --smooth;
        else
            worst(gradient, off / ((1 + stiff) * kRounding + turn / kReach));
    }
    /// Two answers differ by no more than what lies between their points.
    void compare(const Point& p, const Point& q, float atP, float atQ, Real scale) {
        worst(steep, (std::abs(Real(atP) - Real(atQ)) - length(p - q)) / (kRounding * scale));
    }
    void add(const Errors& other) {
        points += other.points;
        smooth += other.smooth;
        distance = std::max(distance, other.distance);
        gradient = std::max(gradient, other.gradient);
        unit = std::max(unit, other.unit);
        steep = std::max(steep, other.steep);
    }
    bool within(const Bounds& bounds) const {
        return distance <= bounds.distance && gradient <= bounds.gradient && unit <= kLength &&
               steep <= bounds.distance;
    }
    void print(const std::string& what) const {
        std::printf("%-22s %7ld points, %7ld smooth; roundings: distance %.2Lf, gradient %.2Lf, its length %.2Lf, "
                    "steeper by %.2Lf\n",
                    what.c_str(), points, smooth, distance, gradient, unit, steep);
    }
};

float unsignedOfPlane(const ExactShape<Real>& shape, float distance) {
    return shape.kind() == ShapeKind::Plane ? std::abs(distance) : distance;
}

Errors errorsOf(const Shape& shape, const std::vector<BatchPoint>& points, const std::vector<BatchDistance>& answers) {
    const ExactShape<Real> exactShape(shape);
    const auto relative = [&](glm::vec3 p) { return Point(p) - exactShape.middle(); };
    const Real stiff = exactShape.triangle() ? exactShape.size() / exactShape.bend({}) : 0;
    Errors errors;
    Real scaleBefore = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point p = relative(points[i].p);
        const bool behind = exactShape.kind() == ShapeKind::Plane && exactShape.distance(relative(points[i].from)) < 0;
        const Exact exact = [&](const Point& q) {
            return behind ? -exactShape.distance(q) : exactShape.boundedDistance(q);
        };
        const Real scale = length(p) + exactShape.size();
        errors.compare(exact, p, scale, glm::vec4(answers[i].gradient, answers[i].distance), stiff);
        if (i > 0) // of a plane without the sign, which the viewpoints choose
            errors.compare(p, relative(points[i - 1].p), unsignedOfPlane(exactShape, answers[i].distance),
                           unsignedOfPlane(exactShape, answers[i - 1].distance), scale + scaleBefore);
        scaleBefore = scale;
    }
    return errors;
}

/// Upright and turned, all regions; ready for mutated shaders.
Errors measured(const Subject& subject, int points, std::span<const ShaderFile> overrides, bool tell) {
    Errors all;
    for (const RayClass stance : {RayClass::Axis, RayClass::Uniform}) {
        const Shape shape = placed(subject, stance, 3);
        Problems problems;
        DistanceBatch batch(sceneOf({shape}), problems, overrides);
        EXPECT_TRUE(batch.valid()) << toString(problems);
        if (!batch.valid()) return all;
        for (const Region region : kRegions) {
            if (region == Region::Edge && stance != RayClass::Axis) continue;
            Points stream(shape);
            std::vector<BatchPoint> asked(std::size_t(points / 9 + 1));
            for (BatchPoint& point : asked) point = stream.next(region);
            const Errors errors = errorsOf(shape, asked, batch.measure(asked));
            if (tell)
                errors.print(subject.name() + (stance == RayClass::Axis ? " upright " : " turned ") +
                             kRegionNames[int(region)]);
            if (region == Region::Around) {
                EXPECT_GE(errors.smooth, errors.points * 99 / 100);
            }
            all.add(errors);
        }
    }
    return all;
}

class Distance : public testing::TestWithParam<Subject> {};

TEST_P(Distance, IsTheOraclesWithItsGradient) {
    offscreen();
    const Errors errors = measured(GetParam(), pointsAShape(), {}, true);
    errors.print(GetParam().name());
    EXPECT_GE(errors.points, pointsAShape());
    const Bounds bounds = boundsOf(GetParam().geometry.kind);
    EXPECT_LE(errors.distance, bounds.distance);
    EXPECT_LE(errors.gradient, bounds.gradient);
    EXPECT_LE(errors.unit, kLength);
    EXPECT_LE(errors.steep, bounds.distance);
}

INSTANTIATE_TEST_SUITE_P(Subjects, Distance, testing::ValuesIn(subjects()),
                         [](const auto& test) { return test.param.name(); });

/// A distance with one thought left out.
struct Mutant {
    const char *name, *subject, *file, *line, *becomes;
};
std::ostream& operator<<(std::ostream& out, const Mutant& mutant) { return out << mutant.name; }

const Mutant kMutants[] = {
    {"sphereWithoutADirectionAtItsCentre", "sphere", "primitive/sphere.glsl", "vec3(0.0, 1.0, 0.0))", "vec3(0.0))"},
    {"planeOfOneSide", "plane", "primitive/plane.glsl", "< 0.0 ? -1.0 : 1.0;", "< 0.0 ? 1.0 : 1.0;"},
    {"discWithoutADirectionOnItself", "disc", "primitive/disc.glsl", "least, disc.normal)", "least, vec3(0.0))"},
    {"triangleOfEdgesOnly", "trianglefat", "primitive/triangle.glsl", "over ? vec3(0.0) : offRim", "offRim"},
    {"torusWithoutAHeight", "torusquarter", "primitive/torus.glsl", "beyond * outward + along * torus.axis;",
     "beyond * outward;"},
    {"boxWithoutAnInside", "boxfat", "primitive/box.glsl", "gap + depth)", "gap)"},
    {"boxOfOneOctant", "boxfat", "primitive/box.glsl", "side * safeDirection", "safeDirection"},
    {"ellipsoidOfOneStep", "ellipsoidthin", "primitive/ellipsoid.glsl", "i < 24", "i < 1"},
    {"rotatedBoxRotatedTheOtherWay", "rotated_boxfat", "primitive/rotated_box.glsl",
     "(p - rotated.center) * rotated.axes, from", "rotated.axes * (p - rotated.center), from"},
    {"cylinderOfOneEnd", "cylinderfat", "primitive/cylinder.glsl", "top * nearest.y", "nearest.y"},
    {"capsuleWithoutEnds", "capsulefat", "primitive/capsule.glsl", "-axis.halfLength, axis.halfLength)", "-1e9, 1e9)"},
    {"coneWithoutABase", "conefat", "primitive/cone.glsl", "inside ? max(above, -fromRim.y) : gap",
     "inside ? above : gap"},
};

class DistanceMutant : public testing::TestWithParam<Mutant> {};

// The comparison itself: the library's distance passes on 9000 points, the same with one line changed does not.
TEST_P(DistanceMutant, TurnsTheJudgeRed) {
    const Mutant& mutant = GetParam();
    offscreen();
    const auto subject =
        std::find_if(subjects().begin(), subjects().end(), [&](const auto& s) { return s.name() == mutant.subject; });
    ASSERT_NE(subject, subjects().end()) << mutant.subject;
    std::string text(shaderText(mutant.file));
    const std::size_t at = text.find(mutant.line);
    ASSERT_NE(at, std::string::npos) << mutant.file << " has no `" << mutant.line << "`";
    text.replace(at, std::string_view(mutant.line).size(), mutant.becomes);
    const ShaderFile overrides[] = {{mutant.file, text}};
    const Bounds bounds = boundsOf(subject->geometry.kind);
    EXPECT_TRUE(measured(*subject, 9000, {}, false).within(bounds));
    EXPECT_FALSE(measured(*subject, 9000, overrides, false).within(bounds));
}

INSTANTIATE_TEST_SUITE_P(Mutants, DistanceMutant, testing::ValuesIn(kMutants),
                         [](const auto& test) { return std::string(test.param.name); });

/// A huge sphere that passes the origin closely, with numbers that float32 does not hold, and the scene's camera above
/// it.
struct Ground {
    Real radius;
    Point up = unit(Point(0.3123L, 0.8765L, -0.4321L)), along = unit(cross(up, Point(0, 0, 1)));
    Point center;

    explicit Ground(double r) : radius(r * 1.0000001234567) {
        const Point away = Point(0.1234567L, -0.2345678L, 0.3456789L) - radius * up;
        center = {double(away.x), double(away.y), double(away.z)};
    }
    Point over(Real angle, Real height) const {
        return center + (radius + height) * (std::cos(angle) * up + std::sin(angle) * along);
    }
    Scene scene() const {
        const auto inDouble = [](const Point& p) { return glm::dvec3(p.x, p.y, p.z); };
        Scene scene = sceneOf({makeShape(ShapeKind::Sphere, {inDouble(center)}, {double(radius)})});
        scene.camera.eye = inDouble(over(0, radius / 1000));
        scene.camera.target = inDouble(over(0, 0));
        scene.camera.up = inDouble(along);
        return scene;
    }
};

class LargeSphereDistance : public testing::TestWithParam<double> {};

/// Errors in units of 2^-23 D (1 + D / 2r), D being the distance from the anchor, and of the gradient in roundings of
/// the way from the anchor to the point over that from the centre.
TEST_P(LargeSphereDistance, IsTheOraclesNearItsAnchorAndFarFromIt) {
    offscreen();
    const Ground ground(GetParam());
    const Scene scene = ground.scene();
    ASSERT_EQ(drawnKinds(scene)[0], ShapeKind::LargeSphere);
    ASSERT_EQ(originOf(scene), glm::dvec3(0));
    Problems problems;
    DistanceBatch batch(scene, problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    RayStream stream(makeShape(ShapeKind::Sphere, {{0, 0, 0}}, {1}), RayClass::Uniform, 3, 31);
    std::vector<BatchPoint> points(std::size_t(pointsAShape()), BatchPoint{});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Real height = std::pow(10.0, stream.number(-4, 2)) * (stream.number(0, 1) < 0.3 ? -1 : 1);
        const Real way = std::pow(10.0, stream.number(-3, 3));
        Point p = ground.over(way / ground.radius, height);                      // about the eye
        if (i % 4 == 1) p = ground.over(stream.number(-4, 4), height);           // anywhere else
        if (i % 4 == 2) p = ground.over(0, 0) + way * Point(stream.direction()); // off the plane of the two
        if (i % 4 == 3)
            p = ground.center + ground.radius * Point(std::pow(10.0, stream.number(-3, 2)) * stream.direction());
        points[i].p = toFloat(p);
    }
    points[0].p = toFloat(ground.over(0, 0));
    points[1].p = toFloat(ground.center);
    const std::vector<BatchDistance> answers = batch.measure(points);
    const Point anchor(toFloat(ground.over(0, 0)));
    Real distance = 0, gradient = 0, unitLength = 0, near = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point p(points[i].p), fromCenter = p - ground.center, got{glm::dvec3(answers[i].gradient)};
        const Real away = length(p - anchor),
                   error = std::abs(answers[i].distance - (length(fromCenter) - ground.radius));
        const Real bound = kRounding * away * (1 + away / (2 * ground.radius));
        worst(unitLength, std::abs(length(got) - 1) / kRounding);
        if (i == 1) continue; // at the centre, but for rounding: no way leads out of it rather than another
        if (i == 0) {
            EXPECT_LE(error, 0x1p-50L * ground.radius) << "at the anchor, by what doubles hold of it";
            continue;
        }
        worst(distance, error / bound);
        if (away < 10) worst(near, error);
        const Real turn = kRounding * (1 + (ground.radius + away) / length(fromCenter));
        worst(gradient, length(got - unit(fromCenter)) / turn);
    }
    std::printf(
        "large sphere r %g: %zu points; distance %.2Lf of 2^-23 D (1 + D / 2r), within 10 of the anchor %.2Lg at "
        "most; gradient "
        "%.2Lf and its length %.2Lf roundings\n",
        GetParam(), points.size(), distance, near, gradient, unitLength);
    const Bounds bounds = boundsOf(ShapeKind::LargeSphere);
    EXPECT_LE(distance, bounds.distance);
    EXPECT_LE(near, 10 * bounds.distance * kRounding);
    EXPECT_LE(gradient, bounds.gradient);
    EXPECT_LE(unitLength, kLength);
}

INSTANTIATE_TEST_SUITE_P(Radii, LargeSphereDistance, testing::Values(1e3, 1e4, 9e5));

// Of all objects the nearest, and of those that cast shadows: every shape twice, in a cloud.
TEST(SceneDistance, IsThatOfTheNearestObjectOfEveryKind) {
    offscreen();
    std::vector<Shape> shapes;
    for (int copy = 0; copy < 2; ++copy)
        for (const Subject& subject : subjects()) {
            const int i = int(shapes.size());
            const glm::dvec3 at(i % 4 - 1.5, i / 4 % 3 - 1, i / 12 - 1);
            shapes.push_back(translated(placed(subject, RayClass::Uniform, 3), 2.5 * at));
        }
    Scene scene = sceneOf(shapes);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        scene.objects[i].castsShadow = i % 3 != 0;
        if (shapes[i].kind == ShapeKind::Plane) scene.objects[i].shape = translated(shapes[i], {0, 0, -9});
    }
    std::vector<int> order;
    const PreparedScenePtr prepared = prepare(scene);
    for (const KindLayout& kind : prepared->layout) order.insert(order.end(), kind.objects.begin(), kind.objects.end());
    ASSERT_EQ(order.size(), shapes.size());
    const std::vector<SceneShape> exactShapes = exactShapesOf(scene, 0);
    Problems problems;
    DistanceBatch batch(scene, problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);

    RayStream stream(scene.objects[0].shape, RayClass::Uniform, 3, 41);
    std::vector<BatchPoint> points(20000, BatchPoint{});
    for (BatchPoint& point : points) {
        point.p = toFloat(stream.number(0, 8) * stream.direction());
        point.from = toFloat(20.0 * stream.direction());
    }
    const std::vector<BatchDistance> answers = batch.measure(points);
    std::set<int> met;
    int wrong = 0, other = 0, far = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        Real nearest = 1e30L, second = 1e30L, caster = 1e30L;
        int object = -1;
        for (std::size_t k = 0; k < exactShapes.size(); ++k) {
            const auto relative = [&](glm::vec3 p) { return Point(p) - exactShapes[k].middle(); };
            Real d = exactShapes[k].boundedDistance(relative(points[i].p));
            if (exactShapes[k].kind() == ShapeKind::Plane && exactShapes[k].distance(relative(points[i].from)) < 0)
                d = -d;
            if (d < nearest) object = int(k);
            second = std::min(second, std::max(d, nearest));
            nearest = std::min(nearest, d);
            if (scene.objects[k].castsShadow) caster = std::min(caster, d);
        }
        met.insert(object);
        constexpr Real kSlack = 3.5L * kRounding * 20; // no point is farther from an object's middle than that
        wrong += !(std::abs(answers[i].distance - nearest) <= kSlack);
        far += !(std::abs(answers[i].casters.w - caster) <= kSlack);
        other += second - nearest > 2 * kSlack && order[std::size_t(answers[i].object)] != object;
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(far, 0);
    EXPECT_EQ(other, 0);
    EXPECT_GE(met.size(), shapes.size() * 3 / 4) << "the cloud shows every kind";
}

} // namespace
} // namespace gnomon
