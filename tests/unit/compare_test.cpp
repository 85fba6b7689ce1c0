/// Two runs against each other: medians, noise, rows that belong together, and files that are none.
#include "lab/results/compare.h"
#include "lab/results/quartiles.h"
#include "lab/results/read_results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace gnomon {
namespace {

TEST(Quartiles, LieBetweenValues) {
    const Quartiles four = quartilesOf({4, 1, 3, 2});
    EXPECT_DOUBLE_EQ(four.low, 1.75);
    EXPECT_DOUBLE_EQ(four.median, 2.5);
    EXPECT_DOUBLE_EQ(four.high, 3.25);
    const Quartiles one = quartilesOf({7});
    EXPECT_EQ(one.low, 7);
    EXPECT_EQ(one.high, 7);
}

TEST(Quartiles, RatiosCancelWhatDrifts) {
    const Quartiles ratio = ratioOf({2, 20, 200, 5}, {1, 10, 100});
    EXPECT_EQ(ratio.low, 2);
    EXPECT_EQ(ratio.high, 2);
}

TEST(Quartiles, NotchesBoundTheRatioOfMedians) {
    const Ratio ratio = ratioOfMedians({{9, 10, 11}, 4}, {{4, 5, 6}, 16}, 1); // notches 2.03 and 0.84
    EXPECT_DOUBLE_EQ(ratio.value, 2);
    EXPECT_DOUBLE_EQ(ratio.low, (10 - 2.03) / (5 + 0.84));
    EXPECT_DOUBLE_EQ(ratio.high, (10 + 2.03) / (5 - 0.84));
    EXPECT_EQ(ratioOfMedians({{1, 1, 1}, 3}, {{0, 1, 9}, 3}, 1).high, std::numeric_limits<double>::infinity());
}

TEST(Quartiles, NotchesGrowWithTheRowsReadTogether) {
    const auto notch = [](std::size_t rows) { return notchOf({{0, 1, 1}, 4}, rows); };
    EXPECT_DOUBLE_EQ(notch(5), 3.14 / 2);
    EXPECT_DOUBLE_EQ(notch(25), 4.44 / 2);
    EXPECT_GT(notch(24), 4.3 / 2);
    EXPECT_LT(notch(24), notch(25));
    EXPECT_NEAR(notch(15625), 10.6 / 2 * 10.6 / 7.97, 1e-9) << "beyond the table the tail goes on as a power";
}

TEST(Quartiles, OneValueLeavesARatioNoBounds) {
    const Ratio ratio = ratioOfMedians({{1, 1, 1}}, {{1, 1, 1}, 3}, 1);
    EXPECT_EQ(ratio.low, 0);
    EXPECT_EQ(ratio.high, std::numeric_limits<double>::infinity());
}

/// A row as a run measures it: so many rounds about `mean`, with lognormal noise.
Spread measured(std::mt19937& random, double mean, double noise, int rounds) {
    std::lognormal_distribution<double> time(std::log(mean), noise);
    std::vector<double> times(std::size_t(rounds), 0.0);
    for (double& one : times) one = time(random);
    return {quartilesOf(times), double(rounds)};
}

/// Fraction of columns of two runs of one program of which a row or more is told apart.
double falseColumns(int rounds, std::size_t rows, int columns) {
    std::mt19937 random(1);
    int wrong = 0;
    for (int i = 0; i < columns; ++i) {
        bool apart = false;
        for (std::size_t row = 0; row < rows; ++row) {
            const Spread old = measured(random, 100, 0.02, rounds), now = measured(random, 100, 0.02, rounds);
            const Ratio ratio = ratioOfMedians(now, old, rows);
            apart |= ratio.low > 1 || ratio.high < 1;
        }
        wrong += apart;
    }
    return double(wrong) / columns;
}

// What the header promises, within three standard deviations of so many columns: neither more false ones nor, where
// notches would be wider than they need to be, fewer.
TEST(Quartiles, NotchesTellNoRowOfLikeRunsApartInNineteenColumnsOfTwenty) {
    for (const int rounds : {2, 3, 4, 5, 6, 7, 8, 9}) {
        const double wrong = falseColumns(rounds, 24, 2500);
        EXPECT_GT(wrong, 0.032) << rounds;
        EXPECT_LT(wrong, 0.063) << rounds;
    }
    EXPECT_NEAR(falseColumns(3, 1, 10000), 0.05, 0.0066);
    EXPECT_NEAR(falseColumns(3, 625, 300), 0.05, 0.038);
    EXPECT_LT(falseColumns(15, 24, 500), 0.05);
}

/// Rows of scene, depth and a frame with quartiles, and over the calibration workload.
Table runTable(const std::vector<std::vector<Cell>>& rows) {
    Table table{"bench", "Bench", {}, rows, 2};
    table.columns = {{"scene", "scene", "", ""},
                     {"depth", "depth", "", ""},
                     {"frame", "frame", "ms", "", Kind::Time, Better::Lower},
                     {"frame_low", "", "ms", ""},
                     {"frame_high", "", "ms", ""},
                     {"frame_calibrated", "frame", "calibration = 1", ""},
                     {"frame_calibrated_low", "", "calibration = 1", ""},
                     {"frame_calibrated_high", "", "calibration = 1", ""},
                     {"cpu", "cpu", "ms", "", Kind::Time, Better::Lower},
                     {"cpu_low", "", "ms", ""},
                     {"cpu_high", "", "ms", ""},
                     {"passes", "passes", "", ""}};
    return table;
}
std::vector<Cell> row(const std::string& scene, double depth, double frame, double calibrated) {
    return {scene, depth, frame, frame, frame, calibrated, 0.99 * calibrated, 1.01 * calibrated, 1.0, 1.0, 1.0, 4.0};
}
Results run(const std::vector<std::vector<Cell>>& rows) { return {"T", "c", {{"gl", "4.5"}}, {runTable(rows)}, {}}; }

Results compared(const Results& before, const Results& after) {
    Problems problems;
    Results all = compareRuns(before, after, 0.05, problems);
    EXPECT_TRUE(problems.empty()) << toString(problems);
    return all;
}

/// The only table of that name.
const Table& named(const Results& results, const std::string& name) {
    const auto found = std::find_if(results.tables.begin(), results.tables.end(),
                                    [&](const Table& table) { return table.name == name; });
    EXPECT_NE(found, results.tables.end()) << "no table " << name;
    static const Table none;
    return found == results.tables.end() ? none : *found;
}

TEST(Compare, MatchesRowsByTheirKeysAndTellsRatiosOfCalibratedFrames) {
    const Results all = compared(run({row("lite", 1, 10, 1), row("lite", 4, 20, 2), row("pro", 1, 40, 4)}),
                                 run({row("lite", 4, 10, 2.06), row("lite", 1, 10, 2), row("new", 1, 10, 1)}));
    ASSERT_EQ(all.tables.size(), 3U) << "summary, frame, missing rows; CPU times are not calibrated";
    const Table& table = named(all, "bench_frame");
    ASSERT_EQ(table.rows.size(), 2U);
    for (const auto& cells : table.rows) EXPECT_EQ(cells.size(), table.columns.size());
    EXPECT_EQ(table.rows[0][1], Cell(4.0));
    EXPECT_EQ(table.rows[0][2], Cell(20.0)) << "old";
    EXPECT_EQ(table.rows[0][5], Cell(10.0)) << "new";
    EXPECT_EQ(table.rows[0][8], Cell(1.03));
    EXPECT_EQ(table.rows[0].back(), Cell("the same within noise"));
    EXPECT_EQ(table.rows[1][8], Cell(2.0));
    EXPECT_EQ(table.rows[1].back(), Cell("slower"));
    const std::vector<std::vector<Cell>> summary{{"Bench", "frame", "time", 2.0, 0.0, 1.0, 1.0}};
    EXPECT_EQ(all.tables.front().rows, summary);
    EXPECT_EQ(all.environment, (Environment{{"gl", "4.5"}}));
}

/// A run of 24 rows, three rounds each, whose calibrated times have a noise of 2 %; `shared`: and a part that is the
/// same for all rows, as where one baseline is below all ratios.
Results noisyRun(std::mt19937& random, double mean, bool shared) {
    std::vector<std::vector<Cell>> rows;
    std::normal_distribution<double> noise(0, 0.02);
    const std::array common{noise(random), noise(random), noise(random)};
    for (int i = 0; i < 24; ++i) {
        std::vector<double> rounds;
        for (const double luck : common) rounds.push_back(mean * std::exp(noise(random) - (shared ? luck : 0)));
        const Quartiles calibrated = quartilesOf(rounds);
        rows.push_back(
            {"a", double(i), 1.0, 1.0, 1.0, calibrated.median, calibrated.low, calibrated.high, 1.0, 1.0, 1.0, 3.0});
    }
    return run(rows);
}

/// How many of 24 rows a comparison without tolerance calls different.
double calledDifferent(const Results& before, const Results& after) {
    Problems problems;
    const Results all = compareRuns(before, after, 0, problems);
    const auto& summary = all.tables.at(0).rows.at(0);
    return std::get<double>(summary.at(4)) + std::get<double>(summary.at(5));
}

TEST(Compare, CallsARowOfOneProgramDifferentInOneColumnOfTwentyAtMost) {
    std::mt19937 random(1);
    constexpr int kColumns = 1000;
    for (const bool shared : {false, true}) {
        int wrong = 0;
        for (int i = 0; i < kColumns; ++i)
            wrong += calledDifferent(noisyRun(random, 1, shared), noisyRun(random, 1, shared)) > 0;
        EXPECT_LT(wrong, 0.07 * kColumns) << shared;
        EXPECT_GT(wrong, (shared ? 0.01 : 0.03) * kColumns) << shared;
    }
}

TEST(Compare, CallsHalfAsMuchAgainDifferentInNearlyEveryRow) {
    std::mt19937 random(1);
    double called = 0;
    for (int i = 0; i < 100; ++i) called += calledDifferent(noisyRun(random, 1, false), noisyRun(random, 1.5, false));
    EXPECT_GT(called, 0.99 * 100 * 24);
}

TEST(Compare, NamesTheRowsThatOnlyOneRunHas) {
    const Results all =
        compared(run({row("lite", 1, 1, 1), row("pro", 1, 1, 1)}), run({row("lite", 1, 1, 1), row("new", 4, 1, 1)}));
    const std::vector<std::vector<Cell>> missing{{"Bench", "pro, 1", "old"}, {"Bench", "new, 4", "new"}};
    EXPECT_EQ(named(all, "missing").rows, missing);
}

TEST(Compare, CallsFasterOnlyWhatIsBeyondNoiseAndTolerance) {
    const auto verdict = [](double calibrated) {
        const Results all = compared(run({row("a", 1, 1, 1)}), run({row("a", 1, 1, calibrated)}));
        return std::get<std::string>(named(all, "bench_frame").rows.at(0).back());
    };
    EXPECT_EQ(verdict(0.955), "the same within noise") << "beyond the notches' 4.1 %, within the tolerance of 5 %";
    EXPECT_EQ(verdict(0.94), "faster");
    EXPECT_EQ(verdict(1.06), "slower");
}

/// One row of one number, with quartiles 1 % about it of nine rounds where it is a ratio.
Results numberRun(const Column& column, const Cell& value) {
    Table table{"t", "T", {{"row", "row", "", ""}, column}, {{"a", value}}, 1};
    if (const double* number = std::get_if<double>(&value); column.kind == Kind::Ratio)
        for (const auto& [key, other] :
             {std::pair(column.key + "_low", 0.99 * *number), std::pair(column.key + "_high", 1.01 * *number),
              std::pair(std::string("rounds"), 9.0)}) {
            table.columns.push_back({key, "", "", ""});
            table.rows[0].emplace_back(other);
        }
    return {"T", "c", {}, {table}, {}};
}
/// What became of it: the summary's kind and verdict, and how the change is told, if it is.
std::string became(const Column& column, const Cell& was, const Cell& is) {
    const Results all = compared(numberRun(column, was), numberRun(column, is));
    const auto& summary = all.tables.front().rows.at(0);
    std::string text = shown(summary[2]) + ": ";
    for (int i = 4; i < 7; ++i)
        if (summary[std::size_t(i)] == Cell(1.0)) text += shown(Cell(all.tables.front().columns[std::size_t(i)].title));
    for (const Table& table : all.tables)
        if (table.name != "changes") text += ", " + shown(table.rows.at(0).back());
    return text;
}

TEST(Compare, TellsRatiosThatAreBetterHigherTheOtherWayRound) {
    const Column slow{"r", "r", "none = 1", "", Kind::Ratio, Better::Lower},
        speedUp{"r", "r", "source = 1", "", Kind::Ratio, Better::Higher};
    EXPECT_EQ(became(slow, 2.0, 3.0), "ratio: worse, slower");
    EXPECT_EQ(became(speedUp, 2.0, 3.0), "ratio: better, faster");
    EXPECT_EQ(became(speedUp, 3.0, 2.0), "ratio: worse, slower");
    EXPECT_EQ(became(slow, 2.0, 2.05), "ratio: the same, the same within noise");
}

TEST(Compare, TellsErrorsBeyondTheirToleranceBySize) {
    const Column error{"e", "e", "", "", Kind::Error};
    EXPECT_EQ(became(error, 0.1, 0.1009), "error: the same");
    EXPECT_EQ(became(error, 0.1, 0.1012), "error: worse, worse");
    EXPECT_EQ(became(error, 0.1, 0.09), "error: better, better");
    EXPECT_EQ(became(error, -0.1, 0.05), "error: better, better") << "nearer to nothing";
    EXPECT_EQ(became(error, 0.0, 1e-30), "error: worse, worse") << "what was right is no more";
    EXPECT_EQ(became(error, "inf", 1e30), "error: better, better");
    EXPECT_EQ(became(error, "nan", "inf"), "error: the same") << "as bad";
}

TEST(Compare, TellsCountsExactly) {
    const Column wrong{"c", "c", "", "", Kind::Count, Better::Lower},
        hits{"c", "c", "", "", Kind::Count, Better::Higher}, rays{"c", "c", "", "", Kind::Count};
    EXPECT_EQ(became(wrong, 1e6, 1e6), "count: the same");
    EXPECT_EQ(became(wrong, 1e6, 1e6 + 1), "count: worse, worse");
    EXPECT_EQ(became(hits, 1e6, 1e6 + 1), "count: better, better");
    EXPECT_EQ(became(rays, 1e6, 1e6 + 1), "count: worse, more");
    EXPECT_EQ(became(rays, 1e6, 1e6 - 1), "count: better, less");
}

TEST(Compare, SaysWhatDiffersBetweenTheMachines) {
    Results before = run({row("a", 1, 1, 1)}), after = before;
    after.environment = {{"gl", "4.6"}};
    EXPECT_EQ(compared(before, after).environment, (Environment{{"gl", "4.5 → 4.6"}}));
}

TEST(Compare, RefusesWhatCannotBeMatched) {
    Problems twice, nothing;
    compareRuns(run({row("a", 1, 1, 1), row("a", 1, 2, 2)}), run({row("a", 1, 1, 1)}), 0, twice);
    EXPECT_NE(toString(twice).find("several rows are \"a, 1\""), std::string::npos) << toString(twice);
    compareRuns(run({row("a", 1, 1, 1)}), run({row("b", 1, 1, 1)}), 0, nothing);
    EXPECT_NE(toString(nothing).find("no measured row in common"), std::string::npos) << toString(nothing);
}

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
