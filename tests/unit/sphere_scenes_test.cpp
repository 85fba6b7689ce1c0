/// The scenes that `gnomon lab trace` measures growth with: what is said of them holds for every number of spheres.
#include "lab/trace/sphere_scenes.h"

#include "tracer/plan/camera.h"
#include "tracer/plan/prepared_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gnomon {
namespace {

bool operator==(const Shape& a, const Shape& b) { return a.kind == b.kind && a.values == b.values; }

glm::dvec3 centerOf(const Object& object) { return pointOf(object.shape, "center"); }

TEST(SphereScenes, HaveAsManySpheresAsAskedFor) {
    for (const int count : {8, 10, 50, 100, 1000}) {
        EXPECT_EQ(sphereScene(Arrangement::Random, count).objects.size(), std::size_t(count));
        EXPECT_EQ(sphereScene(Arrangement::Clustered, count).objects.size(), std::size_t(count));
    }
    EXPECT_EQ(sphereScene(Arrangement::Regular, 10).objects.size(), 8U);
    EXPECT_EQ(sphereScene(Arrangement::Regular, 100).objects.size(), 125U);
    EXPECT_EQ(sphereScene(Arrangement::Regular, 1000).objects.size(), 1000U);
    for (const int count : {8, 10, 100, 1000, 10000, 20000})
        EXPECT_EQ(spheresIn(Arrangement::Regular, spheresIn(Arrangement::Regular, count)),
                  spheresIn(Arrangement::Regular, count));
}

TEST(SphereScenes, CoverHalfAFaceOfTheCubeWithoutLeavingItOrOverlapping) {
    for (const Arrangement arrangement : kArrangements)
        for (const int count : {8, 27, 100, 1000}) {
            const Scene scene = sphereScene(arrangement, count);
            const double radius = lengthOf(scene.objects[0].shape, "radius");
            const double area = std::numbers::pi * radius * radius * double(scene.objects.size());
            EXPECT_NEAR(area / (kSphereCube * kSphereCube), 0.5, 1e-12) << scene.name;
            for (const Object& a : scene.objects) {
                ASSERT_EQ(lengthOf(a.shape, "radius"), radius) << scene.name;
                for (int axis = 0; axis < 3; ++axis)
                    ASSERT_LE(std::abs(centerOf(a)[axis]) + radius, 0.5 * kSphereCube) << scene.name;
                for (const Object& b : scene.objects)
                    if (&a != &b) {
                        ASSERT_GT(glm::distance(centerOf(a), centerOf(b)), 2 * radius) << scene.name;
                    }
            }
        }
}

TEST(SphereScenes, AreTheSameForTheSameSeedOnly) {
    for (const Arrangement arrangement : {Arrangement::Random, Arrangement::Clustered}) {
        const Scene first = sphereScene(arrangement, 100, 7), same = sphereScene(arrangement, 100, 7),
                    other = sphereScene(arrangement, 100, 8);
        int differing = 0;
        for (std::size_t i = 0; i < first.objects.size(); ++i) {
            EXPECT_TRUE(first.objects[i].shape == same.objects[i].shape);
            EXPECT_EQ(first.objects[i].motion->sin, same.objects[i].motion->sin);
            differing += !(first.objects[i].shape == other.objects[i].shape);
        }
        EXPECT_EQ(differing, 100);
    }
}

// All of a lattice is one block, nothing of the others is.
TEST(SphereScenes, MakeALatticeOnlyWhereTheyAreRegular) {
    const auto blocks = [](Arrangement arrangement) {
        const auto layout = prepare(sphereScene(arrangement, 100))->layout;
        EXPECT_EQ(layout.size(), 1U);
        return layout[0].latticeMembers();
    };
    EXPECT_EQ(blocks(Arrangement::Random), 0);
    EXPECT_EQ(blocks(Arrangement::Clustered), 0);
    EXPECT_EQ(blocks(Arrangement::Regular), 125);
}

// Heaps leave most of the cube empty: of its 1000 little cubes random spheres reach far more.
TEST(SphereScenes, AreHeapedWhereTheyAreClustered) {
    const auto reached = [](Arrangement arrangement) {
        std::vector<bool> cells(1000);
        for (const Object& object : sphereScene(arrangement, 1000).objects) {
            const glm::ivec3 cell = glm::floor(10.0 * (centerOf(object) / kSphereCube + 0.5));
            cells[std::size_t(cell.x + 10 * (cell.y + 10 * cell.z))] = true;
        }
        return std::count(cells.begin(), cells.end(), true);
    };
    EXPECT_GT(reached(Arrangement::Random), 550);
    EXPECT_LT(reached(Arrangement::Clustered), 350);
    EXPECT_EQ(reached(Arrangement::Regular), 1000);
}

// Every sphere moves, at time 0 from where it rests, except on the lattice, whose block must rest.
TEST(SphereScenes, MoveUnlessRegular) {
    for (const Arrangement arrangement : kArrangements) {
        const Scene scene = sphereScene(arrangement, 27);
        const auto now = shapesAt(scene, 0), later = shapesAt(scene, 0.1);
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            EXPECT_TRUE(now[i] == scene.objects[i].shape);
            EXPECT_EQ(later[i] == now[i], arrangement == Arrangement::Regular);
        }
    }
}

// The picture shows the whole cube, and not much else: otherwise the sky's pixels would hide how the others' cost
// grows.
TEST(SphereScenes, FillThePicture) {
    const CameraFrame camera = frameOf(sphereScene(Arrangement::Random, 8).camera);
    double highest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const glm::dvec3 ray = 0.5 * kSphereCube * side - camera.eye;
        const double across = glm::dot(ray, camera.right), up = glm::dot(ray, camera.up),
                     ahead = glm::dot(ray, camera.forward) * camera.halfHeight;
        EXPECT_LT(std::abs(across / ahead), 4.0 / 3);
        highest = std::max(highest, std::abs(up / ahead));
    }
    EXPECT_LT(highest, 1);
    EXPECT_GT(highest, 0.9);
}

} // namespace
} // namespace gnomon
