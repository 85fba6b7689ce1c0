/// Patches in space: what a net and a BPT file become, and what every bad one is told.
#include "tests/support/scenes.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

#include <string>

namespace gnomon {
namespace {

using namespace test;

std::string problemsOf(const std::string& objects, const std::string& file) {
    Problems problems;
    const auto scene = readScene("{\"objects\": [" + objects + "]}", "f", problems,
                                 [&](const std::string&, Problems&) { return std::optional(file); });
    EXPECT_EQ(scene.has_value(), problems.empty());
    return toString(problems);
}

std::vector<Object> objectsOf(const std::string& objects, const std::string& file = {}) {
    Problems problems;
    const auto scene = readScene("{\"objects\": [" + objects + "]}", "f", problems,
                                 [&](const std::string&, Problems&) { return std::optional(file); });
    EXPECT_EQ(toString(problems), "");
    return scene.value_or(Scene{}).objects;
}

const std::string kSurface = R"({"surface": {"file": "a.bpt"}})";

/// A flat square of side 3 from a corner on, as lines of a BPT file.
std::string square(int corner, const std::string& weight = {}) {
    std::string lines = "3 3\n";
    for (int k = 0; k < 16; ++k)
        lines += std::to_string(corner + k % 4) + " 0 " + std::to_string(k / 4) + weight + "\n";
    return lines;
}

TEST(Surface, OfAFileIsAnObjectForEachPatch) {
    const auto objects = objectsOf(kSurface, "2\n" + square(0) + square(3));
    ASSERT_EQ(objects.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const Shape& shape = objects[i].shape;
        ASSERT_EQ(shape.kind, ShapeKind::SpacePatch);
        expectNear(pointOf(shape, "anchor"), {3, 0, 1.5}, 0, "of the whole model");
        const Extent box = shapeRow(shape.kind).extent(shape);
        expectNear(box.low, {3.0 * double(i), 0, 0}, 1e-12, "low");
        expectNear(box.high, {3.0 * double(i) + 3, 0, 3}, 1e-12, "high");
    }
}

TEST(Surface, HasWeightsOfAPowerOfTwoTimesThoseOfItsFile) {
    const Shape shape = objectsOf(kSurface, "1\n" + square(0, " 12"))[0].shape;
    for (const glm::dvec4& p : shape.net->points) EXPECT_EQ(p.w, 1.5);
    expectNear(glm::dvec3(shape.net->points[15]), glm::dvec3(1.5, 0, 1.5) * 1.5, 0, "from the anchor, weighted");
}

TEST(Surface, IsReadAsAnySystemWritesIt) {
    std::string text = "\xef\xbb\xbf"
                       "1\n\n" +
                       square(0);
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
    EXPECT_EQ(objectsOf(kSurface, text).size(), 1u);
    std::string tabs = "1\n" + square(0);
    for (char& c : tabs) c = c == ' ' ? '\t' : c;
    EXPECT_EQ(objectsOf(kSurface, tabs.substr(0, tabs.size() - 1)).size(), 1u) << "no end of its last line";
}

TEST(Surface, GoesThroughEveryAffineMap) {
    const auto objects = objectsOf(R"({"group": {"of": [)" + kSurface +
                                       R"(], "scale": [1, 2, 5], "rotate": [90, 0, 0], "translate": [0, 10, 0]}})",
                                   "1\n" + square(0));
    const Extent box = shapeRow(ShapeKind::SpacePatch).extent(objects.at(0).shape);
    expectNear(box.low, {0, -5, 0}, 1e-12, "low");
    expectNear(box.high, {3, 10, 0}, 1e-12, "high");
}

TEST(Surface, RefusesEveryBadFileWithItsLine) {
    const auto told = [](const std::string& file) { return problemsOf(kSurface, file); };
    const std::string at = "f:1: objects[0].surface.file: a.bpt:";
    const std::string sq = square(0);
    EXPECT_EQ(told(""), at + "0: is empty; begin with the number of patches\n");
    EXPECT_EQ(told("# a teapot\n"),
              at + "1: begins with no number of patches; write how many there are on a line of its own\n");
    EXPECT_EQ(told("0\n"), at + "1: begins with no number of patches; write how many there are on a line of its own\n");
    EXPECT_EQ(told("100000\n"),
              at + "1: 100000 patches; a scene has at most 80000 objects; use a model of fewer patches\n");
    EXPECT_EQ(told("1\n2 3\n"), at + "2: a patch of degrees 2 and 3; raise its degrees to 3 and 3\n");
    EXPECT_EQ(told("1\n0 0 0\n"), at + "2: a patch does not begin with its degrees; write 3 3, then its 16 points\n");
    EXPECT_EQ(told("2\n" + sq),
              at + "18: ends within patch 2 of 2; let the first line tell how many there are, each of 16 points\n");
    EXPECT_EQ(told("1\n3 3\n0 0 0\n"),
              at + "3: ends within patch 1 of 1; let the first line tell how many there are, each of 16 points\n");
    EXPECT_EQ(told("1\n" + sq + "0 0 0\n"),
              at + "19: a line after the last of 1 patches; let the first line tell how many there are\n");
    EXPECT_EQ(told("1\n3 3\n0 0\n"), at + "3: a point of 2 numbers; write x, y and z, or these and a weight\n");
    EXPECT_EQ(told("1\n3 3\n0 0 0\n0 0 0 1\n"),
              at + "4: a point with a weight, unlike those before it; give all points of a patch weights, or none\n");
    EXPECT_EQ(told("1\n3 3\n0 0 0x1\n"), at + "3: \"0x1\" is no number; write decimals with a point\n");
    EXPECT_EQ(told("1\n3 3\n0 0 1e7\n"), at + "3: 1e7 is outside the limits; keep numbers from -1000000 to 1000000\n");
    EXPECT_EQ(told("1\n3 3\n0 0 0 0\n"), at + "3: a weight of 0; keep weights from 0.001 to 1000\n");
    std::string point = "1\n3 3\n";
    for (int i = 0; i < 16; ++i) point += "1 2 3\n";
    EXPECT_EQ(told(point), "f:1: objects[0].surface.file: a.bpt: patch 1: its surface reaches 0 from its middle; keep "
                           "that from 1e-06 to 1000000\n");
}

TEST(Surface, OfPointsInTheSceneIsChecked) {
    const auto list = [](int count, const std::string& point) {
        std::string points;
        for (int i = 0; i < count; ++i) points += (i ? ", " : "") + point;
        return R"({"patch": {"points": [)" + points + "]}}";
    };
    const std::string at = "f:1: objects[0].patch.points";
    const std::string remedy = "; write 16 points as [x, y, z], or all with a weight, [x, y, z, w]\n";
    EXPECT_EQ(problemsOf(list(15, "[0, 1, 2]"), ""), at + ": expected a list of 16 points, found 15 entries" + remedy);
    std::string mixed = list(16, "[0, 1, 2]");
    mixed.insert(mixed.rfind("]]}}"), ", 1");
    EXPECT_EQ(problemsOf(mixed, ""), at + "[15]: expected a list of 3 numbers, found 4 entries" +
                                         remedy.substr(0, remedy.size() - 1) + ", decimals with a point\n");
    EXPECT_NE(problemsOf(list(16, "[0, 1, 2, 0]"), "").find(at + "[0][3]: 0 is outside the limits"), std::string::npos);
    EXPECT_EQ(problemsOf(list(16, "[0, 1, 2]"), ""),
              "f:1: objects[0].patch: its surface reaches 0 from its middle; keep that from 1e-06 to 1000000\n");
    EXPECT_NE(problemsOf(R"({"patch": {"random": 1, "points": []}})", "").find("more than one net"), std::string::npos);
}

TEST(Surface, OfTheTeapotHas290PointsAndSharedEdges) {
    const auto objects = objectsOf(kSurface, textOf(std::string(GNOMON_SOURCE_DIR) + "/assets/scenes/teapot.bpt"));
    ASSERT_EQ(objects.size(), 32u);
    std::vector<glm::dvec3> points;
    std::vector<std::array<glm::dvec3, 4>> edges;
    for (const Object& object : objects) {
        const auto& net = object.shape.net->points;
        for (const glm::dvec4& p : net) points.emplace_back(p);
        for (const auto& [first, step] : {std::pair{0, 1}, {12, 1}, {0, 4}, {3, 4}}) {
            std::array<glm::dvec3, 4> edge;
            for (int i = 0; i < 4; ++i) edge[std::size_t(i)] = glm::dvec3(net[std::size_t(first + i * step)]);
            edges.push_back(edge);
        }
    }
    const auto distinct = [](std::vector<glm::dvec3> list) {
        std::vector<glm::dvec3> found;
        for (const glm::dvec3& p : list)
            if (std::find(found.begin(), found.end(), p) == found.end()) found.push_back(p);
        return found.size();
    };
    EXPECT_EQ(distinct(points), 290u);
    // All edges are seams but where the lid and the body end, four each, and both ends of the spout and of the handle,
    // two each.
    int alone = 0, points_ = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const bool point = edges[i][0] == edges[i][3] && edges[i][1] == edges[i][2];
        points_ += point;
        int others = 0;
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const auto& [a, b, c, d] = edges[k];
            others += k != i && (edges[k] == edges[i] || std::array{d, c, b, a} == edges[i]);
        }
        alone += !point && others == 0;
    }
    EXPECT_EQ(points_, 8) << "the lid's tip and the middle of the bottom";
    EXPECT_EQ(alone, 16);
}

} // namespace
} // namespace gnomon
