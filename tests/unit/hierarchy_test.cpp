// The hierarchy as a tree, what a ray's walk through it finds, and what both cost. The walks read texels as the shader
// does; where the nearer child of each ray comes first they read the tree, to see what a walk could save at most.
#include "tracer/accel/hierarchy.h"

#include "lab/reference/exact/exact_hit.h"
#include "lab/reference/exact/scene_hit.h"
#include "tests/support/scenes.h"
#include "tests/support/texel_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>

namespace gnomon {
namespace {

using namespace test;

// ---- Walks

using Ask = std::function<void(int primitive)>;

/// A hierarchy with its texels as a picture from `eye` has them.
struct Tree {
    Hierarchy hierarchy;
    std::vector<glm::vec4> texels;

    Tree(std::span<const Bounds> bounds, glm::vec3 eye) : hierarchy(build(bounds)), texels(texelsOf(hierarchy, eye)) {}
};

/// Where the line, told by its origin and 1 / direction, enters the box; kNothing where it does not before `t`.
double entryOf(const Bounds& box, glm::dvec3 origin, glm::dvec3 per, double t) {
    const glm::dvec3 a = (glm::dvec3(box.low) - origin) * per, b = (glm::dvec3(box.high) - origin) * per;
    const glm::dvec3 enter = glm::min(a, b), leave = glm::max(a, b);
    const double entry = std::max({enter.x, enter.y, enter.z, 0.0}), exit = std::min({leave.x, leave.y, leave.z, t});
    return entry <= exit ? entry : kNothing;
}

/// 1 / d without an infinity: 0 times one is no number.
glm::dvec3 perUnit(glm::dvec3 d) {
    for (int i = 0; i < 3; ++i) d[i] = 1 / (std::abs(d[i]) < 1e-30 ? std::copysign(1e-30, d[i]) : d[i]);
    return d;
}

/// Along the links, in the order that the texels have for all rays.
Visits walkThreaded(const Tree& tree, const Ray& ray, const double& t, const Ask& ask) {
    return walkTexels(tree.texels, ray, t, ask);
}

/// With a stack, the child that the ray enters first before the other. In double.
Visits walkOrdered(const Tree& tree, const Ray& ray, const double& t, const Ask& ask) {
    const auto& nodes = tree.hierarchy.nodes;
    const glm::dvec3 per = perUnit(ray.direction);
    Visits visits{1, 0};
    struct Entry {
        int node;
        double at;
    };
    std::vector<Entry> stack;
    const auto entryTo = [&](int node) {
        return Entry{node, entryOf(nodes[std::size_t(node)].bounds, ray.origin, per, t)};
    };
    const auto push = [&](Entry entry) {
        if (entry.at < kNothing) stack.push_back(entry);
    };
    if (!nodes.empty()) push(entryTo(0));
    while (!stack.empty()) {
        const Entry here = stack.back();
        stack.pop_back();
        if (here.at > t) continue;
        if (const HierarchyNode& node = nodes[std::size_t(here.node)]; node.isLeaf()) {
            ++visits.primitives;
            ask(node.primitive);
            continue;
        }
        Entry a = entryTo(here.node + 1), b = entryTo(nodes[std::size_t(here.node + 1)].skip);
        visits.boxes += 2;
        if (a.at < b.at) std::swap(a, b);
        push(a);
        push(b);
    }
    return visits;
}

using Walk = Visits (*)(const Tree&, const Ray&, const double&, const Ask&);

Nearest walked(Walk walk, const Tree& tree, const Spheres& balls, const Ray& ray, Visits& sum) {
    Nearest nearest;
    const Visits visits =
        walk(tree, ray, nearest.t, [&](int i) { nearest.offer(i, distanceTo(balls[std::size_t(i)], ray)); });
    sum.boxes += visits.boxes;
    sum.primitives += visits.primitives;
    return nearest;
}

// ---- The tree

/// The node after `node` and all below it, by going there.
int afterAllBelow(const Hierarchy& h, int node) {
    for (int open = 1; open > 0; ++node) open += h.nodes[std::size_t(node)].isLeaf() ? -1 : 1;
    return node;
}

bool sameNodes(const Hierarchy& a, const Hierarchy& b) {
    return std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
                      [](const HierarchyNode& x, const HierarchyNode& y) {
                          return x.bounds == y.bounds && x.skip == y.skip && x.primitive == y.primitive;
                      });
}

bool sameLinks(const Hierarchy& a, const Hierarchy& b) {
    return std::equal(
        a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
        [](const HierarchyNode& x, const HierarchyNode& y) { return x.skip == y.skip && x.primitive == y.primitive; });
}

class HierarchyOf : public testing::TestWithParam<std::string> {
  protected:
    const Spheres& balls = clouds().at(GetParam());
    const std::vector<Bounds> bounds = boundsOfAll(balls);
    const Hierarchy hierarchy = build(bounds);
};

TEST_P(HierarchyOf, HoldsEachPrimitiveOnceInALeafOfItsBox) {
    std::vector<int> seen(balls.size());
    for (const HierarchyNode& node : hierarchy.nodes)
        if (node.isLeaf()) {
            ++seen.at(std::size_t(node.primitive));
            EXPECT_EQ(node.bounds, bounds[std::size_t(node.primitive)]);
        }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(balls.size()));
    EXPECT_EQ(int(hierarchy.nodes.size()), nodesFor(int(balls.size())));
}

