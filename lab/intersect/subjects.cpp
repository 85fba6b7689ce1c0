#include "lab/intersect/subjects.h"

#include "tracer/scene/rotation.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>

namespace gnomon::oracle {
namespace {

using Vec = Vec3<double>;

constexpr double kPi = 3.14159265358979323846;
constexpr double kThin = 0x1p-7;

/// A fixed turn about a skew axis: no component of a turned axis is 0.
const glm::dmat3& skewTurn() {
    static const glm::dmat3 turn = [] {
        const glm::dvec3 a = glm::normalize(glm::dvec3(0.48, 0.6, 0.34)),
                         b = glm::normalize(glm::cross(a, {0.2, -0.5, 0.9}));
        return glm::dmat3(b, glm::cross(a, b), a);
    }();
    return turn;
}
glm::dvec3 turned(glm::dvec3 v) { return skewTurn() * v; }

Shape turned(Shape shape) {
    if (shape.kind == ShapeKind::Box) return shape; // its faces lie across the world's axes
    for (const ShapeField& field : shapeRow(shape.kind).fields) {
        if (field.type == FieldType::Rotation)
            setPoint(shape, field.key, rodriguesOf(glm::quat_cast(skewTurn() * axesOf(pointOf(shape, field.key)))));
        if (field.type == FieldType::Rotation || field.type == FieldType::Lengths) continue;
        double* vector = &shape.values[std::size_t(field.at)];
        for (int i = 0; i < vectorCount(field.type); ++i, vector += 3) {
            const glm::dvec3 after = turned(glm::dvec3(vector[0], vector[1], vector[2]));
            std::copy_n(&after.x, 3, vector);
        }
    }
    return shape;
}

Vec lateral(Vec v, int axis) {
    v[axis] = 0;
    return v;
}

/// Random heights that fill a box, as a scene file's patch is kept.
Shape patch(unsigned seed, glm::dvec3 size) {
    Heights heights = randomHeights(seed);
    const auto [least, most] = heightRange(heights);
    for (double& height : heights) height = (height - 0.5 * (least + most)) / (most - least);
    Shape shape = makeShape(ShapeKind::HeightPatch, {{0, 0, 0}, size, {0, 0, 0}});
    shape.heights = std::make_shared<const Heights>(heights);
    return inFloat(shape);
}

} // namespace

std::ostream& operator<<(std::ostream& out, const Subject& subject) { return out << subject.name(); }

const std::vector<Subject>& subjects() {
    using enum ShapeKind;
    // Values that float32 holds exactly.
    static const std::vector<Subject> all{
        {"sphere", "", makeShape(Sphere, {{0, 0, 0}}, {1})},
        {"plane", "", makeShape(Plane, {{0, 0, 0}, {0, 0, 1}})},
        {"disc", "", makeShape(Disc, {{0, 0, 0}, {0, 0, 1}}, {1})},
        {"triangle", "thin", makeShape(Triangle, {{-1, 0, 0}, {1, 0, 0}, {0.25, kThin, 0}})},
        {"triangle", "fat", makeShape(Triangle, {{-0.875, -0.5, 0}, {0.875, -0.5, 0}, {0, 1, 0}})},
        {"torus", "thin", makeShape(Torus, {{0, 0, 0}, {0, 0, 1}}, {1, kThin})},
        {"torus", "quarter", makeShape(Torus, {{0, 0, 0}, {0, 0, 1}}, {1, 0.25})},
        {"torus", "fat", makeShape(Torus, {{0, 0, 0}, {0, 0, 1}}, {1, 0.875})},
        {"box", "thin", makeShape(Box, {{0, 0, 0}, {1, 0.75, kThin}})},
        {"box", "fat", makeShape(Box, {{0, 0, 0}, {1, 0.75, 0.625}})},
        {"rotated_box", "thin", makeShape(RotatedBox, {{0, 0, 0}, {1, 0.75, kThin}, {0, 0, 0}})},
        {"rotated_box", "fat", makeShape(RotatedBox, {{0, 0, 0}, {1, 0.75, 0.625}, {0, 0, 0}})},
        {"ellipsoid", "thin", makeShape(Ellipsoid, {{0, 0, 0}, {1, 0.75, kThin}, {0, 0, 0}})},
        {"ellipsoid", "fat", makeShape(Ellipsoid, {{0, 0, 0}, {1, 0.75, 0.625}, {0, 0, 0}})},
        {"ellipsoid", "needle", makeShape(Ellipsoid, {{0, 0, 0}, {kThin, 2 * kThin, 1}, {0, 0, 0}})},
        {"cylinder", "thin", makeShape(Cylinder, {{0, 0, -1}, {0, 0, 1}}, {kThin})},
        {"cylinder", "fat", makeShape(Cylinder, {{0, 0, -0.25}, {0, 0, 0.25}}, {1})},
        {"capsule", "thin", makeShape(Capsule, {{0, 0, -1}, {0, 0, 1}}, {kThin})},
        {"capsule", "fat", makeShape(Capsule, {{0, 0, -0.25}, {0, 0, 0.25}}, {1})},
        {"cone", "thin", makeShape(Cone, {{0, 0, -1}, {0, 0, 1}}, {kThin})},
        {"cone", "fat", makeShape(Cone, {{0, 0, -0.25}, {0, 0, 0.25}}, {1})},
    };
    return all;
}

const std::vector<Subject>& patches() {
    static const std::vector<Subject> all{
        {"height_patch", "gentle", patch(3, {1.5, 0.375, 1.25})},
        {"height_patch", "steep", patch(5, {0.5, 2, 0.5})},
    };
    return all;
}

Scene sceneOf(const std::vector<Shape>& shapes) {
    Scene scene;
    scene.materials.resize(1);
    scene.objects.resize(shapes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) scene.objects[i].shape = shapes[i];
    return scene;
}

std::string_view nameOf(RayClass kind) {
    switch (kind) {
    case RayClass::Uniform: return "uniform";
    case RayClass::Grazing: return "grazing";
    case RayClass::Tangent: return "tangent";
    case RayClass::Hole: return "hole";
    case RayClass::Inside: return "inside";
    case RayClass::Axis: return "axis";
    }
    return "";
}

bool fits(RayClass kind, const Subject& subject) {
    const bool closed = ExactShape<double>(subject.geometry).closed();
    if (kind == RayClass::Hole) return subject.geometry.kind == ShapeKind::Torus;
    if (kind == RayClass::Inside) return closed;
    if (kind == RayClass::Tangent) return subject.geometry.kind != ShapeKind::Plane; // it has no silhouette
    return true;
}

double leastDecided(RayClass kind, ShapeKind shape, double distance) {
    const bool plane = shape == ShapeKind::Plane;
    switch (kind) {
    case RayClass::Uniform: return 0.99;
    case RayClass::Grazing: return 0.45;
    case RayClass::Tangent: return distance > 1e4 ? 0.05 : 0.2;
    case RayClass::Hole: return 0.99;
    case RayClass::Inside: return distance > 1e4 ? 0.3 : 0.85; // 1e5 away a thin box is one rounding thick
    case RayClass::Axis: return plane ? 0.4 : 0.7;
    }
    return 1;
}

Shape placed(const Subject& subject, RayClass kind, double distance) {
    if (kind == RayClass::Axis) return subject.geometry;
    const glm::dvec3 away =
        kind == RayClass::Inside ? distance * glm::dvec3(0.6, -0.48, 0.64) : glm::dvec3(0.3, -0.7, 1.1);
    return inFloat(translated(turned(subject.geometry), away));
}

RayStream::RayStream(const Shape& placed, RayClass kind, double distance, std::uint64_t seed)
    : shape_(placed), kind_(kind), far_(distance), random_(seed) {
    measures_ = {0};
    for (const double value : placed.values)
        if (value != 0) measures_.insert(measures_.end(), {value, -value});
    if (placed.kind == ShapeKind::Torus)
        for (const double side : {-1.0, 1.0})
            for (const double tube : {-1.0, 1.0}) measures_.push_back(side * (shape_.radius() + tube * shape_.minor()));
}

BatchRay RayStream::next() {
    switch (kind_) {
    case RayClass::Uniform: return uniform();
    case RayClass::Grazing: return grazing();
    case RayClass::Tangent: return tangent();
    case RayClass::Hole: return hole();
    case RayClass::Inside: return inside();
    case RayClass::Axis: return axis();
    }
    return {};
}

Vec RayStream::direction() {
    const double z = number(-1, 1), turn = number(0, 2 * kPi), r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

Vec RayStream::acrossTo(const Vec& normal) {
    const Vec any = direction();
    return unit(any - dot(any, normal) * normal);
}

/// From points relative to the shape's middle.
BatchRay RayStream::from(const Vec& origin, const Vec& along) const {
    BatchRay ray;
    ray.origin = toFloat(shape_.middle() + Vec3<long double>(origin));
    ray.direction = toFloat(unit(along));
    return ray;
}

BatchRay RayStream::towards(const Vec& origin, const Vec& target) const {
    BatchRay ray = from(origin, target - origin);
    const Vec start(Vec3<long double>(ray.origin) - shape_.middle()); // as rounded
    ray.direction = toFloat(unit(target - start));
    return ray;
}

/// A far ray's six numbers have steps that are coarser than what it should pass by a surface at. Of many rays a few
/// steps beside it, the one that passes the wanted point closest, across the surface.
BatchRay RayStream::nudged(const BatchRay& ray, const Spot& wanted) {
    const Vec3<long double> target = shape_.middle() + Vec3<long double>(wanted.point), normal(wanted.normal);
    BatchRay best = ray;
    long double least = 1e30L;
    for (int i = 0; i < 200; ++i) {
        BatchRay other = ray;
        for (int c = 0; c < 3; ++c) {
            const float origin = ray.origin[c], direction = ray.direction[c];
            const auto steps = [&](int most) { return float(int(number(0, 2 * most + 1)) - most); };
            other.origin[c] += steps(2) * (std::nextafter(origin, 1e30f) - origin);
            other.direction[c] += steps(1) * (std::nextafter(direction, 1e30f) - direction);
        }
        const Vec3<long double> o = Vec3<long double>(other.origin) - target, d(other.direction);
        const long double past = std::abs(dot(o - (dot(o, d) / dot(d, d)) * d, normal));
        if (past >= least) continue;
        least = past;
        best = other;
    }
    return best;
}

RayStream::Spot RayStream::surface() {
    const double size = shape_.size();
    if (shape_.kind() == ShapeKind::Plane) return {number(0, size) * acrossTo(shape_.axis()), shape_.axis()};
    if (shape_.kind() == ShapeKind::Disc) {
        const Vec outward = acrossTo(shape_.axis());
        return {size * outward, outward};
    }
    if (shape_.triangle()) {
        const int i = int(number(0, 3));
        const Vec a = shape_.vertex(i), b = shape_.vertex((i + 1) % 3);
        return {a + number(0, 1) * (b - a), unit(cross(b - a, shape_.axis()))};
    }
    if (shape_.kind() == ShapeKind::HeightPatch) {
        const PatchSurface<double>& patch = shape_.patch();
        const double x = patch.size().x * number(-0.5, 0.5), z = patch.size().z * number(-0.5, 0.5);
        const Vec p(x, patch.at(x, z).y, z);
        return {shape_.fromAxes(p), shape_.fromAxes(patch.normal(p))};
    }
    // The distance leads any point onto the surface, and to the normals of all that lies about an edge.
    Vec p = size * std::cbrt(number(0, 1)) * direction();
    const Vec normal = shape_.normal(p);
    for (int i = 0; i < 3; ++i) p = p - shape_.distance(p) * shape_.normal(p);
    return {p, shape_.distance(p + 1e-6 * size * normal) > 0 ? normal : shape_.normal(p)};
}

RayStream::Spot RayStream::rim() {
    const PatchSurface<double>& patch = shape_.patch();
    const bool alongX = number(0, 1) < 0.5;
    const double side = number(0, 1) < 0.5 ? -1 : 1, along = number(-0.5, 0.5);
    const double x = patch.size().x * (alongX ? along : side / 2), z = patch.size().z * (alongX ? side / 2 : along);
    const auto jet = patch.at(x, z);
    const Vec p(x, jet.y, z), way = alongX ? Vec(1, jet.x, 0) : Vec(0, jet.z, 1);
    const Vec away = unit(cross(way, patch.normal(p)));
    const bool inward = (alongX ? away.z : away.x) * side < 0;
    return {shape_.fromAxes(p), shape_.fromAxes(inward ? -away : away)};
}

BatchRay RayStream::uniform() {
    const Vec origin = far_ * shape_.size() * direction();
    return towards(origin, shape_.size() * std::cbrt(number(0, 1)) * direction());
}

BatchRay RayStream::towardsSurface() {
    const Vec spot = surface().point;
    return towards(far_ * shape_.size() * direction(), shape_.flat() ? number(0, 1) * spot : spot);
}

BatchRay RayStream::grazing() {
    const double offset = std::pow(10.0, number(-8, -2)) * (number(0, 1) < 0.5 ? -1 : 1);
    const bool rims = shape_.kind() == ShapeKind::HeightPatch && number(0, 1) < 0.3;
    const Spot spot = rims ? rim() : surface();
    if (shape_.kind() == ShapeKind::Plane) // nearly along it
        return from(far_ * unit(acrossTo(spot.normal) + offset * spot.normal),
                    acrossTo(spot.normal) - offset * spot.normal);
    const Vec target = spot.point + offset * shape_.size() * spot.normal;
    const Vec along = shape_.flat() ? direction() : acrossTo(spot.normal);
    return nudged(towards(target - far_ * shape_.size() * along, target), {target, spot.normal});
}

bool RayStream::meets(const BatchRay& ray) const {
    return exactHit(shape_, lineOf(shape_, ray.origin, ray.direction)).hit;
}

/// Along the view axis from far away through a point, slanted by so much over the whole way.
BatchRay RayStream::alongAxis(const Vec& through, const Vec& slant) const {
    const double way = far_ * shape_.size();
    Vec along = (1 / way) * lateral(slant, view_);
    along[view_] = -facing_;
    BatchRay ray = from(through - way * along, along);
    ray.direction[view_] = float(-facing_); // its length is 1 to float32: the slant is tiny, or the rounding is
    return ray;
}

/// Bisects between a ray that meets the shape and one that passes it by.
void RayStream::findSilhouette() {
    for (;;) {
        view_ = int(number(0, 3));
        facing_ = number(0, 1) < 0.5 ? -1 : 1;
        Vec low = lateral(0.999 * surface().point, view_);
        outward_ = unit(lateral(direction(), view_));
        if (!meets(alongAxis(low, {}))) continue;
        Vec high = low + 2.5 * shape_.size() * outward_;
        for (int i = 0; i < 40; ++i) {
            const Vec middle = 0.5 * (low + high);
            (meets(alongAxis(middle, {})) ? low : high) = middle;
        }
        silhouette_ = low;
        left_ = 32;
        return;
    }
}

BatchRay RayStream::tangent() {
    if (left_ == 0) findSilhouette();
    --left_;
    const double offset = std::exp2(number(-27, -16)) * (number(0, 1) < 0.5 ? -1 : 1) * shape_.size();
    const Vec slant = 1e-4 * std::min(1.0, far_ * 1e-4) * direction();
    return alongAxis(silhouette_ + offset * outward_, slant);
}

BatchRay RayStream::hole() {
    const Vec target = 1.02 * (shape_.radius() - shape_.minor()) * std::sqrt(number(0, 1)) * acrossTo(shape_.axis());
    return towards(far_ * shape_.size() * direction(), target);
}

BatchRay RayStream::inside() {
    for (;;) {
        const Spot spot = surface();
        const Vec p = spot.point - std::exp2(number(-12, 0)) * shape_.size() * spot.normal;
        if (shape_.distance(p) < -1e-6 * shape_.size()) return from(p, direction());
    }
}

BatchRay RayStream::axis() {
    const auto coordinate = [&] {
        const double any = number(0, 1);
        return any < 0.7 ? measures_[std::size_t(number(0, double(measures_.size())))] : number(-1, 1) * shape_.size();
    };
    const int across = int(number(0, 3)), along = (across + 1 + int(number(0, 2))) % 3;
    Vec way;
    way[along] = number(0, 1) < 0.5 ? -1 : 1;
    if (number(0, 1) < 0.6) { // within a plane across an axis, else along an axis
        const double turn = number(0, 2 * kPi);
        way[along] = std::cos(turn);
        way[3 - across - along] = std::sin(turn);
    }
    const Vec through{coordinate(), coordinate(), coordinate()};
    BatchRay ray = from(through - far_ * shape_.size() * way, way);
    return ray;
}

} // namespace gnomon::oracle
