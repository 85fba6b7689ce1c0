// Grids over objects: every object is in the lists of all cells that it comes near, and however they move the grid
// takes as many texels as planned.
#include "tracer/accel/uniform_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace gnomon {
namespace {

std::vector<Bounds> cloud(int count, double radius, double spread, unsigned seed = 7) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> coordinate(-float(spread), float(spread));
    std::vector<Bounds> objects;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center(coordinate(random), coordinate(random), coordinate(random));
        objects.push_back({center - float(radius), center + float(radius)});
    }
    return objects;
}

/// A grid as the shader reads it.
struct Written {
    glm::vec3 corner, size;
    glm::ivec3 count;
    std::vector<glm::vec4> lists;

    Written(const GridPlan& plan, std::span<const Bounds> objects) : count(plan.count) {
        std::vector<glm::vec4> texels{glm::vec4(42)}; // what lies before it counts for nothing
        appendGrid(plan, objects, texels);
        EXPECT_EQ(int(texels.size()), 1 + plan.texels());
        corner = texels[1];
        size = texels[2];
        lists.assign(texels.begin() + 3, texels.end());
    }

    std::vector<int> at(glm::ivec3 cell) const {
        std::vector<int> all;
        int texel = (cell.z * count.y + cell.y) * count.x + cell.x;
        while (texel >= 0 && all.size() < 100000) {
            const glm::vec4 list = lists.at(std::size_t(texel));
            for (int k = 0; k < kCellListed && list[k] >= 0; ++k) all.push_back(int(list[k]));
            texel = int(list.w);
        }
        return all;
    }
};

/// Distance of a box from a cell along the axis where they are farthest apart, in cells.
double gap(const Written& grid, glm::ivec3 cell, const Bounds& object) {
    const glm::dvec3 low =
                         (glm::dvec3(object.low) - glm::dvec3(grid.corner)) / glm::dvec3(grid.size) - glm::dvec3(cell),
                     high =
                         (glm::dvec3(object.high) - glm::dvec3(grid.corner)) / glm::dvec3(grid.size) - glm::dvec3(cell);
    const glm::dvec3 apart = glm::max(low - 1.0, -high);
    return std::max({apart.x, apart.y, apart.z});
}

/// Listed where nearer than 1/64 of a cell, but for what float32 makes of the corner; and not where it is far.
void expectListed(const GridPlan& plan, std::span<const Bounds> objects) {
    const Written grid(plan, objects);
    for (int z = 0; z < plan.count.z; ++z)
        for (int y = 0; y < plan.count.y; ++y)
            for (int x = 0; x < plan.count.x; ++x) {
                std::vector<int> times(objects.size());
                for (const int i : grid.at({x, y, z})) ++times.at(std::size_t(i));
                for (std::size_t i = 0; i < objects.size(); ++i) {
                    ASSERT_LE(times[i], 1);
                    const double away = gap(grid, {x, y, z}, objects[i]);
                    const int listed = times[i];
                    ASSERT_TRUE(away >= 0.015 || listed == 1)
                        << "object " << i << " near cell " << x << " " << y << " " << z;
                    ASSERT_TRUE(away <= 0.017 || listed == 0)
                        << "object " << i << " far from " << x << " " << y << " " << z;
                }
            }
    for (const Bounds& object : objects) { // and none reaches beyond the grid
        ASSERT_TRUE(glm::all(glm::lessThan(grid.corner, object.low)));
        ASSERT_TRUE(glm::all(glm::greaterThan(grid.corner + grid.size * glm::vec3(grid.count), object.high)));
    }
}

TEST(Cells, ListWhatReachesIntoThem) {
    for (const auto& objects : {cloud(300, 0.05, 1), cloud(60, 0.4, 1), cloud(2, 0.1, 1), cloud(500, 0.01, 1)}) {
        const auto plan = planGrid(objects);
        ASSERT_TRUE(plan);
        EXPECT_GT(plan->cells(), 1);
        expectListed(*plan, objects);
    }
}

TEST(Cells, ListWhatIsFlat) {
    std::vector<Bounds> flat = cloud(200, 0.03, 1);
    for (Bounds& object : flat) object.low.y = object.high.y = 2;
    const auto plan = planGrid(flat);
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->count.y, 1);
    const Written grid(*plan, flat);
    std::size_t listed = 0;
    for (int x = 0; x < plan->count.x; ++x)
        for (int z = 0; z < plan->count.z; ++z) listed += grid.at({x, 0, z}).size();
    EXPECT_GE(listed, flat.size());
}

/// Lists outgrow their room where all objects gather: the grid is stretched, and still nothing is lost.
TEST(Cells, TakeAsManyTexelsWhereverObjectsGo) {
    const auto plan = planGrid(cloud(400, 0.05, 1));
    ASSERT_TRUE(plan);
    expectListed(*plan, cloud(400, 0.05, 1, 8));
    expectListed(*plan, cloud(400, 0.05, 30));
    expectListed(*plan, cloud(400, 0.05, 0.02));
    expectListed(*plan, std::vector<Bounds>(400, Bounds{glm::vec3(-1), glm::vec3(1)}));
}

TEST(Cells, AreNotPlannedWhereTheyAreOfNoUse) {
    EXPECT_FALSE(planGrid({}));
    std::vector<Bounds> far = cloud(300, 0.05, 1);
    for (Bounds& object : far) object.low += 1e5f, object.high += 1e5f;
    EXPECT_FALSE(planGrid(far)) << "float32 does not place such walls";
    EXPECT_LE(planGrid(std::vector<Bounds>(3000, Bounds{glm::vec3(-1), glm::vec3(1)})).value_or(GridPlan{}).cells(),
              1500);
}

/// The iterations that the plan expects are those of random lines: as many cells as they cross, more where lists are
/// long.
TEST(Cells, TellHowManyTurnsALineTakes) {
    const auto objects = cloud(1000, 0.03, 1);
    const auto plan = planGrid(objects);
    ASSERT_TRUE(plan);
    const Written grid(*plan, objects);
    const glm::dvec3 side = glm::dvec3(grid.size) * glm::dvec3(grid.count),
                     middle = glm::dvec3(grid.corner) + 0.5 * side;
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(-1, 1);
    double iterations = 0;
    int met = 0;
    for (int line = 0; line < 20000;
         ++line) { // uniform directions through uniform places of the ball's disc about the grid
        const glm::dvec3 direction = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        const glm::dvec3 across = glm::normalize(
            glm::cross(direction, glm::abs(direction.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
        const double radius = 0.5 * glm::length(side);
        const glm::dvec3 origin =
            middle + radius * (uniform(random) * across + uniform(random) * glm::cross(direction, across));
        glm::ivec3 last(-1);
        bool inside = false;
        for (double t = -radius; t < radius; t += 0.002) { // finer than all but the shortest stays in a cell
            const glm::dvec3 point = (origin + t * direction - glm::dvec3(grid.corner)) / glm::dvec3(grid.size);
            const glm::ivec3 cell(glm::floor(point));
            if (glm::any(glm::lessThan(cell, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(cell, grid.count)) ||
                cell == last)
                continue;
            inside = true;
            last = cell;
            iterations += std::max(1.0, double(grid.at(cell).size()));
        }
        met += inside;
    }
    EXPECT_NEAR(iterations / met / plan->iterations, 1, 0.05);
}

} // namespace
} // namespace gnomon
