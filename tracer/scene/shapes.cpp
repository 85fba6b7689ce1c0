#include "tracer/scene/shapes.h"

#include "tracer/problem.h"
#include "tracer/scene/rotation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>

namespace gnomon {

namespace {

using Complaint = std::array<std::string, 2>;

Complaint nothingWrong(const Shape&) { return {}; }

/// A triangle counts as degenerate where its height over its longest edge is below what float32 resolves of that edge.
Complaint checkTriangle(const Shape& shape) {
    constexpr double kFloatResolution = 1.0 / (1 << 22);
    const auto vertex = [&](int i) { return glm::dvec3(glm::vec3(vertexOf(shape, i))); };
    const glm::dvec3 a = vertex(0), b = vertex(1), c = vertex(2);
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

/// Rays see it in lengths of its radii, where the shortest one decides what rounding is.
Complaint checkEllipsoid(const Shape& shape) {
    constexpr double kMostRatio = 1e4;
    const glm::dvec3 radii = pointOf(shape, "radii");
    const double longest = std::max({radii.x, radii.y, radii.z}), shortest = std::min({radii.x, radii.y, radii.z});
    if (longest <= kMostRatio * shortest) return {};
    return {"its longest radius, " + toString(longest) + ", is over " + toString(kMostRatio) + " times its shortest, " +
                toString(shortest),
            "use a disc, or radii that differ less"};
}

/// Longer ones leave the rays that meet them no digits.
Complaint checkHeightPatch(const Shape& shape) {
    constexpr double kMostRatio = 1e4;
    const glm::dvec3 size = pointOf(shape, "size");
    const double longest = std::max({size.x, size.y, size.z}), shortest = std::min(size.x, size.z);
    constexpr double kLongest = 1e6;
    if (size.y > kLongest) return {"its heights span " + toString(size.y), "keep them within " + toString(kLongest)};
    if (longest <= kMostRatio * shortest) return {};
    return {"its longest side, " + toString(longest) + ", is over " + toString(kMostRatio) +
                " times the shorter side of its rectangle, " + toString(shortest),
            "use sizes and heights that differ less"};
}

/// What the shader forms of its size keeps its digits.
Complaint checkSpacePatch(const Shape& shape) {
    constexpr double kSmallest = 1e-6, kLargest = 1e6;
    const double radius = lengthOf(shape, "radius");
    if (radius >= kSmallest && radius <= kLargest) return {};
    return {"its surface reaches " + toString(radius) + " from its middle",
            "keep that from " + toString(kSmallest) + " to " + toString(kLargest)};
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
    const glm::dvec3 a = vertexOf(s, 0), b = vertexOf(s, 1), c = vertexOf(s, 2);
    return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

Extent torusExtent(const Shape& s) {
    return about(pointOf(s, "center"),
                 lengthOf(s, "major_radius") * circleReach(pointOf(s, "axis")) + lengthOf(s, "minor_radius"));
}

Extent boxExtent(const Shape& s) { return about(pointOf(s, "center"), pointOf(s, "half_size")); }

/// The lengths of the rows of axes * reach.
glm::dvec3 lengthsOfRows(const glm::dmat3& axes, glm::dvec3 reach) {
    glm::dvec3 squares{0};
    for (int i = 0; i < 3; ++i) squares += (axes[i] * reach[i]) * (axes[i] * reach[i]);
    return glm::sqrt(squares);
}

Extent ellipsoidExtent(const Shape& s) {
    return about(pointOf(s, "center"), lengthsOfRows(axesOf(pointOf(s, "rotate")), pointOf(s, "radii")));
}

Extent rotatedExtent(const Shape& s, glm::dvec3 half) {
    const glm::dmat3 axes = axesOf(pointOf(s, "rotate"));
    glm::dvec3 reach{0};
    for (int i = 0; i < 3; ++i) reach += glm::abs(axes[i] * half[i]);
    return about(pointOf(s, "center"), reach);
}

Extent rotatedBoxExtent(const Shape& s) { return rotatedExtent(s, pointOf(s, "half_size")); }
Extent heightPatchExtent(const Shape& s) { return rotatedExtent(s, 0.5 * pointOf(s, "size")); }

Extent spacePatchExtent(const Shape& s) {
    const glm::dvec3 anchor = pointOf(s, "anchor");
    return {anchor + s.net->low, anchor + s.net->high};
}

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
    const double reach = std::pow(2.0, 1 / (lengthOf(s, "power") - 1));
    return about(pointOf(s, "center"), glm::dvec3(reach * lengthOf(s, "radius")));
}

using enum FieldType;

// clang-format off
constexpr ShapeRow kRows[] = {
    {ShapeKind::Sphere, "sphere",
     {{"center", Point, "Centre"},
      {"radius", Length, "Radius"}},
     nothingWrong, sphereExtent, true},
    {ShapeKind::Plane, "plane",
     {{"point", Point, "Any point of the plane"},
      {"normal", Direction, "Direction across the plane, of any length"}},
     nothingWrong, nullptr, true},
    {ShapeKind::Disc, "disc",
     {{"center", Point, "Centre"},
      {"normal", Direction, "Direction across the disc, of any length"},
      {"radius", Length, "Radius"}},
     nothingWrong, discExtent, true},
    {ShapeKind::Triangle, "triangle",
     {{"vertices", Vertices, "Three points a, b, c; the outside is where cross(b - a, c - a) points"}},
     checkTriangle, triangleExtent, true},
    {ShapeKind::Torus, "torus",
     {{"center", Point, "Centre of the hole"},
      {"axis", Direction, "Direction through the hole, of any length"},
      {"major_radius", Length, "From the centre to the middle of the tube"},
      {"minor_radius", Length, "Radius of the tube, less than major_radius"}},
     checkTorus, torusExtent, false, true},
    {ShapeKind::Box, "box",
     {{"center", Point, "Centre"},
      {"half_size", Lengths, "From the centre to the faces across x, y and z"}},
     nothingWrong, boxExtent, true},
    {ShapeKind::Cylinder, "cylinder",
     {{"from", Point, "Centre of one end"},
      {"to", Point, "Centre of the other end"},
      {"radius", Length, "Radius"}},
     checkAxis, cylinderExtent, true, true},
    {ShapeKind::Capsule, "capsule",
     {{"from", Point, "Centre of the round end"},
      {"to", Point, "Centre of the other round end"},
      {"radius", Length, "Radius of the ends and of the cylinder between them"}},
     checkAxis, capsuleExtent, true, true},
    {ShapeKind::Cone, "cone",
     {{"from", Point, "Centre of the base"},
      {"to", Point, "Apex"},
      {"radius", Length, "Radius of the base"}},
     checkAxis, coneExtent, true, true},
    {ShapeKind::Mandelbulb, "mandelbulb",
     {{"center", Point, "Centre"},
      {"radius", Length, "Unit of length: the bulb of power 8 reaches about 1.2 of them"},
      {"power", Scalar, "Power of the map; 8 is the known one", {2, 16}},
      {"iterations", Scalar, "How often points are mapped: more show finer detail", {1, 32, true}}},
     nothingWrong, mandelbulbExtent, false},
    {ShapeKind::Ellipsoid, "ellipsoid",
     {{"center", Point, "Centre"},
      {"radii", Lengths, "From the centre along each of its axes, which are x, y and z before it is rotated"},
      {"rotate", Rotation, "Degrees about x, then y, then z; default [0, 0, 0]"}},
     checkEllipsoid, ellipsoidExtent, true, true},
    {ShapeKind::LargeSphere, "large_sphere",
     {{"anchor", Point, "Its point nearest to the eye"},
      {"normal", Direction, "There"},
      {"curvature", Scalar, "1 / the distance of the anchor from the centre"},
      {"height", Scalar, "Of the anchor above the surface, of either sign"}},
     nothingWrong, nullptr, true},
    {ShapeKind::RotatedBox, "rotated_box",
     {{"center", Point, "Centre"},
      {"half_size", Lengths, "From the centre to the faces across x, y and z, before it is rotated"},
      {"rotate", Rotation, "Degrees about x, then y, then z; default [0, 0, 0]"}},
     nothingWrong, rotatedBoxExtent, true},
    {ShapeKind::SmoothTriangle, "smooth_triangle",
     {{"vertices", Vertices, "Three points a, b, c; the outside is where cross(b - a, c - a) points"}},
     checkTriangle, triangleExtent, true},
    {ShapeKind::HeightPatch, "height_patch",
     {{"center", Point, "Middle of the box about it"},
      {"size", Lengths, "Sides of that box before it is rotated"},
      {"rotate", Rotation, "Of the box"}},
     checkHeightPatch, heightPatchExtent, false, true},
    {ShapeKind::SpacePatch, "space_patch",
     {{"anchor", Point, "What its control points are relative to"},
      {"center", Point, "Centre of a sphere about it"},
      {"radius", Length, "Radius of that sphere"}},
     checkSpacePatch, spacePatchExtent, false, true},
    {ShapeKind::Solid, "solid",
     {{"center", Point, "Centre of its bounding sphere"},
      {"radius", Length, "Radius of that sphere"}},
     nothingWrong, sphereExtent, false},
};
// clang-format on

constexpr bool inOrderOfTheirKinds() {
    for (int i = 0; i < kShapeKinds; ++i)
        if (int(kRows[i].kind) != i || kRows[i].fields.valueCount() > kMaxShapeValues) return false;
    return true;
}
static_assert(std::size(kRows) == std::size_t(kShapeKinds), "every ShapeKind has a row in the shape table");
static_assert(inOrderOfTheirKinds(), "rows stand in the order of ShapeKind, with no more values than kMaxShapeValues");

const ShapeField& fieldOf(const Shape& shape, std::string_view key) {
    const auto& fields = shapeRow(shape.kind).fields;
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const ShapeField& f) { return f.key == key; });
    assert(field != fields.end());
    return *field;
}

int pointsOf(FieldType type) { return type == FieldType::Vertices || type == FieldType::Point ? vectorCount(type) : 0; }

glm::dvec3 vectorAt(const Shape& shape, int at) {
    const double* values = &shape.values[std::size_t(at)];
    return {values[0], values[1], values[2]};
}

} // namespace

