// The shape table: rows agree with the enum, texels follow from them, and shapes can be read back and moved through it.
#include "tracer/scene/shapes.h"

#include "tracer/plan/shape_texels.h"
#include "tracer/scene/rotation.h"
#include "tracer/shader/library.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace gnomon {
namespace {

Shape torus(double major, double minor) { return makeShape(ShapeKind::Torus, {{1, 2, 3}, {0, 1, 0}}, {major, minor}); }

Shape triangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) { return makeShape(ShapeKind::Triangle, {a, b, c}); }

Shape cylinder(glm::dvec3 from, glm::dvec3 to) { return makeShape(ShapeKind::Cylinder, {from, to}, {0.5}); }

bool accepts(const Shape& shape) { return shapeRow(shape.kind).check(shape)[0].empty(); }

TEST(ShapeTable, IsInTheOrderOfItsKinds) {
    for (std::size_t i = 0; i < shapeTable().size(); ++i) EXPECT_EQ(std::size_t(shapeTable()[i].kind), i);
    for (int i = 0; i < kShapeKinds; ++i) EXPECT_EQ(int(shapeRow(ShapeKind(i)).kind), i);
}

TEST(ShapeTable, OffersEveryKindButThoseThatAreOnlyDrawn) {
    EXPECT_EQ(shapeTable().size(), std::size_t(ShapeKind::LargeSphere));
    for (const ShapeRow& row : shapeTable()) EXPECT_LT(row.kind, ShapeKind::LargeSphere);
}

TEST(ShapeTable, NamesEachShapeOnce) {
    std::set<std::string_view> keys;
    std::set<std::string> types;
    for (const ShapeRow& row : shapeTable())
        EXPECT_TRUE(keys.insert(row.key).second && types.insert(glslTypeOf(row.kind)).second) << row.key;
}

TEST(ShapeTable, HasAFileOfTheShaderLibraryForEachShape) {
    for (int i = 0; i < kShapeKinds; ++i) {
        const ShapeRow& row = shapeRow(ShapeKind(i));
        if (row.kind == ShapeKind::Solid) continue; // generated
        const std::string text(shaderText("primitive/" + std::string(row.key) + ".glsl"));
        EXPECT_NE(text.find("struct " + glslTypeOf(row.kind)), std::string::npos) << row.key;
    }
}

TEST(ShapeTexels, HoldEveryValueOnceAndNoTexelOfNone) {
    for (int kind = 0; kind < kShapeKinds; ++kind) {
        const ShapeRow& row = shapeRow(ShapeKind(kind));
        Shape shape{row.kind, {}};
        std::multiset<double> values, packed;
        for (int i = 0; i < row.fields.valueCount(); ++i) values.insert(shape.values[std::size_t(i)] = 1 + i);
        const ShapeTexels texels = packedShape(shape);
        for (std::size_t i = 0; i < texels.size(); ++i) {
            EXPECT_EQ(texels[i] != glm::dvec4(0), int(i) < texelsOf(row.kind)) << row.key;
            for (int c = 0; c < 4; ++c)
                if (texels[i][c] != 0) packed.insert(texels[i][c]);
        }
        const bool rotates = std::any_of(row.fields.begin(), row.fields.end(), [](const ShapeField& field) {
            return field.type == FieldType::Rotation; // see below
        });
        EXPECT_TRUE(rotates || packed == values) << row.key;
    }
}

TEST(ShapeTexels, HoldVectorsFirstAndScalarsBesideThem) {
    const ShapeTexels ring = packedShape(torus(2, 0.5));
    EXPECT_EQ(ring[0], glm::dvec4(1, 2, 3, 2));
    EXPECT_EQ(ring[1], glm::dvec4(0, 1, 0, 0.5));
    EXPECT_EQ(texelsOf(ShapeKind::Torus), 2);
    const ShapeTexels bulb = packedShape(makeShape(ShapeKind::Mandelbulb, {{1, 2, 3}}, {4, 8, 5}));
    EXPECT_EQ(bulb[0], glm::dvec4(1, 2, 3, 4));
    EXPECT_EQ(bulb[1], glm::dvec4(8, 5, 0, 0));
    EXPECT_EQ(texelsOf(ShapeKind::Mandelbulb), 2);
    EXPECT_EQ(texelsOf(ShapeKind::Triangle), 3);
}

TEST(ShapeTexels, HoldTheAxesOfARotationToHalfARounding) {
    for (const ShapeKind kind : {ShapeKind::RotatedBox, ShapeKind::Ellipsoid}) {
        const glm::dvec3 rotate(0.1f, -0.45f, 0.7f);
        std::vector<glm::vec4> texels;
        appendShape(makeShape(kind, {{1, 2, 3}, {4, 5, 6}, rotate}), texels);
        ASSERT_EQ(texels.size(), 5u);
        EXPECT_EQ(glm::vec3(texels[1]), glm::vec3(4, 5, 6));
        for (int i = 0; i < 3; ++i)
            EXPECT_LE(glm::distance(glm::dvec3(texels[std::size_t(2 + i)]), axesOf(rotate)[i]), 0x1p-24) << i;
    }
}