TEST_P(HierarchyOf, HasChildrenInsideOfParentsAndSkipsPastAllBelow) {
    const auto& nodes = hierarchy.nodes;
    ASSERT_EQ(nodes[0].skip, int(nodes.size()));
    for (int i = 0; i < int(nodes.size()); ++i) {
        const HierarchyNode& node = nodes[std::size_t(i)];
        ASSERT_EQ(node.skip, afterAllBelow(hierarchy, i));
        if (node.isLeaf()) continue;
        const HierarchyNode &first = nodes[std::size_t(i + 1)], &second = nodes[std::size_t(first.skip)];
        ASSERT_EQ(second.skip, node.skip);
        ASSERT_EQ(merged(first.bounds, second.bounds), node.bounds);
    }
}

TEST_P(HierarchyOf, IsTheSameEachTime) {
    const Hierarchy again = build(bounds);
    EXPECT_TRUE(sameNodes(again, hierarchy));
    EXPECT_EQ(again.cost(), hierarchy.cost());
    EXPECT_EQ(hierarchy.spoilt(), 1);
}

TEST_P(HierarchyOf, FindsWhatAskingAllFinds) {
    const Tree tree(bounds, {0, 1, 5});
    Dice dice(7);
    const int rays = sampled(std::min(20000.0, 3e7 / double(balls.size())));
    int hits = 0;
    Visits threaded, ordered;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = rayAmong(dice, balls, std::exp2(dice.number(-1, 6)));
        const Nearest wanted = asked(balls, ray);
        hits += wanted.primitive >= 0;
        ASSERT_EQ(walked(walkThreaded, tree, balls, ray, threaded).primitive, wanted.primitive) << "ray " << i;
        ASSERT_EQ(walked(walkOrdered, tree, balls, ray, ordered).primitive, wanted.primitive) << "ray " << i;
    }
    EXPECT_GT(hits, rays / 10);
    std::printf(
        "%-12s of %5zu: %5d rays, %5d hit; boxes and spheres a ray: %.1f %.1f threaded, %.1f %.1f nearer first\n",
        GetParam().c_str(), balls.size(), rays, hits, threaded.boxes / rays, threaded.primitives / rays,
        ordered.boxes / rays, ordered.primitives / rays);
}

