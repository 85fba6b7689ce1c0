// The hierarchy as a tree, as what a ray walks, and what both cost. The walks read texels and test boxes as a shader
// does.
#include "tracer/accel/hierarchy.h"

#include "tests/oracle/exact_hit.h"
#include "tests/oracle/scene_hit.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <random>

namespace gnomon {
namespace {

constexpr float kNothing = 3e38f;

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}
    double number(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
    glm::dvec3 point(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }

  private:
    std::mt19937_64 random_;
};

// ---- Sets of spheres

using Spheres = std::vector<Shape>;

Shape sphere(glm::dvec3 center, double radius) {
    return {ShapeKind::Sphere, {glm::dvec4(glm::vec3(center), float(radius)), glm::dvec4(0), glm::dvec4(0)}};
}

/// In a cube of half side 1. `cover` is how many of them a line through the middle meets, whatever their number.
Spheres inACube(int count, double cover, std::uint64_t seed = 1) {
    Dice dice(seed);
    const double radius = std::sqrt(cover * 4 / (3.14159265 * count));
    Spheres all;
    for (int i = 0; i < count; ++i) all.push_back(sphere(dice.point(1), radius));
    return all;
}

/// On the ground about the origin.
Spheres onTheGround(int count) {
    Dice dice(2);
    Spheres all;
    for (int i = 0; i < count; ++i)
        all.push_back(sphere({dice.number(-1, 1), 0, dice.number(-1, 1)}, 0.4 / std::sqrt(count)));
    return all;
}

Spheres clustered(int count) {
    Dice dice(3);
    Spheres all;
    glm::dvec3 middle(0);
    for (int i = 0; i < count; ++i) {
        if (i % 40 == 0) middle = dice.point(1);
        all.push_back(sphere(middle + dice.point(0.02), 0.004 * std::exp2(dice.number(-3, 1))));
    }
    return all;
}

Spheres regular(int side) {
    Spheres all;
    for (int i = 0; i < side * side * side; ++i)
        all.push_back(sphere(glm::dvec3(i % side, i / side % side, i / side / side) * (2.0 / side) - 1.0, 0.6 / side));
    return all;
}

Spheres allEqual(int count) { return Spheres(std::size_t(count), sphere({0.25, -0.5, 0.125}, 0.5)); }

Spheres inALine(int count) {
    Spheres all;
    for (int i = 0; i < count; ++i) all.push_back(sphere({2.0 * i / count - 1, 0, 0}, 0.9 / count));
    return all;
}

/// Each a thousandth farther out and larger than the last: the middles crowd at one end.
Spheres growing(int count) {
    Spheres all;
    for (int i = 0; i < count; ++i) {
        const double place = std::pow(1e-6, double(i) / count);
        all.push_back(sphere({place, -place, 0.5 * place}, 0.1 * place));
    }
    return all;
}

const std::map<std::string, Spheres>& sets() {
    static const std::map<std::string, Spheres> all{
        {"1", inACube(1, 0.2)},        {"2", inACube(2, 0.2)},           {"3", inACube(3, 0.5)},
        {"9", inACube(9, 1)},          {"random", inACube(300, 1)},      {"random 10000", inACube(10000, 1)},
        {"ground", onTheGround(2000)}, {"clustered", clustered(2000)},   {"regular", regular(9)},
        {"equal", allEqual(100)},      {"equal 10000", allEqual(10000)}, {"line", inALine(1000)},
        {"growing", growing(500)}};
    return all;
}

std::vector<Bounds> boundsOfAll(const std::vector<Shape>& shapes) {
    std::vector<Bounds> bounds;
    for (const Shape& shape : shapes) bounds.push_back(*boundsOf(shape));
    return bounds;
}

// ---- Walks

struct Ray {
    glm::vec3 origin, direction;
};

/// From a distance, or from among them, towards some place among them or past one of them.
Ray rayAmong(Dice& dice, const Spheres& balls) {
    const glm::dvec3 from = dice.point(1) * std::exp2(dice.number(-1, 6));
    const glm::dvec4 ball = balls[std::size_t(dice.number(0, double(balls.size())))].texels[0];
    const glm::dvec3 to = dice.number(0, 1) < 0.5 ? dice.point(1) : glm::dvec3(ball) + dice.point(ball.w);
    glm::dvec3 way = to - from;
    if (dice.number(0, 1) < 0.1) way[int(dice.number(0, 3))] = 0; // along a box's faces
    return {from, glm::normalize(way)};
}

/// In double: to float32 rays and spheres as good as exact. Negative: no hit.
double distanceTo(const Shape& ball, const Ray& ray) {
    const glm::dvec3 o = glm::dvec3(ray.origin) - glm::dvec3(ball.texels[0]), d(ray.direction);
    const double radius = ball.texels[0].w, a = glm::dot(d, d), middle = -glm::dot(o, d) / a;
    const double gap = glm::length(o + middle * d);
    const double square = (radius - gap) * (radius + gap) / a;
    if (square < 0) return -1;
    const double half = std::sqrt(square);
    return middle - half > 0 ? middle - half : middle + half;
}

/// What a walk has come to. Ties go to the lower number, so that any order of asking finds the same.
struct Nearest {
    double t = kNothing;
    int primitive = -1;

