// Hierarchies as texels: what they say of the tree, and that no ray's walk through them loses anything.
#include "tracer/accel/node_texels.h"

#include "tests/support/texel_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>

namespace gnomon {
namespace {

using namespace test;

using Boxes = std::vector<Bounds>;

Bounds boxAt(glm::dvec3 middle, glm::dvec3 half) { return {glm::vec3(middle - half), glm::vec3(middle + half)}; }

/// Somewhere in a box of this half size about `middle`, each smaller by `fraction`.
Boxes scattered(int count, glm::dvec3 middle, glm::dvec3 reach, double fraction) {
    Dice dice(4);
    Boxes boxes;
    for (int i = 0; i < count; ++i)
        boxes.push_back(boxAt(middle + reach * dice.point(1), fraction * dice.number(0, 1) * reach));
    return boxes;
}

const std::map<std::string, Boxes>& sets() {
    static const std::map<std::string, Boxes> all = [] {
        std::map<std::string, Boxes> sets;
        for (const auto& [name, balls] : clouds()) sets.emplace(name, boundsOfAll(balls));
        const glm::dvec3 zero(0), far(1e6, -1e6, 1e6);
        sets["flat"] = scattered(300, {0, 0.1, 0}, {1, 0, 1}, 0.05);
        sets["needle"] = scattered(300, {0.3, 0.1, -7}, {0, 0, 1}, 0.01);
        sets["point"] = Boxes(50, boxAt({0.1, -0.2, 0.3}, zero));
        sets["point at zero"] = Boxes(50, boxAt(zero, zero));
        sets["point far away"] = Boxes(50, boxAt(far, zero));
        sets["huge"] = scattered(300, zero, glm::dvec3(1e6), 0.1);
        sets["huge and flat"] = scattered(300, zero, {1e6, 1e-3, 1e6}, 0.1);
        sets["far away"] = scattered(300, far, glm::dvec3(10), 0.1);
        sets["far away and flat"] = scattered(300, far, {10, 0, 10}, 0.1);
        sets["tiny"] = scattered(300, {1e-3, 0, 0}, glm::dvec3(1e-6), 0.1);
        sets["points"] = scattered(300, zero, glm::dvec3(1), 0);
        return sets;
    }();
    return all;
}

Bounds whole(const Boxes& boxes) {
    Bounds box;
    for (const Bounds& other : boxes) box = merged(box, other);
    return box;
}

const std::vector<glm::vec3>& eyes() {
    static const std::vector<glm::vec3> all{{0, 0, 0}, {3, 1, -2}, {-0.5, 0.25, 0.125}, {1e5, -2e5, 1e4}};
    return all;
}

// ---- What they say

/// Node texels taken apart, in the order of the texels.
struct Read {
    glm::dvec3 low, high; ///< in cells
    int after;            ///< the node after all below
    int primitive;        ///< -1: an inner node
};

std::vector<Read> readNodes(std::span<const glm::vec4> texels) {
    std::vector<Read> nodes;
    for (const glm::vec4 texel : texels.subspan(kQuantisationTexels)) {
        const glm::dvec3 both(texel), high = glm::floor(both / 4096.0);
        const int link = int(texel.w), next = int(nodes.size()) + 1;
        nodes.push_back({both - 4096.0 * high, high, link < 0 ? next : link, link < 0 ? -1 - link : -1});
    }
    return nodes;
}

/// The box of all primitives below each node, by the links.
Boxes boxesBelow(const std::vector<Read>& nodes, const Boxes& boxes) {
    Boxes below(nodes.size());
    for (std::size_t i = nodes.size(); i-- > 0;)
        below[i] = nodes[i].primitive >= 0 ? boxes[std::size_t(nodes[i].primitive)]
                                           : merged(below[i + 1], below[std::size_t(nodes[i + 1].after)]);
    return below;
}

class NodeTexels : public testing::TestWithParam<std::string> {
  protected:
    const Boxes& boxes = sets().at(GetParam());
    const Hierarchy hierarchy = build(boxes);
};

TEST_P(NodeTexels, AreWholeNumbersOfTheGrid) {
    const auto texels = texelsOf(hierarchy, {1, 2, 3});
    ASSERT_EQ(int(texels.size()), hierarchyTexels(int(boxes.size())));
    const Bounds root = hierarchy.nodes[0].bounds;
    const glm::vec3 side = root.high - root.low;
    EXPECT_EQ(texels[0], glm::vec4(root.low, std::max({side.x, side.y, side.z, 1e-18f})));
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(texels[1][i] > 0 && std::isfinite(texels[1][i]));
    for (const glm::vec4 texel : std::span(texels).subspan(kQuantisationTexels))
        EXPECT_EQ(texel, glm::floor(texel)) << "as all numbers below 2^24 may be";
    for (const Read& node : readNodes(texels))
        for (int i = 0; i < 3; ++i) {
            EXPECT_GE(node.low[i], 0);
            EXPECT_LT(node.low[i], node.high[i]);
            EXPECT_LE(node.high[i], kQuantisationSteps);
        }
}

// Each primitive has one leaf, and each link leads past all that is below.
TEST_P(NodeTexels, AreTheTreeForEveryEye) {
    for (const glm::vec3 eye : eyes()) {
        const auto nodes = readNodes(texelsOf(hierarchy, eye));
        std::vector<int> seen(boxes.size()), ends;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            while (!ends.empty() && ends.back() == int(i)) ends.pop_back();
            ASSERT_LE(nodes[i].after, ends.empty() ? int(nodes.size()) : ends.back()) << "within its parent";
            ends.push_back(nodes[i].after);
            if (nodes[i].primitive >= 0) {
                ++seen.at(std::size_t(nodes[i].primitive));
                continue;
            }
            const std::size_t second = std::size_t(nodes[i + 1].after);
            ASSERT_LT(second, nodes.size());
            ASSERT_EQ(nodes[second].after, nodes[i].after) << "two children and nothing else";
        }
        EXPECT_EQ(nodes[0].after, int(nodes.size()));
        EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(boxes.size()));
    }
}

