// Which objects make a regular block, and what the shader is told of it.
#include "tracer/accel/lattice.h"
#include "tracer/plan/prepared_scene.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace gnomon {
namespace {

Shape sphere(glm::dvec3 center, double radius) { return makeShape(ShapeKind::Sphere, {center}, {radius}); }

/// Spheres of radius .4 at a lattice from `first` on, in no order.
std::vector<Shape> lattice(glm::ivec3 cells, glm::dvec3 first = {0.5, -3, 7}, glm::dvec3 step = {1, 1.5, 2}) {
    std::vector<Shape> shapes;
    for (int x = 0; x < cells.x; ++x)
        for (int z = 0; z < cells.z; ++z)
            for (int y = 0; y < cells.y; ++y) shapes.push_back(sphere(first + step * glm::dvec3(x, y, z), 0.4));
    std::shuffle(shapes.begin(), shapes.end(), std::mt19937(5));
    return shapes;
}

std::optional<Lattice> found(const std::vector<Shape>& shapes) {
    std::vector<int> all(shapes.size());
    std::iota(all.begin(), all.end(), 0);
    return findLattice(shapes, all);
}

TEST(Lattice, HasOneMemberACellXFastest) {
    for (const glm::ivec3 cells : {glm::ivec3(4, 3, 5), glm::ivec3(8, 1, 1), glm::ivec3(1, 10, 10)}) {
        const auto shapes = lattice(cells);
        const auto block = found(shapes);
        ASSERT_TRUE(block);
        EXPECT_EQ(block->cells, cells);
        for (int i = 0; i < int(shapes.size()); ++i) {
            const glm::dvec3 cell(i % cells.x, i / cells.x % cells.y, i / cells.x / cells.y);
            const glm::dvec3 wanted = glm::dvec3(0.5, -3, 7) + glm::dvec3(1, 1.5, 2) * cell;
            EXPECT_EQ(pointOf(shapes[std::size_t(block->members[std::size_t(i)])], "center"), wanted);
        }
    }
}

TEST(Lattice, IsFoundAmongOthers) {
    auto shapes = lattice({5, 2, 2});
    shapes.insert(shapes.begin() + 3, sphere({0.5, -3, 8}, 0.2));
    shapes.push_back(sphere({100, 0, 0}, 7));
    const auto block = found(shapes);
    ASSERT_TRUE(block);
    EXPECT_EQ(block->cells, glm::ivec3(5, 2, 2));
    EXPECT_EQ(std::count(block->members.begin(), block->members.end(), 3), 0);
}

TEST(Lattice, IsNoneWhereTheLatticeIsNotOne) {
    const auto refuse = [](const char* what, const std::function<void(std::vector<Shape>&)>& spoil) {
        auto shapes = lattice({5, 2, 2});
        ASSERT_TRUE(found(shapes));
        spoil(shapes);
        EXPECT_FALSE(found(shapes)) << what;
    };
    refuse("a gap", [](auto& shapes) { shapes.pop_back(); });
    refuse("one moved", [](auto& shapes) { shapes[7].values[1] += 0.05; });
    refuse("two at one place", [](auto& shapes) { shapes[0] = shapes[1]; });
    refuse("one of another size", [](auto& shapes) { setLength(shapes[0], "radius", 0.3); });
    refuse("touching", [](auto& shapes) {
        for (Shape& shape : shapes) setLength(shape, "radius", 0.5);
    });
    refuse("too few", [](auto& shapes) { shapes = lattice({7, 1, 1}); });
    refuse("too far for float32", [](auto& shapes) { shapes = lattice({5, 2, 2}, {1e6, 0, 0}); });
}

// What the shader knows of a cell's object is the ball about the cell's middle.
TEST(Lattice, TellsABallAboutEachMember) {
    for (const glm::ivec3 cells : {glm::ivec3(4, 3, 5), glm::ivec3(8, 1, 1)}) {
        auto shapes = lattice(cells, {100.1, -33.3, 7.7}, {0.9, 0.85, 1.3});
        for (Shape& shape : shapes) shape.values[0] += 1e-4 * std::sin(shape.values[1]); // a little astray
        const auto block = found(shapes);
        ASSERT_TRUE(block);
        const auto member = [&](std::size_t i) { return shapes[std::size_t(block->members[i])]; };
        std::vector<glm::vec4> texels;
        appendTexels(block->cells, member(0), member(shapes.size() - 1), texels);
        ASSERT_EQ(int(texels.size()), kLatticeTexels);
        const glm::vec3 corner(texels[0]), size(texels[1]);
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            const int n = int(i);
            const glm::vec3 cell(n % cells.x, n / cells.x % cells.y, n / cells.x / cells.y);
            const glm::dvec3 middle(corner + (cell + 0.5f) * size), center = pointOf(member(i), "center");
            EXPECT_LE(glm::distance(middle, center) + 0.4, double(texels[0].w));
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_LE(std::abs(center[axis] - middle[axis]) + 0.4, 0.5 * size[axis]);
        }
        EXPECT_LT(texels[0].w, 0.41f);
    }
}

TEST(Layout, NumbersTheLatticeFirstThenCastersThenTheRest) {
    const Scene pro = test::sceneNamed("pro");
    const auto layouts = prepare(pro)->layout;
    ASSERT_FALSE(layouts.empty());
    const KindLayout& spheres = layouts[0];
    EXPECT_EQ(spheres.lattice, glm::ivec3(10, 1, 10));
    EXPECT_EQ(spheres.latticeMembers(), 100);
    ASSERT_EQ(int(spheres.objects.size()), 110);
    for (int i = 0; i < 110; ++i) {
        const Object& object = pro.objects[std::size_t(spheres.objects[std::size_t(i)])];
        EXPECT_EQ(object.castsShadow, i < spheres.casters) << i;
        if (i < 100) {
            EXPECT_EQ(pointOf(object.shape, "center"), glm::dvec3(2 * (i % 10) - 10, -7, 5 + 2 * (i / 10))) << i;
        }
    }
}

// What may move or casts no shadow is no member.
TEST(Layout, TakesOnlyRestingCastersIntoALattice) {
    Scene pro = test::sceneNamed("pro");
    for (Object& object : pro.objects)
        if (object.shape.kind == ShapeKind::Sphere && lengthOf(object.shape, "radius") == 0.8)
            object.castsShadow = false;
    EXPECT_EQ(prepare(pro)->layout[0].latticeMembers(), 0);
    pro = test::sceneNamed("pro");
    for (Object& object : pro.objects)
        if (object.shape.kind == ShapeKind::Sphere && lengthOf(object.shape, "radius") == 0.8)
            object.motion = Orbit{{1, 0, 0}, {0, 1, 0}, 1, -1};
    EXPECT_EQ(prepare(pro)->layout[0].latticeMembers(), 0);
}

// Of objects at one distance the one with the lowest number is seen: that must not depend on where the scene stands.
TEST(Layout, IsTheSameWhereverTheSceneStands) {
    const Scene pro = test::sceneNamed("pro");
    const auto here = prepare(pro)->layout, there = prepare(test::moved(pro, {1e6, -2e6, 3e6}))->layout;
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
        EXPECT_EQ(here[i].objects, there[i].objects);
        EXPECT_EQ(here[i].lattice, there[i].lattice);
    }
}

} // namespace
} // namespace gnomon
