// Transforms within transforms: refused where their product leaves what float32 computes with.
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

/// `depth` transforms, one within another, around a unit sphere.
std::string nested(int depth, const std::string& fields) {
    std::string part = R"({"sphere": {"center": [0, 0, 0], "radius": 1}})";
    for (int i = 0; i < depth; ++i) part = R"({"transform": {"of": )" + part + ", " + fields + "}}";
    return R"({"objects": [)" + part + "]}";
}

std::string problemsOf(const std::string& text) {
    Problems problems;
    const auto scene = readScene(text, "f", problems);
    EXPECT_EQ(scene.has_value(), problems.empty());
    return toString(problems);
}

TEST(NestedTransforms, MayScaleByAMillionInAll) {
    EXPECT_EQ(problemsOf(nested(2, R"("scale": 1000)")), "");
    EXPECT_EQ(problemsOf(nested(2, R"("scale": 0.001)")), "");
    EXPECT_EQ(problemsOf(nested(16, R"("scale": 0.001)")),
              "f:1: objects[0]: its transforms, one within another, scale by 1e-48; keep their product from 1e-06 to "
              "1000000\n");
    EXPECT_EQ(problemsOf(nested(13, R"("scale": 1000)")),
              "f:1: objects[0]: its transforms, one within another, scale by 1e+39; keep their product from 1e-06 to "
              "1000000\n");
}

TEST(NestedTransforms, MayMoveAsFarAsCoordinatesSquare) {
    EXPECT_EQ(problemsOf(nested(10, R"("translate": [1e6, 0, 0])")), "");
    EXPECT_NE(problemsOf(R"({"objects": [{"transform": {"scale": 1000, "of": {"transform": {"scale": 1000, "of":
                             {"sphere": {"center": [1e6, 0, 0], "radius": 1}}}}}}]})")
                  .find("reach 1.000001e+12 units away; keep them within 1e+10"),
              std::string::npos);
}

} // namespace
} // namespace gnomon
