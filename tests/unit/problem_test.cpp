// Problems as users read them, and the suggestions in them.
#include "tracer/problem.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon {
namespace {

TEST(Problem, ReadsAsFileLinePathWhatAndRemedy) {
    const Problem problem{"scenes/pro.json", 41, "objects[12].torus", "minor_radius 1.2 exceeds major_radius 1",
                          "use less"};
    EXPECT_EQ(toString(problem),
              "scenes/pro.json:41: objects[12].torus: minor_radius 1.2 exceeds major_radius 1; use less");
}

TEST(Problem, LeavesOutWhatItDoesNotKnow) {
    EXPECT_EQ(toString(Problem{"", 0, "", "what", ""}), "what");
    EXPECT_EQ(toString(Problem{"file", 0, "", "what", ""}), "file: what");
    EXPECT_EQ(toString(Problem{"", 3, "", "what", ""}), "line 3: what");
    EXPECT_EQ(toString(Problem{"", 0, "path", "what", "remedy"}), "path: what; remedy");
}

TEST(Problem, StandsOneALineAmongOthers) {
    EXPECT_EQ(toString(Problems{{"a", 1, "", "x", ""}, {"b", 2, "", "y", ""}}), "a:1: x\nb:2: y\n");
}

TEST(Problems, BeyondAScreenAreCounted) {
    const Problem one{"f", 1, "", "wrong", ""};
    EXPECT_EQ(screenful(Problems(kMostProblems, one)).size(), kMostProblems);
    const Problems some = screenful(Problems(300, one));
    ASSERT_EQ(some.size(), kMostProblems);
    EXPECT_EQ(toString(some.back()), "and 281 more problems");
    const std::string text = toString(Problems(300, one));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), int(kMostProblems));
}

TEST(Problems, OfOneInputAreCountedBeyondAScreen) {
    for (const std::size_t count : {0, 1, 19, 20, 21, 5000}) {
        Problems kept;
        {
            ProblemCounter counter("f", kept);
            for (std::size_t i = 0; i < count; ++i) counter.add(1, "", "wrong");
            EXPECT_EQ(counter.count(), count);
        }
        EXPECT_EQ(kept.size(), std::min(count, kMostProblems));
        const std::size_t more = count - 19;
        if (count >= kMostProblems) {
            EXPECT_EQ(toString(kept.back()),
                      "f: and " + std::to_string(more) + " more problem" + (more == 1 ? "" : "s"));
        }
    }
}

TEST(Number, IsShownWithoutTrailingZeros) {
    EXPECT_EQ(toString(1.0), "1");
    EXPECT_EQ(toString(-0.25), "-0.25");
    EXPECT_EQ(toString(1e6), "1000000");
    EXPECT_EQ(toString(1e-6), "1e-06");
}

TEST(Quote, KeepsMessagesOnOneLine) { EXPECT_EQ(inQuotes("a\nb\tc"), "\"a?b?c\""); }

TEST(Quote, CutsLongTextBetweenCharacters) {
    std::string text(47, 'x');
    EXPECT_EQ(inQuotes(text + "\u00fcyyy"), "\"" + text + "...\"")
        << "the two bytes of the last letter belong together";
}

TEST(Closest, FindsDroppedDoubledWrongAndSwappedLetters) {
    const std::vector<std::string_view> keys{"sphere", "plane", "triangle", "minor_radius"};
    EXPECT_EQ(closest("spere", keys), "sphere");
    EXPECT_EQ(closest("planne", keys), "plane");
    EXPECT_EQ(closest("trIANGEL", keys), "triangle");
    EXPECT_EQ(closest("minorradius", keys), "minor_radius");
}

TEST(Closest, FindsNothingWhereNothingIsMeant) {
    const std::vector<std::string_view> keys{"sphere", "plane", "n"};
    EXPECT_EQ(closest("mandelbulb", keys), "");
    EXPECT_EQ(closest("k", keys), "") << "one letter replaced by another is another word";
    EXPECT_EQ(closest("", keys), "");
    EXPECT_EQ(closest(std::string(1000000, 'p'), keys), "");
    EXPECT_EQ(closest("sphere", {}), "");
}

TEST(Closest, PrefersTheNearerCandidateAndThenTheFirst) {
    EXPECT_EQ(closest("cones", {"coned", "cone", "conex"}), "coned");
    EXPECT_EQ(closest("spheer", {"spheres", "sphere"}), "sphere");
}

} // namespace
} // namespace gnomon