TEST_P(NodeTexels, HoldTheirBoxesWithLessThanTwoCellsToSpare) {
    const auto texels = texelsOf(hierarchy, eyes()[1]);
    const auto nodes = readNodes(texels);
    const Boxes below = boxesBelow(nodes, boxes);
    const glm::dvec3 origin(texels[0]), cells(texels[1]);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const glm::dvec3 low = (glm::dvec3(below[i].low) - origin) * cells;
        const glm::dvec3 high = (glm::dvec3(below[i].high) - origin) * cells;
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_LE(nodes[i].low[axis], low[axis]) << "node " << i;
            ASSERT_GE(nodes[i].high[axis], high[axis]) << "node " << i;
            ASSERT_LT(low[axis] - nodes[i].low[axis], 2) << "node " << i;
            ASSERT_LT(nodes[i].high[axis] - high[axis], 2) << "node " << i;
        }
    }
}

TEST_P(NodeTexels, HaveTheChildNearerToTheEyeFirst) {
    for (const glm::vec3 eye : eyes()) {
        const auto nodes = readNodes(texelsOf(hierarchy, eye));
        const Boxes below = boxesBelow(nodes, boxes);
        const auto distance = [&](std::size_t node) {
            return glm::distance(0.5 * (glm::dvec3(below[node].low) + glm::dvec3(below[node].high)), glm::dvec3(eye));
        };
        const Bounds all = whole(boxes);
        const double rounding = 0x1p-21 * (glm::length(eye) + glm::length(all.low) + glm::length(all.high));
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (nodes[i].primitive < 0) {
                ASSERT_LE(distance(i + 1), distance(std::size_t(nodes[i + 1].after)) + rounding) << "node " << i;
            }
    }
}

std::vector<std::string> namesOfSets() {
    std::vector<std::string> names;
    for (const auto& [name, boxes] : sets()) names.push_back(name);
    return names;
}