std::span<const ShapeRow> shapeTable() { return std::span(kRows).first(std::size_t(ShapeKind::LargeSphere)); }

const ShapeRow& shapeRow(ShapeKind kind) { return kRows[std::size_t(kind)]; }

const ShapeRow& writtenRow(const ShapeRow& row) {
    return row.kind == ShapeKind::Box ? shapeRow(ShapeKind::RotatedBox) : row;
}

Shape simplest(const Shape& shape) {
    if (shape.kind != ShapeKind::RotatedBox || pointOf(shape, "rotate") != glm::dvec3(0)) return shape;
    return makeShape(ShapeKind::Box, {pointOf(shape, "center"), pointOf(shape, "half_size")});
}

Shape unoriented(const Shape& shape) {
    if (shape.kind != ShapeKind::Ellipsoid) return shape;
    const glm::dvec3 radii = pointOf(shape, "radii");
    const bool round = glm::distance(radii, glm::dvec3(radii.x)) <= 1e-9 * radii.x;
    return round ? makeShape(ShapeKind::Sphere, {pointOf(shape, "center")}, {radii.x}) : shape;
}

Shape makeShape(ShapeKind kind, std::initializer_list<glm::dvec3> vectors, std::initializer_list<double> scalars) {
    Shape shape{kind, {}};
    const glm::dvec3* vector = vectors.begin();
    const double* scalar = scalars.begin();
    for (const ShapeField& field : shapeRow(kind).fields) {
        double* to = &shape.values[std::size_t(field.at)];
        const int count = vectorCount(field.type);
        for (int i = 0; i < count; ++i, ++vector) to = std::copy_n(&vector->x, 3, to);
        if (count == 0) *to = *scalar++;
    }
    assert(vector == vectors.end() && scalar == scalars.end());
    return shape;
}

