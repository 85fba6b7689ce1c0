#include "tracer/scene/shapes.h"

#include "tracer/problem.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace gnomon {

namespace {

using Complaint = std::array<std::string, 2>;

Complaint nothingWrong(const Shape&) { return {}; }

/// A triangle counts as degenerate where its height over its longest edge is below what float32 resolves of that edge.
Complaint checkTriangle(const Shape& shape) {
    constexpr double kFloatResolution = 1.0 / (1 << 22);
    const glm::dvec3 a{glm::vec3(shape.texels[0])}, b{glm::vec3(shape.texels[1])}, c{glm::vec3(shape.texels[2])};
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    const double twiceArea = glm::length(glm::cross(b - a, c - a));
    if (twiceArea > kFloatResolution * longest * longest) return {};
    return {"the three vertices lie on one line: the triangle has no area", "move one vertex off that line"};
}

/// Compared as the shader will see them, in float32.
Complaint checkTorus(const Shape& shape) {
    const double major = lengthOf(shape, "major_radius"), minor = lengthOf(shape, "minor_radius");
    if (float(minor) < float(major)) return {};
    const bool spindle = float(minor) > float(major);
    return {"minor_radius " + toString(minor) + (spindle ? " exceeds" : " equals") + " major_radius " +
                toString(major) + ": a " + (spindle ? "spindle" : "horn") + " torus is not supported",
            "use minor_radius < " + toString(major)};
}

/// Compared as the shader will see them, in float32, and with room for the squares that it forms of their distance.
Complaint checkAxis(const Shape& shape) {
    constexpr double kShortest = 1e-6;
    const glm::dvec3 from = pointOf(shape, "from"), to = pointOf(shape, "to");
    const double length = glm::distance(glm::dvec3{glm::vec3(from)}, glm::dvec3{glm::vec3(to)});
    if (float(length) >= float(kShortest)) return {};
    return {"from and to are " +
                (length > 0 ? toString(glm::distance(from, to)) + " apart" : std::string("one point")) +
                ": the shape has no axis",
            "move them at least " + toString(kShortest) + " apart"};
}

Complaint checkMandelbulb(const Shape& shape) {
    const double power = shape.texels[1].x, iterations = shape.texels[1].y;
    if (!(power >= 2 && power <= 16)) return {"power " + toString(power) + " is outside the limits", "use 2 to 16"};
    if (iterations == std::floor(iterations) && iterations <= 32) return {};
    return {"iterations " + toString(iterations) + " is no whole number up to 32", "use 1, 2, … 32"};
}

Extent about(glm::dvec3 center, glm::dvec3 reach) { return {center - reach, center + reach}; }
Extent hull(const Extent& a, const Extent& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

/// How far a unit circle across `axis` reaches along x, y and z. Not sqrt(1 - a²), which loses all of a slight tilt.
glm::dvec3 circleReach(glm::dvec3 axis) {
    const glm::dvec3 square = axis * axis;
    return glm::sqrt(glm::dvec3(square.y + square.z, square.z + square.x, square.x + square.y)) / glm::length(axis);
}

Extent sphereExtent(const Shape& s) { return about(pointOf(s, "center"), glm::dvec3(lengthOf(s, "radius"))); }

Extent discExtent(const Shape& s) {
    return about(pointOf(s, "center"), lengthOf(s, "radius") * circleReach(pointOf(s, "normal")));
}

Extent triangleExtent(const Shape& s) {
    const glm::dvec3 a(s.texels[0]), b(s.texels[1]), c(s.texels[2]);
    return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

Extent torusExtent(const Shape& s) {
    return about(pointOf(s, "center"),
                 lengthOf(s, "major_radius") * circleReach(pointOf(s, "axis")) + lengthOf(s, "minor_radius"));
}

Extent boxExtent(const Shape& s) { return about(pointOf(s, "center"), pointOf(s, "half_size")); }

Extent cylinderExtent(const Shape& s) {
    const glm::dvec3 from = pointOf(s, "from"), to = pointOf(s, "to");
    const glm::dvec3 reach = lengthOf(s, "radius") * circleReach(to - from);
    return hull(about(from, reach), about(to, reach));
}

Extent capsuleExtent(const Shape& s) {
    const glm::dvec3 reach(lengthOf(s, "radius"));
    return hull(about(pointOf(s, "from"), reach), about(pointOf(s, "to"), reach));
}

Extent coneExtent(const Shape& s) {
    const glm::dvec3 from = pointOf(s, "from"), to = pointOf(s, "to");
    return hull(about(from, lengthOf(s, "radius") * circleReach(to - from)), {to, to});
}

/// The orbit of a point beyond 2^(1/(power-1)) escapes for any constant up to there.
Extent mandelbulbExtent(const Shape& s) {
    const double reach = std::pow(2.0, 1 / (s.texels[1].x - 1));
    return about(pointOf(s, "center"), glm::dvec3(reach * lengthOf(s, "radius")));
}

const std::array<ShapeRow, kShapeKinds>& rows() {
    using enum FieldType;
    // clang-format off
    static const std::array<ShapeRow, kShapeKinds> table{{
        {ShapeKind::Sphere, "sphere", "Sphere", 1,
         {{"center", Point, 0, 0, "Centre"},
          {"radius", Length, 0, 3, "Radius"}},
         nothingWrong, sphereExtent, true},
        {ShapeKind::Plane, "plane", "Plane", 2,
         {{"point", Point, 0, 0, "Any point of the plane"},
          {"normal", Direction, 1, 0, "Direction across the plane, of any length"}},
         nothingWrong, nullptr, true},
        {ShapeKind::Disc, "disc", "Disc", 2,
         {{"center", Point, 0, 0, "Centre"},
          {"normal", Direction, 1, 0, "Direction across the disc, of any length"},
          {"radius", Length, 0, 3, "Radius"}},
         nothingWrong, discExtent, true},
        {ShapeKind::Triangle, "triangle", "Triangle", 3,
         {{"vertices", Vertices, 0, 0, "Three points a, b, c; the outside is where cross(b - a, c - a) points"}},
         checkTriangle, triangleExtent, true},
        {ShapeKind::Torus, "torus", "Torus", 2,
         {{"center", Point, 0, 0, "Centre of the hole"},
          {"axis", Direction, 1, 0, "Direction through the hole, of any length"},
          {"major_radius", Length, 0, 3, "From the centre to the middle of the tube"},
          {"minor_radius", Length, 1, 3, "Radius of the tube, less than major_radius"}},
         checkTorus, torusExtent, false, true},
        {ShapeKind::Box, "box", "Box", 2,
         {{"center", Point, 0, 0, "Centre"},
          {"half_size", Lengths, 1, 0, "From the centre to the faces across x, y and z"}},
         nothingWrong, boxExtent, true},
        {ShapeKind::Cylinder, "cylinder", "Cylinder", 2,
         {{"from", Point, 0, 0, "Centre of one end"},
          {"to", Point, 1, 0, "Centre of the other end"},
          {"radius", Length, 0, 3, "Radius"}},
         checkAxis, cylinderExtent, true, true},
        {ShapeKind::Capsule, "capsule", "Capsule", 2,
         {{"from", Point, 0, 0, "Centre of the round end"},
          {"to", Point, 1, 0, "Centre of the other round end"},
          {"radius", Length, 0, 3, "Radius of the ends and of the cylinder between them"}},
         checkAxis, capsuleExtent, true, true},
        {ShapeKind::Cone, "cone", "Cone", 2,
         {{"from", Point, 0, 0, "Centre of the base"},
          {"to", Point, 1, 0, "Apex"},
          {"radius", Length, 0, 3, "Radius of the base"}},
         checkAxis, coneExtent, true, true},
        {ShapeKind::Mandelbulb, "mandelbulb", "Mandelbulb", 2,
         {{"center", Point, 0, 0, "Centre"},
          {"radius", Length, 0, 3, "Unit of length: the bulb of power 8 reaches about 1.2 of them"},
          {"power", Number, 1, 0, "Power of the map, 2 to 16; 8 is the known one"},
          {"iterations", Number, 1, 1, "How often points are mapped, 1 to 32: more show finer detail"}},
         checkMandelbulb, mandelbulbExtent, false},
        // Packed by largeSphereOf().
        {ShapeKind::LargeSphere, "large_sphere", "LargeSphere", 2, {}, nothingWrong, nullptr, true},
        {ShapeKind::Solid, "solid", "Solid", 1,
         {{"center", Point, 0, 0, "Middle of the ball about it"},
          {"radius", Length, 0, 3, "Radius of that ball"}},
         nothingWrong, sphereExtent, false},
    }};
    // clang-format on
    return table;
}

const ShapeField& fieldOf(const Shape& shape, std::string_view key) {
    const auto& fields = shapeRow(shape.kind).fields;
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const ShapeField& f) { return f.key == key; });
    assert(field != fields.end());
    return *field;
}

int pointsOf(FieldType type) { return type == FieldType::Vertices ? 3 : type == FieldType::Point ? 1 : 0; }

/// The nearest float32. Through memory, since GCC 12 at -O2 leaves the rounding of two neighbours out
/// (SLP vectorizer; -O1, -fno-tree-slp-vectorize and clang do not).
double rounded(double x) {
    const volatile float stored = float(x);
    return stored;
}

/// The sphere in the numbers that shaders/primitive/large_sphere.glsl reads, near `eye` within float32 of what is near,
/// where centre and radius are within float32 of the radius only.
Shape largeSphereOf(const Shape& sphere, glm::dvec3 eye) {
    const glm::dvec3 center = pointOf(sphere, "center");
    const double radius = lengthOf(sphere, "radius"), away = glm::distance(eye, center);
    const glm::dvec3 towardsEye = away > 0 ? (eye - center) / away : glm::dvec3(0, 1, 0);
    // The anchor is a point that float32 holds; all else is worked out for it, so that its rounding moves nothing.
    const glm::dvec3 nearest = center + radius * towardsEye;
    const glm::dvec3 anchor{rounded(nearest.x), rounded(nearest.y), rounded(nearest.z)};
    const double reach = glm::distance(anchor, center);
    const double height = (reach - radius) * (reach + radius) / (2 * reach);
    return {ShapeKind::LargeSphere,
            {glm::dvec4(anchor, 1 / reach), glm::dvec4((anchor - center) / reach, height), glm::dvec4(0)}};
}

} // namespace