std::string testName(const testing::TestParamInfo<std::string>& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Sets, NodeTexels, testing::ValuesIn(namesOfSets()), testName);

TEST(NodeTexels, OfNothingAreNone) {
    EXPECT_TRUE(texelsOf(build({}), {1, 2, 3}).empty());
    EXPECT_EQ(hierarchyTexels(0), 0);
}

TEST(NodeTexels, OfOneAreTheGridAndALeaf) {
    EXPECT_EQ(hierarchyTexels(1), kQuantisationTexels + 1);
    const auto texels = texelsOf(build(Boxes{boxAt({1, 2, 3}, {1, 1, 1})}), {});
    EXPECT_EQ(texels.back().w, -1);
}

// ---- What a ray finds

/// Whether the line meets the closed box, as exactly as long double has it.
bool meetsExactly(const Bounds& box, const Ray& ray) {
    long double enter = 0, leave = std::numeric_limits<long double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const long double low = (long double)(box.low[i]) - (long double)(ray.origin[i]);
        const long double high = (long double)(box.high[i]) - (long double)(ray.origin[i]);
        const long double d = ray.direction[i];
        if (d == 0 && (low > 0 || high < 0)) return false;
        if (d == 0) continue;
        enter = std::max(enter, std::min(low / d, high / d));
        leave = std::min(leave, std::max(low / d, high / d));
    }
    return enter <= leave;
}

/// Some point of the box, often of a face, an edge or a corner of it.
glm::dvec3 placeIn(Dice& dice, const Bounds& box) {
    const auto fraction = [&] { return std::clamp(dice.number(-0.3, 1.3), 0.0, 1.0); };
    return glm::mix(glm::dvec3(box.low), glm::dvec3(box.high), glm::dvec3(fraction(), fraction(), fraction()));
}

/// Long enough for a ray to aim: a point has no size of its own but what float32 resolves there.
double sizeOf(const Bounds& box) {
    return std::max<double>(glm::length(box.high - box.low), 1e-5 * glm::length(box.high) + 1e-6);
}

/// Towards a place of a box, from up to `sizes` times the size of the whole away: in any direction, or in the plane
/// across an axis or along one, so that the origin lies in the planes of faces as well.
Ray rayTowards(Dice& dice, const Bounds& box, double size, double sizes) {
    const glm::vec3 to(placeIn(dice, box));
    glm::dvec3 way = dice.point(1);
    const int zeros = int(dice.number(0, 4)) % 3, axis = int(dice.number(0, 3));
    for (int i = 1; i <= zeros; ++i) way[(axis + i) % 3] = dice.number(0, 1) < 0.5 ? 0.0 : -0.0;
    way = glm::normalize(way) * size * sizes;
    return {glm::vec3(glm::dvec3(to) - way), glm::normalize(glm::vec3(way))};
}

class WalkOfTexels : public testing::TestWithParam<std::string> {
  protected:
    const Boxes& boxes = sets().at(GetParam());
    const Hierarchy hierarchy = build(boxes);
    const std::vector<glm::vec4> texels = texelsOf(hierarchy, eyes()[2]);
};

// Every leaf whose box the ray meets is come to; from near, from far, along faces.
TEST_P(WalkOfTexels, ComesToEveryBoxThatTheRayMeets) {
    const double size = sizeOf(whole(boxes));
    Dice dice(5);
    const int rays = sampled(std::min(4000.0, 4e6 / double(boxes.size())));
    double met = 0, asked = 0;
    for (const double sizes : {0.5, 3.0, 100.0, 1e4, 1e5, 1e6})
        for (int i = 0; i < rays; ++i) {
            const Bounds& aim = boxes[std::size_t(dice.number(0, double(boxes.size())))];
            const Ray ray = rayTowards(dice, aim, size, sizes);
            std::vector<bool> come(boxes.size());
            const auto visits =
                walkTexels(texels, ray, double(kNothing), [&](int leaf) { come[std::size_t(leaf)] = true; });
            asked += visits.primitives;
            for (std::size_t box = 0; box < boxes.size(); ++box)
                if (meetsExactly(boxes[box], ray)) {
                    ++met;
                    ASSERT_TRUE(come[box]) << "box " << box << " from " << sizes << " sizes away, ray " << i;
                }
        }
    EXPECT_GT(met, 0.1 * 6 * rays);
    std::printf("%-18s %6d rays, a ray: %.2f boxes met, %.2f come to\n", GetParam().c_str(), 6 * rays, met / 6 / rays,
                asked / 6 / rays);
}

