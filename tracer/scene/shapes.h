/// The shape table: every analytic shape the tracer knows, one row each.
///
/// A row gives the JSON key and the fields with their limits. From it come the scene reader, the schema, the packed
/// scene data and the shader's names (tracer/plan/shape_texels.h). Adding a shape is a ShapeKind here, one row in
/// shapes.cpp and one file shaders/primitive/KEY.glsl; a kind without its row does not compile.
#pragma once

#include "tracer/scene/height_patch.h"
#include "tracer/scene/space_patch.h"

#include <glm/glm.hpp>

#include <array>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace gnomon {

/// Those that scene files name, then those that only drawing knows: a huge sphere as a large sphere; a box along axes
/// of its own; a triangle whose corners have normals and image coordinates; a surface over a rectangle or in space,
/// which files call a patch; several shapes, and a Mandelbulb, which has only a distance, as a solid.
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
    Ellipsoid,
    LargeSphere,
    RotatedBox,
    SmoothTriangle,
    HeightPatch,
    SpacePatch,
    Solid
};
inline constexpr int kShapeKinds = int(ShapeKind::Solid) + 1;

/// Most values that the fields of one shape have.
inline constexpr int kMaxShapeValues = 9;

enum class FieldType {
    Point,     ///< three coordinates, moves with the object
    Direction, ///< three values, not all zero; normalised on reading
    Length,    ///< one value > 0
    Scalar,    ///< one value > 0 that is no length
    Lengths,   ///< three values > 0, along x, y and z
    Vertices,  ///< three points in one JSON array
    Rotation,  ///< degrees about x, y and z in scene files, 0 where they say none; kept as rotation.h has it
};

/// Vectors, of three values each, in a field of this type; 0 where it is one value.
constexpr int vectorCount(FieldType type) {
    if (type == FieldType::Length || type == FieldType::Scalar) return 0;
    return type == FieldType::Vertices ? 3 : 1;
}
constexpr int valueCount(FieldType type) { return vectorCount(type) > 0 ? 3 * vectorCount(type) : 1; }

/// What a value may be.
struct Range {
    double min, max;
    bool whole = false; ///< 1, 2, 3, …
};

struct ShapeField {
    std::string_view key;
    FieldType type;
    std::string_view help;
    Range scalar{1, 64}; ///< of a Scalar; the other types have the limits of all lengths and positions
    int at = 0;          ///< its first value's index among the shape's: FieldList sets it
};

/// The fields of a shape. Their values follow one another.
class FieldList {
  public:
    constexpr FieldList(std::initializer_list<ShapeField> fields) {
        for (const ShapeField& field : fields) {
            fields_[std::size_t(count_)] = field;
            fields_[std::size_t(count_++)].at = values_;
            values_ += gnomon::valueCount(field.type);
        }
    }
    constexpr const ShapeField* begin() const { return fields_.data(); }
    constexpr const ShapeField* end() const { return fields_.data() + count_; }
    constexpr int valueCount() const { return values_; }

  private:
    std::array<ShapeField, 4> fields_{};
    int count_ = 0, values_ = 0;
};

struct Shape; // below
struct Solid; // tracer/scene/solid.h

/// A box along the axes.
struct Extent {
    glm::dvec3 low, high;
};

struct ShapeRow {
    ShapeKind kind;
    std::string_view key; ///< in scene files, and the file's name: shaders/primitive/KEY.glsl
    FieldList fields;     ///< all required
    /// What is wrong with a shape whose fields are each right; {} where nothing is. {what, remedy}
    std::array<std::string, 2> (*check)(const Shape&);
    /// The smallest box about the shape; null where it has no end, as a plane, or is a large sphere.
    Extent (*extent)(const Shape&);
    bool convex;            ///< the set is, and so are its silhouettes: flat shapes, too
    bool expensive = false; ///< to intersect: its bounding sphere is much cheaper to ask, where few rays come near it
};

/// What the corners of a smooth triangle have beside their positions.
struct Corners {
    std::array<glm::dvec3, 3> normals; ///< unit
    std::array<glm::dvec2, 3> uv;
};

/// One shape: the values of its fields, in the order of the table.
struct Shape {
    ShapeKind kind = ShapeKind::Sphere;
    std::array<double, kMaxShapeValues> values{};
    std::shared_ptr<const Solid> solid{};     ///< of a solid; its values are relative to `home`
    glm::dvec3 home{0};                       ///< where the middle of a solid rests
    std::shared_ptr<const Corners> corners{}; ///< of a smooth triangle
    std::shared_ptr<const Heights> heights{}; ///< of a height patch, over the box's height: from -1/2 to 1/2
    std::shared_ptr<const SpaceNet> net{};    ///< of a patch in space
};

/// Vectors and scalars as the table has them, each in its order.
Shape makeShape(ShapeKind, std::initializer_list<glm::dvec3> vectors, std::initializer_list<double> scalars = {});

/// The rows of the shapes that scene files name, in the order of ShapeKind.
std::span<const ShapeRow> shapeTable();
/// The row of any kind.
const ShapeRow& shapeRow(ShapeKind);
/// The row whose fields scene files give under the key of `row`: a box may be rotated.
const ShapeRow& writtenRow(const ShapeRow& row);
/// What a shape of written fields is: a box that is not rotated has no axes of its own.
Shape simplest(const Shape&);
/// The same where nothing tells how it is rotated: an ellipsoid of equal radii is a sphere.
Shape unoriented(const Shape&);

/// The vector of a field, or the first of several, and its scalar.
glm::dvec3 pointOf(const Shape&, std::string_view field);
double lengthOf(const Shape&, std::string_view field);
/// All values of a field.
std::span<double> valuesOf(Shape&, std::string_view field);
std::span<const double> valuesOf(const Shape&, std::string_view field);
void setPoint(Shape&, std::string_view field, glm::dvec3);
void setLength(Shape&, std::string_view field, double);
/// Of a triangle.
glm::dvec3 vertexOf(const Shape&, int i);

/// The point that stands for the whole shape where another object moves around it: its centre, the point of a plane,
/// the first vertex.
glm::dvec3 referencePoint(const Shape&);

/// The longest of a shape's lengths and of the distances between its points; infinite where it has neither: a plane.
double sizeOf(const Shape&);

/// The shape moved by `by`: every point and vertex of it.
Shape translated(Shape, glm::dvec3 by);

/// The nearest float32, as a shader reads it.
double inFloat(double);
/// The shape of such values.
Shape inFloat(Shape);

} // namespace gnomon