TEST_P(HierarchyOf, RefitsToWhatItsLeavesHold) {
    Dice dice(8);
    Spheres moved = balls;
    for (Shape& ball : moved) ball = sphere(pointOf(ball, "center") + dice.point(0.3), 0.1 + lengthOf(ball, "radius"));
    const std::vector<Bounds> now = boundsOfAll(moved);
    Hierarchy refitted = hierarchy;
    refit(refitted, now);
    for (int i = 0; i < int(refitted.nodes.size()); ++i) {
        Bounds box; // of all leaves below, without the nodes between
        for (int k = i; k < refitted.nodes[std::size_t(i)].skip; ++k) {
            const HierarchyNode& below = refitted.nodes[std::size_t(k)];
            if (below.isLeaf()) box = merged(box, now[std::size_t(below.primitive)]);
        }
        ASSERT_EQ(refitted.nodes[std::size_t(i)].bounds, box) << "node " << i;
    }
    refit(refitted, bounds);
    EXPECT_TRUE(sameNodes(refitted, hierarchy)) << "back where it was";
}

TEST(Hierarchy, OfNothingHasNoNode) {
    const Hierarchy none = build({});
    EXPECT_TRUE(none.nodes.empty());
    EXPECT_EQ(none.cost(), 0);
    EXPECT_EQ(none.primitivesAsked(), 0);
    EXPECT_EQ(none.spoilt(), 1);
}

TEST(Hierarchy, ManagesBoxesWithoutArea) {
    const std::vector<Bounds> points(1000, Bounds{{1, 2, 3}, {1, 2, 3}});
    std::vector<Bounds> line;
    for (int i = 0; i < 1000; ++i) line.push_back({{float(i), 0, 0}, {float(i + 1), 0, 0}});
    for (const auto& bounds : {points, line}) {
        const Hierarchy h = build(bounds);
        EXPECT_EQ(afterAllBelow(h, 0), int(h.nodes.size()));
        EXPECT_TRUE(std::isfinite(h.cost()) && std::isfinite(h.primitivesAsked()) && std::isfinite(h.spoilt()));
    }
}

// 10 000 at one place are halved, not peeled off one by one.
TEST(Hierarchy, IsShallowWhereAllLieAtOnePlace) {
    const Hierarchy h = build(boundsOfAll(allEqual(10000)));
    int deepest = 0;
    std::vector<int> ends;
    for (int i = 0; i < int(h.nodes.size()); ++i) {
        while (!ends.empty() && ends.back() <= i) ends.pop_back();
        ends.push_back(h.nodes[std::size_t(i)].skip);
        deepest = std::max(deepest, int(ends.size()));
    }
    EXPECT_LE(deepest, 15);
}

// ---- Its cost

/// Of the tree that tries every split everywhere, times the area. The boxes are cut in place.
double sweptCost(std::vector<Bounds> boxes) {
    Bounds whole;
    for (const Bounds& box : boxes) whole = merged(whole, box);
    const std::size_t count = boxes.size();
    if (count == 1) return 0;
    double best = 1e300;
    std::vector<Bounds> left, right;
    for (int axis = 0; axis < 3; ++axis) {
        std::stable_sort(boxes.begin(), boxes.end(), [&](const Bounds& a, const Bounds& b) {
            return a.low[axis] + a.high[axis] < b.low[axis] + b.high[axis];
        });
        std::vector<double> after(count);
        Bounds box;
        for (std::size_t i = count; i-- > 1;) after[i] = halfArea(box = merged(box, boxes[i])) * double(count - i);
        box = {};
        for (std::size_t i = 1; i < count; ++i) {
            const double cost = halfArea(box = merged(box, boxes[i - 1])) * double(i) + after[i];
            if (cost >= best) continue;
            best = cost;
            left.assign(boxes.begin(), boxes.begin() + std::ptrdiff_t(i));
            right.assign(boxes.begin() + std::ptrdiff_t(i), boxes.end());
        }
    }
    return 2 * halfArea(whole) + sweptCost(std::move(left)) + sweptCost(std::move(right));
}