INSTANTIATE_TEST_SUITE_P(Sets, WalkOfTexels, testing::ValuesIn(namesOfSets()), testName);

// From near, few boxes are come to that the ray does not meet, however flat the whole is. Of a point the ray is as near
// as float32 aims; where most lie in one cell, the grid tells them apart no more.
TEST_P(WalkOfTexels, ComesToFewOthers) {
    const double size = sizeOf(whole(boxes));
    Dice dice(14);
    double met = 0, asked = 0;
    constexpr int kRays = 1000;
    for (int i = 0; i < kRays; ++i) {
        const Ray ray = rayTowards(dice, boxes[std::size_t(dice.number(0, double(boxes.size())))], size, 2);
        asked += walkTexels(texels, ray, double(kNothing), [](int) {}).primitives;
        for (const Bounds& box : boxes) met += meetsExactly(box, ray);
    }
    std::printf("%-18s a ray: %.2f boxes met, %.2f come to\n", GetParam().c_str(), met / kRays, asked / kRays);
    if (GetParam() != "growing") {
        EXPECT_LE(asked, 5 * met + kRays);
    }
}

class WalkAmongSpheres : public testing::TestWithParam<std::string> {
  protected:
    /// The nearest of the exact spheres, by walking and by asking all.
    void check(double from, double to, glm::dvec3 middle = glm::dvec3(0)) {
        const Hierarchy hierarchy = build(boundsOfAll(balls));
        const auto texels = texelsOf(hierarchy, middle + glm::dvec3(5, 1, 2));
        Dice dice(6);
        Visits visits;
        const int rays = sampled(std::min(20000.0, 1e7 / double(balls.size())));
        int hits = 0;
        for (int i = 0; i < rays; ++i) {
            const Ray ray = rayAmong(dice, balls, from * std::pow(to / from, dice.number(0, 1)), middle);
            const Nearest wanted = asked(balls, ray);
            hits += wanted.primitive >= 0;
            ASSERT_EQ(walked(texels, balls, ray, visits).primitive, wanted.primitive) << "ray " << i;
        }
        EXPECT_GT(hits, rays / 100);
    }
    Spheres balls = clouds().at(GetParam());
};

TEST_P(WalkAmongSpheres, LosesNoHitFromFarAway) { check(1e4, 1e6); }

TEST_P(WalkAmongSpheres, LosesNoHitWhereAllIsFarFromTheOrigin) {
    for (const double far : {1e3, 1e5}) {
        const glm::dvec3 by(far, -far, far);
        balls.clear();
        for (const Shape& ball : clouds().at(GetParam()))
            balls.push_back(sphere(by + pointOf(ball, "center"), lengthOf(ball, "radius")));
        check(0.5, 64, by);
    }
}

TEST_P(WalkAmongSpheres, LosesNoHitWhereAllIsHuge) {
    for (Shape& ball : balls) ball = sphere(1e6 * pointOf(ball, "center"), 1e6 * lengthOf(ball, "radius"));
    check(0.5, 1e9);
}

std::vector<std::string> namesOfClouds() {
    std::vector<std::string> names;
    for (const auto& [name, balls] : clouds()) names.push_back(name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Clouds, WalkAmongSpheres, testing::ValuesIn(namesOfClouds()), testName);

} // namespace
} // namespace gnomon
