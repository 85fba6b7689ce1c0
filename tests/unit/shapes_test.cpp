// The shape table: rows agree with the enum and the texels, and shapes can be read back and moved through it.
#include "tracer/scene/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace gnomon {
namespace {

Shape torus(double major, double minor) {
    return {ShapeKind::Torus, {glm::dvec4(1, 2, 3, major), glm::dvec4(0, 1, 0, minor), glm::dvec4(0)}};
}

Shape triangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    return {ShapeKind::Triangle, {glm::dvec4(a, 0), glm::dvec4(b, 0), glm::dvec4(c, 0)}};
}

Shape cylinder(glm::dvec3 from, glm::dvec3 to) {
    return {ShapeKind::Cylinder, {glm::dvec4(from, 0.5), glm::dvec4(to, 0), glm::dvec4(0)}};
}

bool accepts(const Shape& shape) { return shapeRow(shape.kind).check(shape)[0].empty(); }

TEST(ShapeTable, IsInTheOrderOfItsKinds) {
    for (std::size_t i = 0; i < shapeTable().size(); ++i) EXPECT_EQ(std::size_t(shapeTable()[i].kind), i);
    for (int i = 0; i < kShapeKinds; ++i) EXPECT_EQ(int(shapeRow(ShapeKind(i)).kind), i);
}

TEST(ShapeTable, OffersEveryKindButThoseThatAreOnlyDrawn) {
    EXPECT_EQ(shapeTable().size(), std::size_t(kShapeKinds) - 2);
    for (const ShapeRow& row : shapeTable()) EXPECT_LT(row.kind, ShapeKind::LargeSphere);
}

TEST(ShapeTable, NamesEachShapeOnce) {
    std::set<std::string_view> keys, types;
    for (const ShapeRow& row : shapeTable())
        EXPECT_TRUE(keys.insert(row.key).second && types.insert(row.type).second) << row.key;
}

TEST(ShapeTable, PutsNoTwoFieldsInOneComponent) {
    for (const ShapeRow& row : shapeTable()) {
        std::set<int> taken;
        for (const ShapeField& field : row.fields) {
            const int texels = field.type == FieldType::Vertices ? 3 : 1,
                      components = field.type == FieldType::Length || field.type == FieldType::Number ? 1 : 3;
            for (int texel = 0; texel < texels; ++texel)
                for (int i = 0; i < components; ++i)
                    EXPECT_TRUE(taken.insert(4 * (field.texel + texel) + field.component + i).second)
                        << row.key << field.key;
            EXPECT_LE(field.texel + texels, row.texels) << row.key;
            EXPECT_LE(field.component + components, 4) << row.key;
        }
        EXPECT_LE(row.texels, kMaxShapeTexels) << row.key;
    }
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
    EXPECT_EQ(moved.texels[0], glm::dvec4(11, 22, 33, 2));
    EXPECT_EQ(moved.texels[1], glm::dvec4(0, 1, 0, 0.5));
}

TEST(Shape, MovesAllVerticesOfATriangle) {
    const Shape moved = translated(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), {0, 0, 5});
    EXPECT_EQ(moved.texels[0], glm::dvec4(0, 0, 5, 0));
    EXPECT_EQ(moved.texels[1], glm::dvec4(1, 0, 5, 0));
    EXPECT_EQ(moved.texels[2], glm::dvec4(0, 1, 5, 0));
}

TEST(Shape, MovesBothEndsOfACylinder) {
    const Shape moved = translated(cylinder({0, 0, 0}, {1, 0, 0}), {0, 0, 5});
    EXPECT_EQ(moved.texels[0], glm::dvec4(0, 0, 5, 0.5));
    EXPECT_EQ(moved.texels[1], glm::dvec4(1, 0, 5, 0));
}

TEST(Shape, MovesABoxButNotItsSize) {
    const Shape box{ShapeKind::Box, {glm::dvec4(1, 2, 3, 0), glm::dvec4(4, 5, 6, 0), glm::dvec4(0)}};
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
    EXPECT_EQ(sizeOf({ShapeKind::Box, {glm::dvec4(9, 9, 9, 0), glm::dvec4(2, 3, 6, 0), glm::dvec4(0)}}), 7);
    EXPECT_TRUE(std::isinf(sizeOf({ShapeKind::Plane, {glm::dvec4(0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0)}})));
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