TEST(Hierarchy, IsAsGoodAsTryingEverySplit) {
    for (const char* name : {"1", "2", "3", "9", "random", "ground", "clustered", "regular", "growing"}) {
        const std::vector<Bounds> bounds = boundsOfAll(clouds().at(name));
        const Hierarchy h = build(bounds);
        const double swept = 1 + sweptCost(bounds) / halfArea(h.nodes[0].bounds);
        std::printf("%-10s cost %.2f, every split tried %.2f\n", name, h.cost(), swept);
        EXPECT_LE(h.cost(), 1.05 * swept) << name;
    }
}

/// A line that is as likely as any other that meets the box, from outside of it.
Ray lineThrough(Dice& dice, const Bounds& box) {
    const glm::dvec3 middle = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high));
    const double reach = 0.5 * glm::distance(glm::dvec3(box.low), glm::dvec3(box.high));
    const auto inBall = [&] {
        for (;;)
            if (const glm::dvec3 p = dice.point(1); glm::dot(p, p) <= 1) return p;
    };
    for (;;) {
        const glm::dvec3 direction = glm::normalize(inBall()),
                         inPlane = glm::normalize(glm::cross(direction, inBall()));
        const glm::dvec3 from = middle + reach * (std::sqrt(dice.number(0, 1)) * inPlane - 2.0 * direction);
        if (entryOf(box, from, perUnit(direction), kNothing) < kNothing) return {from, direction};
    }
}

/// A mean, and how far it may be from what it estimates.
struct Samples {
    double count = 0, sum = 0, squares = 0;
    void add(double value) { ++count, sum += value, squares += value * value; }
    double mean() const { return sum / count; }
    double standardError() const { return std::sqrt(std::max(0.0, squares / count - mean() * mean()) / count); }
};

// What cost() and primitivesAsked() foretell is what lines that meet the root's box and stop at nothing count. 2 % is
// four standard errors of these counts; where all lines count nearly the same, few lines give them.
TEST_P(HierarchyOf, CostsWhatRandomLinesCount) {
    const Tree tree(bounds, {0, 0, 0});
    Dice dice(12);
    Samples boxes, primitives;
    const auto precise = [](const Samples& samples) { return samples.standardError() <= 0.005 * samples.mean(); };
    for (int i = 0; i < 40000 && (i < 1000 || !precise(boxes) || !precise(primitives)); ++i) {
        const Visits visits =
            walkOrdered(tree, lineThrough(dice, hierarchy.nodes[0].bounds), double(kNothing), [](int) {});
        boxes.add(visits.boxes);
        primitives.add(visits.primitives);
    }
    EXPECT_NEAR(boxes.mean(), hierarchy.cost(), 0.02 * hierarchy.cost());
    EXPECT_NEAR(primitives.mean(), hierarchy.primitivesAsked(), 0.02 * hierarchy.primitivesAsked());
}