std::span<const double> valuesOf(const Shape& shape, std::string_view key) {
    const ShapeField& field = fieldOf(shape, key);
    return std::span(shape.values).subspan(std::size_t(field.at), std::size_t(valueCount(field.type)));
}

std::span<double> valuesOf(Shape& shape, std::string_view key) {
    const ShapeField& field = fieldOf(shape, key);
    return std::span(shape.values).subspan(std::size_t(field.at), std::size_t(valueCount(field.type)));
}

glm::dvec3 pointOf(const Shape& shape, std::string_view key) { return vectorAt(shape, fieldOf(shape, key).at); }

double lengthOf(const Shape& shape, std::string_view key) { return valuesOf(shape, key)[0]; }

void setPoint(Shape& shape, std::string_view key, glm::dvec3 to) {
    std::copy_n(&to.x, 3, valuesOf(shape, key).begin());
}

void setLength(Shape& shape, std::string_view key, double to) { valuesOf(shape, key)[0] = to; }

glm::dvec3 vertexOf(const Shape& shape, int i) { return vectorAt(shape, 3 * i); }

glm::dvec3 referencePoint(const Shape& shape) {
    for (const ShapeField& field : shapeRow(shape.kind).fields)
        if (pointsOf(field.type) > 0) return vectorAt(shape, field.at);
    return glm::dvec3(0);
}

double sizeOf(const Shape& shape) {
    double size = 0;
    std::array<glm::dvec3, kMaxShapeValues / 3> points;
    std::size_t count = 0;
    for (const ShapeField& field : shapeRow(shape.kind).fields) {
        for (int i = 0; i < pointsOf(field.type); ++i) points[count++] = vectorAt(shape, field.at + 3 * i);
        if (field.type == FieldType::Length) size = std::max(size, shape.values[std::size_t(field.at)]);
        if (field.type == FieldType::Lengths) size = std::max(size, glm::length(vectorAt(shape, field.at)));
    }
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < i; ++k) size = std::max(size, glm::distance(points[i], points[k]));
    return size > 0 ? size : std::numeric_limits<double>::infinity();
}

Shape translated(Shape shape, glm::dvec3 by) {
    for (const ShapeField& field : shapeRow(shape.kind).fields)
        for (int i = 0; i < 3 * pointsOf(field.type); ++i) shape.values[std::size_t(field.at + i)] += by[i % 3];
    return shape;
}

double inFloat(double x) {
    // Through memory: GCC 12 at -O2 leaves the rounding of two neighbours out (SLP vectorizer; -O1,
    // -fno-tree-slp-vectorize and clang do not).
    const volatile float stored = float(x);
    return stored;
}

Shape inFloat(Shape shape) {
    for (double& value : shape.values) value = inFloat(value);
    if (shape.net) {
        SpaceNet net = *shape.net;
        for (glm::dvec4& p : net.points) p = {inFloat(p.x), inFloat(p.y), inFloat(p.z), inFloat(p.w)};
        shape.net = std::make_shared<const SpaceNet>(net);
    }
    if (!shape.heights) return shape;
    Heights heights = *shape.heights;
    for (double& height : heights) height = inFloat(height);
    shape.heights = std::make_shared<const Heights>(heights);
    return shape;
}

} // namespace gnomon