std::span<const ShapeRow> shapeTable() { return std::span(rows()).first(kShapeKinds - 2); }

const ShapeRow& shapeRow(ShapeKind kind) { return rows()[std::size_t(kind)]; }

glm::dvec3 pointOf(const Shape& shape, std::string_view key) {
    return glm::dvec3(shape.texels[std::size_t(fieldOf(shape, key).texel)]);
}

double lengthOf(const Shape& shape, std::string_view key) {
    const ShapeField& field = fieldOf(shape, key);
    return shape.texels[std::size_t(field.texel)][field.component];
}

glm::dvec3 referencePoint(const Shape& shape) {
    for (const ShapeField& field : shapeRow(shape.kind).fields)
        if (field.type == FieldType::Point || field.type == FieldType::Vertices)
            return glm::dvec3(shape.texels[std::size_t(field.texel)]);
    return glm::dvec3(0);
}

double sizeOf(const Shape& shape) {
    double size = 0;
    std::array<glm::dvec3, kMaxShapeTexels> points;
    std::size_t count = 0;
    for (const ShapeField& field : shapeRow(shape.kind).fields) {
        const glm::dvec4* texel = &shape.texels[std::size_t(field.texel)];
        for (int i = 0; i < pointsOf(field.type); ++i) points[count++] = glm::dvec3(texel[i]);
        if (field.type == FieldType::Length) size = std::max(size, (*texel)[field.component]);
        if (field.type == FieldType::Lengths) size = std::max(size, glm::length(glm::dvec3(*texel)));
    }
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < i; ++k) size = std::max(size, glm::distance(points[i], points[k]));
    return size > 0 ? size : std::numeric_limits<double>::infinity();
}

Shape drawnAs(ShapeKind kind, const Shape& shape, glm::dvec3 eye) {
    return kind == ShapeKind::LargeSphere ? largeSphereOf(shape, eye) : shape;
}

Shape translated(Shape shape, glm::dvec3 by) {
    for (const ShapeField& field : shapeRow(shape.kind).fields) {
        for (int i = 0; i < pointsOf(field.type); ++i) shape.texels[std::size_t(field.texel + i)] += glm::dvec4(by, 0);
    }
    return shape;
}

} // namespace gnomon