std::vector<std::string> namesOfSets() {
    std::vector<std::string> names;
    for (const auto& [name, balls] : clouds()) names.push_back(name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Sets, HierarchyOf, testing::ValuesIn(namesOfSets()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

TEST(Hierarchy, SaysWhenMotionHasSpoiltIt) {
    const Spheres balls = inACube(1000, 1);
    Hierarchy h = build(boundsOfAll(balls));
    Dice dice(9);
    Spheres near = balls;
    for (Shape& ball : near) ball = translated(ball, dice.point(0.005));
    refit(h, boundsOfAll(near));
    EXPECT_LT(h.spoilt(), 1.2) << "each by a tenth of its diameter";
    Spheres shuffled = balls;
    std::reverse(shuffled.begin(), shuffled.end());
    refit(h, boundsOfAll(shuffled));
    EXPECT_GT(h.spoilt(), 5) << "each where another was";
}

// What update() leaves is as good as a new tree, and the same one as long as that is nearly as good.
TEST(Hierarchy, IsUpdatedInWhateverWayIsBest) {
    const Spheres balls = inACube(1000, 1);
    const std::vector<Bounds> bounds = boundsOfAll(balls);
    Hierarchy h;
    update(h, bounds);
    EXPECT_TRUE(sameNodes(h, build(bounds))) << "built where there is none";

    Dice dice(9);
    std::vector<Bounds> near;
    for (const Shape& ball : balls) near.push_back(*boundsOf(translated(ball, dice.point(0.005))));
    Hierarchy refitted = h;
    refit(refitted, near);
    update(h, near);
    EXPECT_TRUE(sameNodes(h, refitted)) << "refitted where motion is small";
    EXPECT_FALSE(sameLinks(h, build(near))) << "which a new tree would not be";

    std::vector<Bounds> shuffled = bounds;
    std::reverse(shuffled.begin(), shuffled.end());
    update(h, shuffled);
    EXPECT_TRUE(sameNodes(h, build(shuffled))) << "built anew where motion has spoilt it";
    EXPECT_EQ(h.spoilt(), 1);

    shuffled.resize(17);
    update(h, shuffled);
    EXPECT_TRUE(sameNodes(h, build(shuffled))) << "built anew of another number";
    update(h, {});
    EXPECT_TRUE(h.nodes.empty());
}

/// Rays from outside through a set of about the unit cube's size, a hundred from each of many eyes.
Visits visitsThrough(Walk walk, const Spheres& balls, int rays) {
    constexpr int kRaysAnEye = 100;
    Tree tree(boundsOfAll(balls), {});
    Dice dice(10);
    Visits sum;
    glm::dvec3 from(0);
    for (int i = 0; i < rays; ++i) {
        if (i % kRaysAnEye == 0) {
            from = 4.0 * glm::normalize(dice.point(1) + glm::dvec3(0, 1e-3, 0));
            tree.texels = texelsOf(tree.hierarchy, from);
        }
        walked(walk, tree, balls, {from, glm::normalize(dice.point(0.7) * glm::dvec3(1, 0.1, 1) - from)}, sum);
    }
    return {sum.boxes / rays, sum.primitives / rays};
}

/// Boxes a ray for 10, 100, 1000 and 10 000.
std::array<double, 4> growth(const char* name, const std::function<Spheres(int)>& make, Walk walk) {
    std::array<double, 4> boxes;
    int count = 1;
    for (double& mean : boxes) {
        const Visits visits = visitsThrough(walk, make(count *= 10), 4000);
        mean = visits.boxes;
        std::printf("%-32s %6d: %6.1f boxes, %4.1f spheres a ray\n", name, count, visits.boxes, visits.primitives);
    }
    return boxes;
}

// Spheres that cover as much of the picture however many they are.
TEST(Hierarchy, CostsARayAFewBoxesMoreForTenTimesAsManyOnTheGround) {
    for (const auto& boxes : {growth("ground, threaded", onTheGround, walkThreaded),
                              growth("ground, nearer first", onTheGround, walkOrdered)})
        for (std::size_t i = 1; i < boxes.size(); ++i) EXPECT_LE(boxes[i], boxes[i - 1] + 8);
}

// A line through a cube passes as many cells as the cube has along an edge: 10^(1/3) = 2.15 times for ten times as
// many, but for those behind the first hit.
TEST(Hierarchy, CostsARayItsWayThroughACrowd) {
    const auto sparse = [](int n) { return inACube(n, 0.5); };
    const auto dense = [](int n) { return inACube(n, 5); };
    for (const auto& boxes :
         {growth("cube, threaded", sparse, walkThreaded), growth("cube, nearer first", sparse, walkOrdered)})
        for (std::size_t i = 2; i < boxes.size(); ++i) EXPECT_LE(boxes[i], 2.5 * boxes[i - 1]);
    const auto threaded = growth("crowded cube, threaded", dense, walkThreaded);
    const auto ordered = growth("crowded cube, nearer first", dense, walkOrdered);
    for (std::size_t i = 1; i < threaded.size(); ++i) {
        EXPECT_LE(threaded[i], threaded[i - 1] + 30);
        EXPECT_LE(threaded[i], 1.1 * ordered[i]) << "the eye's order serves its rays as well as each ray's own";
    }
}

// ---- The scene `pro`

/// A set of objects of a scene, asked one after the other or through a hierarchy of their own.
struct Group {
    std::vector<int> objects;
    std::optional<Tree> tree;
};

struct Picture {
    std::vector<Shape> shapes;
    std::vector<oracle::ExactShape<double>> exactShapes;
    std::vector<Ray> rays;
    glm::dvec3 eye;
};

Picture pictureOf(const Scene& scene, int width, int height) {
    Picture picture{shapesAt(scene, 0), {}, {}, scene.camera.eye};
    for (const Shape& shape : picture.shapes) picture.exactShapes.emplace_back(shape);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            oracle::Vec origin, direction;
            oracle::pixelRay(scene.camera, x, y, width, height, origin, direction);
            picture.rays.push_back({glm::vec3(origin), glm::vec3(direction)});
        }
    return picture;
}

double distanceTo(const oracle::ExactShape<double>& shape, const Ray& ray) {
    const auto hit = exactHit(shape, lineOf(shape, ray.origin, ray.direction));
    return hit.hit ? double(hit.t) : -1;
}

Group withTree(const Picture& picture, std::vector<int> objects) {
    std::vector<Bounds> bounds;
    for (const int i : objects) bounds.push_back(*boundsOf(picture.shapes[std::size_t(i)]));
    return {std::move(objects), Tree(bounds, picture.eye)};
}

/// All groups, one after the other.
Nearest through(const std::vector<Group>& groups, const Picture& picture, const Ray& ray, Walk walk, Visits& sum) {
    Nearest nearest;
    for (const Group& group : groups) {
        const Ask ask = [&](int i) {
            const int object = group.objects[std::size_t(i)];
            nearest.offer(object, distanceTo(picture.exactShapes[std::size_t(object)], ray));
        };
        Visits visits{0, double(group.objects.size())};
        if (group.tree)
            visits = walk(*group.tree, ray, nearest.t, ask);
        else
            for (std::size_t i = 0; i < group.objects.size(); ++i) ask(int(i));
        sum.boxes += visits.boxes;
        sum.primitives += visits.primitives;
    }
    return nearest;
}

/// One group, or one for each kind.
std::vector<Group> grouped(const Picture& picture, bool byKind) {
    std::map<int, std::vector<int>> objects;
    for (int i = 0; i < int(picture.shapes.size()); ++i)
        objects[byKind ? int(picture.shapes[std::size_t(i)].kind) : 0].push_back(i);
    std::vector<Group> groups;
    for (auto& [kind, members] : objects) groups.push_back(withTree(picture, members));
    return groups;
}

// Of 126.
TEST(Hierarchy, AsksTwoObjectsOfSceneProAtMostAfter13Boxes) {
    const Picture picture = pictureOf(test::sceneNamed("pro"), 200, 150);
    const double rays = double(picture.rays.size());
    const auto all = grouped(picture, false), kinds = grouped(picture, true);
    std::vector<Group> plain{{all[0].objects, {}}};
    std::vector<int> met;
    Visits none;
    for (const Ray& ray : picture.rays) met.push_back(through(plain, picture, ray, walkThreaded, none).primitive);
    const auto count = [&](const char* name, const std::vector<Group>& groups, Walk walk) {
        Visits sum;
        for (std::size_t i = 0; i < picture.rays.size(); ++i)
            EXPECT_EQ(through(groups, picture, picture.rays[i], walk, sum).primitive, met[i]) << name;
        std::printf("%-30s %6.2f boxes, %6.2f primitives a ray\n", name, sum.boxes / rays, sum.primitives / rays);
        EXPECT_LE(sum.boxes / rays, 13) << name;
        EXPECT_LE(sum.primitives / rays, 2) << name;
    };
    std::printf("%-30s %6.2f boxes, %6.2f primitives a ray\n", "plain loop", 0.0, none.primitives / rays);
    count("one hierarchy, threaded", all, walkThreaded);
    count("one hierarchy, nearer first", all, walkOrdered);
    count("one a kind, threaded", kinds, walkThreaded);
    count("one a kind, nearer first", kinds, walkOrdered);
}

} // namespace
} // namespace gnomon
