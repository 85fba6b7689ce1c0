/// The shape table: every analytic shape the tracer knows, one row each.
///
/// A row gives the JSON key, the fields with their limits, and where each field lies in the texels the shader reads.
/// From it come the scene reader, the schema, the packed scene data and the names the shader builder looks for. Adding
/// a shape is one row here and one file shaders/primitive/KEY.glsl.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

/// Those that scene files name, and last what they may be drawn as: a huge sphere as a large sphere, a body of several
/// shapes and a Mandelbulb, which has only a distance, as a solid.
enum class ShapeKind {
    Sphere,
    Plane,
    Disc,
    Triangle,
    Torus,
    Box,
    Cylinder,
    Capsule,
    Cone,
    Mandelbulb,
    LargeSphere,
    Solid
};
inline constexpr int kShapeKinds = 12;

/// Most texels (vec4) the geometry of one shape may take.
inline constexpr int kMaxShapeTexels = 3;

enum class FieldType {
    Point,     ///< three coordinates, moves with the object
    Direction, ///< three numbers, not all zero; normalised on reading
    Length,    ///< one number > 0
    Number,    ///< one number > 0 that is no length
    Lengths,   ///< three numbers > 0, along x, y and z
    Vertices,  ///< three points in one JSON array, in texels `texel`, `texel + 1`, `texel + 2`
};

struct ShapeField {
    std::string_view key;
    FieldType type;
    int texel;     ///< first texel of the shape that holds it
    int component; ///< first component: 0 for vectors, 3 for a scalar beside one
    std::string_view help;
};

struct Shape; // below
struct Solid; // tracer/scene/solid.h

/// A box along the axes.
struct Extent {
    glm::dvec3 low, high;
};

struct ShapeRow {
    ShapeKind kind;
    std::string_view key;  ///< in scene files, and the file's name: shaders/primitive/KEY.glsl
    std::string_view type; ///< in GLSL: struct TYPE, loadTYPE, intersectTYPE, surfaceTYPE
    int texels;
    std::vector<ShapeField> fields; ///< all required
    /// What is wrong with a shape whose fields are each right; {} where nothing is. {what, remedy}
    std::array<std::string, 2> (*check)(const Shape&);
    /// The smallest box about the shape; null where it has no end, as a plane, or is told otherwise, as a large sphere.
    Extent (*extent)(const Shape&);
    bool convex;            ///< the set is, and so are its silhouettes: flat shapes, too
    bool expensive = false; ///< to meet: a ball about it is much cheaper to ask, where few rays come near it
};

/// One shape, its fields packed as the shader reads them.
struct Shape {
    ShapeKind kind = ShapeKind::Sphere;
    std::array<glm::dvec4, kMaxShapeTexels> texels{};
    std::shared_ptr<const Solid> solid{}; ///< of a solid; its numbers are relative to `home`
    glm::dvec3 home{0};                   ///< where the middle of a solid rests
};

/// The rows of the shapes that scene files name, in the order of ShapeKind.
std::span<const ShapeRow> shapeTable();
/// The row of any kind.
const ShapeRow& shapeRow(ShapeKind);

/// Reads a vector or scalar field back out of the packed shape.
glm::dvec3 pointOf(const Shape&, std::string_view field);
double lengthOf(const Shape&, std::string_view field);

/// The point that stands for the whole shape where another object moves around it: its centre, the point of a plane,
/// the first vertex.
glm::dvec3 referencePoint(const Shape&);

/// The longest of a shape's lengths and of the distances between its points; infinite where it has neither: a plane.
double sizeOf(const Shape&);

/// A shape as the shader reads it where it is drawn as `kind`: itself, or a sphere as a large sphere. A large sphere is
/// told from its point nearest to `eye`, where the picture is taken from: its errors grow with the distance from there,
/// as what they look like shrinks.
Shape drawnAs(ShapeKind kind, const Shape&, glm::dvec3 eye);

/// The shape moved by `by`: every point and vertex of it.
Shape translated(Shape, glm::dvec3 by);

} // namespace gnomon