    void offer(int other, double otherT) {
        if (!(otherT > 0) || otherT > t || (otherT == t && other > primitive)) return;
        t = otherT;
        primitive = other;
    }
};

struct Visits {
    double boxes = 0, primitives = 0;
};

using Ask = std::function<void(int primitive)>;

/// A hierarchy as the shader has it.
struct Tree {
    Hierarchy hierarchy;
    std::vector<glm::vec4> texels;

    explicit Tree(std::span<const Bounds> bounds) : hierarchy(build(bounds)) { appendTexels(hierarchy, texels); }
    int nodes() const { return int(texels.size()) / kNodeTexels; }
    glm::vec4 low(int node) const { return texels[std::size_t(kNodeTexels * node)]; }
    glm::vec4 high(int node) const { return texels[std::size_t(kNodeTexels * node + 1)]; }
    int skip(int node) const { return int(low(node).w); }
    int leaf(int node) const { return int(high(node).w); }
};

/// 1 / d without an infinity: 0 times one is no number.
glm::vec3 perUnit(glm::vec3 d) {
    for (int i = 0; i < 3; ++i) d[i] = 1 / (std::abs(d[i]) < 1e-18f ? std::copysign(1e-18f, d[i]) : d[i]);
    return d;
}

/// Where the ray enters the box, kNothing where it does not before `t`. All in float32.
float entryOf(const Tree& tree, int node, const Ray& ray, glm::vec3 per, double t) {
    constexpr float kRounding = 0x1p-21f;
    const glm::vec3 a = (glm::vec3(tree.low(node)) - ray.origin) * per,
                    b = (glm::vec3(tree.high(node)) - ray.origin) * per;
    const glm::vec3 enter = glm::min(a, b), leave = glm::max(a, b);
    const float entry = std::max({enter.x, enter.y, enter.z, 0.0f}) * (1 - kRounding);
    const float exit = std::min({leave.x, leave.y, leave.z}) * (1 + kRounding);
    return entry <= exit && entry <= t ? entry : kNothing;
}

void askLeaf(const Tree& tree, int node, Visits& visits, const Ask& ask) {
    const int leaf = tree.leaf(node), first = leaf / kMaxLeaf, count = leaf % kMaxLeaf + 1;
    for (int i = first; i < first + count; ++i) ask(tree.hierarchy.order[std::size_t(i)]);
    visits.primitives += count;
}

/// Along the skips. `t` is what ask() may lower.
Visits walkThreaded(const Tree& tree, const Ray& ray, const double& t, const Ask& ask) {
    const glm::vec3 per = perUnit(ray.direction);
    Visits visits;
    for (int node = 0; node < tree.nodes();) {
        ++visits.boxes;
        const bool met = entryOf(tree, node, ray, per, t) < kNothing, inner = tree.leaf(node) < 0;
        if (met && !inner) askLeaf(tree, node, visits, ask);
        node = met && inner ? node + 1 : tree.skip(node);
    }
    return visits;
}

/// With a stack, the nearer child first.
Visits walkOrdered(const Tree& tree, const Ray& ray, const double& t, const Ask& ask) {
    const glm::vec3 per = perUnit(ray.direction);
    Visits visits{1, 0};
    struct Entry {
        int node;
        float at;
    };
    std::vector<Entry> stack;
    const auto push = [&](Entry entry) {
        if (entry.at < kNothing) stack.push_back(entry);
    };
    if (tree.nodes() > 0) push({0, entryOf(tree, 0, ray, per, t)});
    while (!stack.empty()) {
        const Entry here = stack.back();
        stack.pop_back();
        if (here.at > t) continue;
        if (tree.leaf(here.node) >= 0) {
            askLeaf(tree, here.node, visits, ask);
            continue;
        }
        Entry a{here.node + 1, 0}, b{tree.skip(here.node + 1), 0};
        a.at = entryOf(tree, a.node, ray, per, t);
        b.at = entryOf(tree, b.node, ray, per, t);
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

Nearest asked(const Spheres& balls, const Ray& ray) {
    Nearest nearest;
    for (std::size_t i = 0; i < balls.size(); ++i) nearest.offer(int(i), distanceTo(balls[i], ray));
    return nearest;
}

// ---- The tree

bool inside(const Bounds& inner, const Bounds& outer) { return merged(inner, outer) == outer; }

/// The node after `node` and all below it, by going there.
int afterAllBelow(const Hierarchy& h, int node) {
    for (int open = 1; open > 0; ++node) open += h.nodes[std::size_t(node)].count > 0 ? -1 : 1;
    return node;
}

class HierarchyOf : public testing::TestWithParam<std::string> {
  protected:
    const Spheres& balls = sets().at(GetParam());
    const std::vector<Bounds> bounds = boundsOfAll(balls);
    const Hierarchy hierarchy = build(bounds);
};

TEST_P(HierarchyOf, HoldsEachPrimitiveOnce) {
    std::vector<int> seen(balls.size());
    int next = 0;
    for (const HierarchyNode& node : hierarchy.nodes) {
        EXPECT_LE(node.count, kMaxLeaf);
        if (node.count > 0) {
            EXPECT_EQ(node.first, next) << "leaves in the order of their nodes";
        }
        next += node.count;
        for (int i = node.first; i < node.first + node.count; ++i) {
            const std::size_t primitive = std::size_t(hierarchy.order[std::size_t(i)]);
            ++seen[primitive];
            EXPECT_TRUE(inside(bounds[primitive], node.bounds));
        }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(balls.size()));
}

TEST_P(HierarchyOf, HasChildrenInsideOfParentsAndSkipsPastAllBelow) {
    const auto& nodes = hierarchy.nodes;
    ASSERT_EQ(nodes[0].skip, int(nodes.size()));
    for (int i = 0; i < int(nodes.size()); ++i) {
        const HierarchyNode& node = nodes[std::size_t(i)];
        ASSERT_EQ(node.skip, afterAllBelow(hierarchy, i));
        if (node.count > 0) continue;
        const HierarchyNode &first = nodes[std::size_t(i + 1)], &second = nodes[std::size_t(first.skip)];
        ASSERT_EQ(second.skip, node.skip);
        ASSERT_EQ(merged(first.bounds, second.bounds), node.bounds);
    }
}

TEST_P(HierarchyOf, IsTheSameEachTime) {
    const Hierarchy again = build(bounds);
    EXPECT_EQ(again.order, hierarchy.order);
    EXPECT_EQ(again.nodes.size(), hierarchy.nodes.size());
    EXPECT_EQ(again.cost(), hierarchy.cost());
    EXPECT_EQ(hierarchy.spoilt(), 1);
}

// The float32 box tests lose no hit of the exact spheres.
TEST_P(HierarchyOf, FindsWhatAskingAllFinds) {
    const Tree tree(bounds);
    Dice dice(7);
    const int rays = int(std::min(20000.0, 3e7 / double(balls.size())));
    int hits = 0;
    Visits threaded, ordered;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = rayAmong(dice, balls);
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
    for (Shape& ball : moved) ball = sphere(glm::dvec3(ball.texels[0]) + dice.point(0.3), 0.1 + ball.texels[0].w);
    const std::vector<Bounds> now = boundsOfAll(moved);
    Hierarchy refitted = hierarchy;
    refit(refitted, now);
    for (int i = 0; i < int(refitted.nodes.size()); ++i) {
        Bounds box; // of all leaves below, without the nodes between
        for (int k = i; k < refitted.nodes[std::size_t(i)].skip; ++k) {
            const HierarchyNode& leaf = refitted.nodes[std::size_t(k)];
            for (int p = leaf.first; p < leaf.first + leaf.count; ++p)
                box = merged(box, now[std::size_t(refitted.order[std::size_t(p)])]);
        }
        ASSERT_EQ(refitted.nodes[std::size_t(i)].bounds, box) << "node " << i;
    }
    refit(refitted, bounds);
    EXPECT_EQ(refitted.cost(), hierarchy.cost()) << "back where it was";
}

std::vector<std::string> namesOfSets() {
    std::vector<std::string> names;
    for (const auto& [name, balls] : sets()) names.push_back(name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Sets, HierarchyOf, testing::ValuesIn(namesOfSets()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

TEST(Hierarchy, OfNothingHasNoNode) {
    const Hierarchy none = build({});
    EXPECT_TRUE(none.nodes.empty() && none.order.empty());
    EXPECT_EQ(none.cost(), 0);
    EXPECT_EQ(none.spoilt(), 1);
}

TEST(Hierarchy, ManagesBoxesWithoutArea) {
    const std::vector<Bounds> points(1000, Bounds{{1, 2, 3}, {1, 2, 3}});
    std::vector<Bounds> line;
    for (int i = 0; i < 1000; ++i) line.push_back({{float(i), 0, 0}, {float(i + 1), 0, 0}});
    for (const auto& bounds : {points, line}) {
        const Hierarchy h = build(bounds);
        EXPECT_EQ(afterAllBelow(h, 0), int(h.nodes.size()));
        EXPECT_TRUE(std::isfinite(h.cost()));
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
    const double asLeaf = 2.0 * double(count) * halfArea(whole);
    if (count == 1) return asLeaf;
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
    if (int(count) <= kMaxLeaf && asLeaf <= 2 * halfArea(whole) + 2 * best) return asLeaf;
    return 2 * halfArea(whole) + sweptCost(std::move(left)) + sweptCost(std::move(right));
}

TEST(Hierarchy, IsAsGoodAsTryingEverySplit) {
    for (const char* name : {"1", "2", "3", "9", "random", "ground", "clustered", "regular", "growing"}) {
        const std::vector<Bounds> bounds = boundsOfAll(sets().at(name));
        const Hierarchy h = build(bounds);
        const double swept = 1 + sweptCost(bounds) / halfArea(h.nodes[0].bounds);
        std::printf("%-10s cost %.2f, every split tried %.2f\n", name, h.cost(), swept);
        EXPECT_LE(h.cost(), 1.05 * swept) << name;
    }
}

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

/// Rays from outside through a set of about the unit cube's size.
Visits visitsThrough(Walk walk, const Spheres& balls, int rays) {
    const Tree tree(boundsOfAll(balls));
    Dice dice(10);
    Visits sum;
    for (int i = 0; i < rays; ++i) {
        const glm::dvec3 from = 4.0 * glm::normalize(dice.point(1) + glm::dvec3(0, 1e-3, 0));
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
         {growth("cube, threaded", sparse, walkThreaded), growth("cube, nearer first", sparse, walkOrdered),
          growth("crowded cube, threaded", dense, walkThreaded)})
        for (std::size_t i = 2; i < boxes.size(); ++i) EXPECT_LE(boxes[i], 2.5 * boxes[i - 1]);
    const auto boxes = growth("crowded cube, nearer first", dense, walkOrdered);
    for (std::size_t i = 1; i < boxes.size(); ++i) EXPECT_LE(boxes[i], boxes[i - 1] + 30);
}

/// Milliseconds of this thread's own time, the median of many.
double medianTime(int times, const std::function<void()>& work) {
    const auto now = [] {
        timespec t;
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return 1e3 * double(t.tv_sec) + 1e-6 * double(t.tv_nsec);
    };
    std::vector<double> took;
    for (int i = 0; i < times; ++i) {
        const double start = now();
        work();
        took.push_back(now() - start);
    }
    std::nth_element(took.begin(), took.begin() + times / 2, took.end());
    return took[std::size_t(times / 2)];
}

TEST(Hierarchy, IsRefittedTo10000MovingSpheresIn4Milliseconds) {
    Spheres balls = inACube(10000, 1);
    std::vector<Bounds> bounds = boundsOfAll(balls);
    Hierarchy h = build(bounds);
    std::vector<glm::vec4> texels;
    double step = 1e-4;
    const double boxing = medianTime(101, [&] {
        step = -step;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            balls[i].texels[0].x += step;
            bounds[i] = *boundsOf(balls[i]);
        }
    });
    const double refitting = medianTime(101, [&] { refit(h, bounds); });
    const double judging = medianTime(101, [&] { EXPECT_LT(h.spoilt(), 1.5); });
    const double writing = medianTime(101, [&] {
        texels.clear();
        appendTexels(h, texels);
    });
    const double building = medianTime(11, [&] { h = build(bounds); });
    std::printf("10 000 spheres, %zu nodes, ms: boxes %.2f, refit %.2f, cost %.2f, texels %.2f; build %.1f\n",
                h.nodes.size(), boxing, refitting, judging, writing, building);
#ifndef __SANITIZE_ADDRESS__
    EXPECT_LE(boxing + refitting + judging + writing, 4);
#endif
}

// ---- The scene `pro`

/// A set of objects of a scene, asked one after the other or through a hierarchy of their own.
struct Group {
    std::vector<int> objects;
    std::optional<Tree> tree;
};

struct Picture {
    std::vector<Shape> shapes;
    std::vector<oracle::Body<double>> bodies;
    std::vector<Ray> rays;
};

Picture pictureOf(const Scene& scene, int width, int height) {
    Picture picture{shapesAt(scene, 0), {}, {}};
    for (const Shape& shape : picture.shapes) picture.bodies.emplace_back(shape);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            oracle::Vec origin, direction;
            oracle::pixelRay(scene.camera, x, y, width, height, origin, direction);
            picture.rays.push_back({glm::vec3(origin), glm::vec3(direction)});
        }
    return picture;
}

double distanceTo(const oracle::Body<double>& body, const Ray& ray) {
    const auto hit = exactHit(body, lineOf(body, ray.origin, ray.direction));
    return hit.hit ? double(hit.t) : -1;
}

Group withTree(const Picture& picture, std::vector<int> objects) {
    std::vector<Bounds> bounds;
    for (const int i : objects) bounds.push_back(*boundsOf(picture.shapes[std::size_t(i)]));
    return {std::move(objects), Tree(bounds)};
}

/// All groups, one after the other.
Nearest through(const std::vector<Group>& groups, const Picture& picture, const Ray& ray, Walk walk, Visits& sum) {
    Nearest nearest;
    for (const Group& group : groups) {
        const Ask ask = [&](int i) {
            const int object = group.objects[std::size_t(i)];
            nearest.offer(object, distanceTo(picture.bodies[std::size_t(object)], ray));
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