TEST(GlslTypes, AreTheKeysInPascalCase) {
    EXPECT_EQ(glslTypeOf(ShapeKind::Torus), "Torus");
    EXPECT_EQ(glslTypeOf(ShapeKind::LargeSphere), "LargeSphere");
}

TEST(Shape, GivesItsFieldsBack) {
    const Shape shape = torus(2, 0.5);
    EXPECT_EQ(pointOf(shape, "center"), glm::dvec3(1, 2, 3));
    EXPECT_EQ(pointOf(shape, "axis"), glm::dvec3(0, 1, 0));
    EXPECT_EQ(lengthOf(shape, "major_radius"), 2);
    EXPECT_EQ(lengthOf(shape, "minor_radius"), 0.5);
}

TEST(Shape, MovesItsPointsButNeitherDirectionsNorLengths) {
    const Shape moved = translated(torus(2, 0.5), {10, 20, 30});
    EXPECT_EQ(moved.values, makeShape(ShapeKind::Torus, {{11, 22, 33}, {0, 1, 0}}, {2, 0.5}).values);
}

TEST(Shape, MovesAllVerticesOfATriangle) {
    const Shape moved = translated(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), {0, 0, 5});
    EXPECT_EQ(moved.values, triangle({0, 0, 5}, {1, 0, 5}, {0, 1, 5}).values);
}

TEST(Shape, MovesBothEndsOfACylinder) {
    const Shape moved = translated(cylinder({0, 0, 0}, {1, 0, 0}), {0, 0, 5});
    EXPECT_EQ(moved.values, cylinder({0, 0, 5}, {1, 0, 5}).values);
}

TEST(Shape, MovesABoxButNotItsSize) {
    const Shape box = makeShape(ShapeKind::Box, {{1, 2, 3}, {4, 5, 6}});
    const Shape moved = translated(box, {10, 20, 30});
    EXPECT_EQ(pointOf(moved, "center"), glm::dvec3(11, 22, 33));
    EXPECT_EQ(pointOf(moved, "half_size"), glm::dvec3(4, 5, 6));
}

TEST(Shape, IsStoodForByItsFirstPoint) {
    EXPECT_EQ(referencePoint(torus(2, 0.5)), glm::dvec3(1, 2, 3));
    EXPECT_EQ(referencePoint(triangle({4, 5, 6}, {1, 0, 0}, {0, 1, 0})), glm::dvec3(4, 5, 6));
}

TEST(Shape, HasTheSizeOfItsLongestPart) {
    EXPECT_EQ(sizeOf(torus(2, 0.5)), 2);
    EXPECT_EQ(sizeOf(cylinder({1, 2, 3}, {1, 2, 7})), 4);
    EXPECT_EQ(sizeOf(cylinder({0, 0, 0}, {0, 0.1, 0})), 0.5) << "its radius";
    EXPECT_EQ(sizeOf(triangle({0, 0, 0}, {3, 0, 0}, {0, 4, 0})), 5);
    EXPECT_EQ(sizeOf(makeShape(ShapeKind::Box, {{9, 9, 9}, {2, 3, 6}})), 7);
    EXPECT_TRUE(std::isinf(sizeOf(makeShape(ShapeKind::Plane, {{0, 0, 0}, {0, 1, 0}}))));
}

TEST(Torus, NeedsAHole) {
    EXPECT_TRUE(accepts(torus(1, 0.999)));
    EXPECT_FALSE(accepts(torus(1, 1)));
    EXPECT_FALSE(accepts(torus(1, 1 - 1e-9))) << "equal in float32";
    EXPECT_FALSE(accepts(torus(1, 2)));
}

TEST(Axis, NeedsTwoPointsThatFloatsCanTell) {
    EXPECT_TRUE(accepts(cylinder({0, 0, 0}, {0, 1e-5, 0}))) << "short is not nothing";
    EXPECT_TRUE(accepts(cylinder({0, 0, 0}, {0, 1e-6, 0}))) << "the limit itself";
    EXPECT_FALSE(accepts(cylinder({1, 2, 3}, {1, 2, 3})));
    EXPECT_FALSE(accepts(cylinder({0, 0, 0}, {0, 1e-7, 0})));
    EXPECT_FALSE(accepts(cylinder({1000, 0, 0}, {1000 + 1e-5, 0, 0}))) << "one point in float32";
}

TEST(Triangle, NeedsAnAreaThatFloatsCanTell) {
    EXPECT_TRUE(accepts(triangle({0, 0, 0}, {1, 0, 0}, {0, 1e-3, 0})));
    EXPECT_TRUE(accepts(triangle({0, 0, 0}, {1e-5, 0, 0}, {0, 1e-5, 0}))) << "small is not flat";
    EXPECT_FALSE(accepts(triangle({0, 0, 0}, {0, 0, 0}, {0, 1, 0})));
    EXPECT_FALSE(accepts(triangle({1e6, 0, 0}, {1e6 + 0.01, 0, 0}, {1e6, 0.01, 0}))) << "two vertices are one float";
}

} // namespace
} // namespace gnomon
