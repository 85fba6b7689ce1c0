/// Files of results: read back as they were written, those of earlier versions too, and those that are none.
#include "lab/results/read_results.h"
#include "tests/support/result_rows.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace gnomon {
namespace {

using test::compared;
using test::named;
using test::row;
using test::run;

TEST(ReadResults, TakesBackWhatWasWritten) {
    Results results = run({row("lite", 1, 0.1, 1e300), row("a \"b\" → c", -4, 20, 2)});
    results.tables[0].rows[1][2] = Cell{};
    results.charts = {
        {"C", "bench", "depth", {{"frame", "x"}}, "", "scene", {{"scene", "lite"}}, true, false, "passes"}};
    results.images = {"data:image/png;base64,AAAA", "data:image/png;base64,BBBB"};
    results.pictures = {{"P", "bench", {"lite", 1.0}, 1, 0, "R"}, {"Q", "bench", {"lite", 4.0}, 0, {}, ""}};
    Problems problems;
    const auto read = readResults(toJson(results), "f", problems);
    ASSERT_TRUE(read) << toString(problems);
    EXPECT_EQ(toJson(*read), toJson(results));
    EXPECT_EQ(read->tables[0].rows, results.tables[0].rows);
    EXPECT_EQ(read->tables[0].columns[2].kind, Kind::Time);
    EXPECT_EQ(read->charts[0].front, "passes");
    EXPECT_EQ(read->pictures[0].reference, std::optional<std::size_t>(0));
}

/// A run of `gnomon lab shadows`, with a chart and a picture; `origin` names the column and the ends of its cones.
Results shadowRun(const std::string& key, const std::string& origin, const std::string& surface) {
    Results results{"T", "c", {}, {}, {}, {}, {}};
    results.tables = {{"shadows",
                       "S",
                       {{"model", "model", "", ""}, {key, origin, "", ""}, {"rmse", "error", "", "", Kind::Error}},
                       {{"cone-linear", surface, 0.5}, {"hard", Cell{}, 1.0}},
                       2},
                      {"rivals", "R", {{"way", "way", "", ""}}, {{"cone-linear 1/30 " + surface}, {"silhouette"}}, 1}};
    results.charts = {{"C", "shadows", "rmse", {{"rmse", ""}}, key, "", {{key, surface}}, false, false, ""}};
    results.images = {"data:image/png;base64,AAAA"};
    results.pictures = {{"P", "shadows", {"cone-linear", surface}, 0, {}, ""}};
    return results;
}

TEST(ReadResults, BringsConeOriginsOfEarlierRunsUpToDate) {
    Problems problems;
    const auto then = readResults(toJson(shadowRun("direction", "direction", "A")), "f", problems);
    ASSERT_TRUE(then) << toString(problems);
    const Results now = shadowRun("cone_origin", "cone origin", "surface");
    EXPECT_EQ(toJson(*then), toJson(now));
    const Results both = compareRuns(*then, now, 0, problems);
    EXPECT_TRUE(problems.empty()) << toString(problems);
    ASSERT_EQ(both.tables.size(), 1U) << "no row is missing";
    EXPECT_EQ(both.tables[0].rows[0][3], Cell(2.0)) << "both rows are compared";
}

TEST(ReadResults, BringsCalibratedFramesOfEarlierRunsUpToDate) {
    const Results now = run({row("lite", 1, 10, 2)});
    Results then = now;
    for (Column& column : then.tables[0].columns)
        if (column.key.starts_with("frame_calibrated"))
            column.key = "frame_yards" + column.key.substr(std::string("frame_calibrated").size());
    EXPECT_NE(toJson(then), toJson(now));
    Problems problems;
    const auto read = readResults(toJson(then), "f", problems);
    ASSERT_TRUE(read) << toString(problems);
    EXPECT_EQ(toJson(*read), toJson(now));
    const Results both = compared(*read, run({row("lite", 1, 10, 1)}));
    EXPECT_EQ(named(both, "bench_frame").rows[0][8], Cell(0.5)) << "by the calibrated frames";
}

/// A run of `gnomon lab intersect`, whose columns of wrong decisions have those names.
Results intersectRun(const std::string& ours, const std::string& textbook) {
    Results results{"T", "c", {}, {}, {}, {}, {}};
    results.tables = {{"intersect",
                       "I",
                       {{"shape", "shape", "", ""},
                        {ours, "wrong decisions", "%", "", Kind::Error},
                        {textbook, "textbook: wrong decisions", "%", "", Kind::Error}},
                       {{"torus", 0.0, 2.0}},
                       1}};
    results.charts = {{"C", "intersect", "shape", {{ours, "ours"}, {textbook, "textbook"}}, "", "", {}, false, false}};
    return results;
}

TEST(ReadResults, BringsWrongDecisionsOfEarlierRunsUpToDate) {
    const Results now = intersectRun("wrong_decisions", "textbook_wrong_decisions");
    for (const char* textbook : {"textbook_share", "naive_share"}) {
        Problems problems;
        const auto then = readResults(toJson(intersectRun("share", textbook)), "f", problems);
        ASSERT_TRUE(then) << toString(problems);
        EXPECT_EQ(toJson(*then), toJson(now));
    }
}

TEST(ReadResults, BringsSettingsAndWaysOfEarlierRunsUpToDate) {
    Results then = run({row("lite", 1, 1, 1)});
    then.tables[0].columns[0].key = "direction";
    then.tables[0].rows[0][0] = "b";
    then.tables.push_back({"scenes", "S", {{"way", "way", "", ""}}, {{"parts"}, {"auto"}}, 1});
    Problems problems;
    const auto read = readResults(toJson(then), "f", problems);
    ASSERT_TRUE(read) << toString(problems);
    EXPECT_EQ(read->tables[0].columns[0].key, "cone-origin");
    EXPECT_EQ(read->tables[0].rows[0][0], Cell("light"));
    EXPECT_EQ(read->tables[1].rows, (std::vector<std::vector<Cell>>{{"variants"}, {"auto"}}));
}

/// The one problem of a text.
std::string fault(const std::string& text) {
    Problems problems;
    EXPECT_FALSE(readResults(text, "f.json", problems));
    EXPECT_EQ(problems.size(), 1U);
    return toString(problems.front());
}
std::string broken(const std::string& from, const std::string& to) {
    Results results = run({row("lite", 1, 1, 1)});
    results.charts = {{"C", "bench", "depth", {{"frame", ""}}, "", "", {}, false, false}};
    results.images = {"data:image/png;base64,AAAA"};
    results.pictures = {{"P", "bench", {"lite", 1.0}, 0, 0, "R"}};
    std::string text = toJson(results);
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return fault(text.replace(at, from.size(), to));
}

TEST(ReadResults, SaysLineAndPlaceOfTheFirstThingWrong) {
    EXPECT_EQ(fault(" \n"), "f.json: the file is empty; write it anew with --json=FILE");
    EXPECT_EQ(fault("{\n\"format\": \"gnomon-results\",\n").rfind("f.json:", 0), 0U);
    EXPECT_NE(fault("{\"objects\": []}").find("f.json:1: this is no file of results"), std::string::npos);
    EXPECT_NE(fault("[1]").find("this is no file of results"), std::string::npos);
    EXPECT_NE(broken("\"version\": 1", "\"version\": 2").find("f.json:3: version: version 2"), std::string::npos);
    EXPECT_NE(broken("\"title\": \"T\"", "\"title\": 3").find("f.json:4: title: has to be a string, not a number"),
              std::string::npos);
    EXPECT_NE(broken("\"keys\": 2", "\"keys\": 99").find("tables[0].keys: 99 is no number of columns"),
              std::string::npos);
    EXPECT_NE(broken("\"lite\",", "").find("tables[0].rows[0]: the row has 11 cells instead of 12"), std::string::npos);
    EXPECT_NE(broken("\"lite\"", "[]").find("tables[0].rows[0][0]: a list is no number, text or null"),
              std::string::npos);
    EXPECT_NE(broken("\"x\": \"depth\"", "\"x\": \"width\"").find("charts[0].x: table \"bench\" has no column"),
              std::string::npos);
    EXPECT_NE(broken("\"command\"", "\"comand\"").find("command: is missing"), std::string::npos);
    EXPECT_NE(broken("\"kind\": \"time\"", "\"kind\": \"tide\"").find("kind: \"tide\" is none of time, ratio, error"),
              std::string::npos);
}

TEST(ReadResults, HoldsPicturesAgainstTablesAndImages) {
    EXPECT_NE(broken("image/png", "text/html").find("images[0]: is no PNG"), std::string::npos);
    EXPECT_NE(broken("\"row\": [", "\"row\": [7, ").find("pictures[0].row: the row has 3 cells instead of 2"),
              std::string::npos);
    EXPECT_NE(broken("\"image\": 0", "\"image\": 1").find("pictures[0].image: 1 is no image; there are 1"),
              std::string::npos);
    EXPECT_NE(broken("\"title\": \"R\"", "\"title\": 1").find("pictures[0].reference.title"), std::string::npos);
    EXPECT_NE(broken("\"images\"", "\"imags\"").find("images: is missing"), std::string::npos);
}

} // namespace
} // namespace gnomon
