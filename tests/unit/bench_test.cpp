/// What `gnomon bench` draws and shows: every combination of values once, each row beside its baseline.
#include "lab/bench/bench_series.h"
#include "lab/bench/bench_tables.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon {
namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

BenchPlan planned(const std::vector<std::string>& scenes, const Values& values, const std::string& baseline = {}) {
    Problems problems;
    BenchPlan plan = planBench(scenes, values, baseline, problems);
    EXPECT_TRUE(problems.empty()) << toString(problems);
    return plan;
}

std::string refusal(const Values& values, const std::string& baseline = {}) {
    Problems problems;
    planBench({"lite"}, values, baseline, problems);
    return toString(problems);
}

Cell cell(const Table& table, std::size_t row, const std::string& key) {
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (table.columns[i].key == key) return table.rows.at(row).at(i);
    ADD_FAILURE() << "no column " << key;
    return {};
}

TEST(BenchPlan, HoldsTheStandardShadowsAgainstNoneWhereNothingIsSaid) {
    const BenchPlan plan = planned({"lite", "pro"}, {});
    EXPECT_EQ(plan.axes.back().values, (std::vector<std::string>{"off", textOf(*findSetting("shadows"), {})}));
    EXPECT_EQ(plan.entries.size(), 12U) << "two scenes, three depths";
}

TEST(BenchPlan, TakesAllShadowModelsFromTheSettingsTable) {
    const BenchPlan plan = planned({"lite"}, {{"depth", "1"}, {"shadows", "all"}});
    const auto& names = std::get<ChoiceType>(findSetting("shadows")->type).names;
    EXPECT_TRUE(std::equal(names.begin(), names.end(), plan.axes.back().values.begin(), plan.axes.back().values.end()));
    EXPECT_EQ(plan.entries.size(), names.size());
}

TEST(BenchPlan, CombinesTheValuesOfAnySettingEachOnce) {
    const BenchPlan plan =
        planned({"lite", "lite"}, {{"depth", "2,8,2"}, {"shadows", "off"}, {"glow", "on,true,off"}, {"eye", "1,2,3"}});
    ASSERT_EQ(plan.entries.size(), 4U);
    EXPECT_EQ(plan.axes.size(), 4U) << "size, glow, depth, shadows; the eye stays where it is";
    const Settings& last = plan.entries.back().settings;
    EXPECT_EQ(last.depth, 8);
    EXPECT_FALSE(last.glow);
    EXPECT_EQ(last.eye, glm::dvec3(1, 2, 3));
    EXPECT_EQ(last.shadows, ShadowModel::Off);
}

TEST(BenchPlan, TakesASettingByItsEarlierNamesToo) {
    const BenchPlan now =
                        planned({"lite"}, {{"cone-origin", "surface,light"}, {"variants", "off"}}, "cone-origin=light"),
                    then = planned({"lite"}, {{"direction", "a,b"}, {"parts", "off"}}, "direction=b");
    EXPECT_EQ(optionsOf(then, Values{{"direction", "a,b"}, {"parts", "off"}}),
              optionsOf(now, Values{{"cone-origin", "surface,light"}, {"variants", "off"}}));
    EXPECT_EQ(then.baselines, now.baselines);
    for (std::size_t i = 0; i < now.entries.size(); ++i) EXPECT_EQ(then.entries[i].settings, now.entries[i].settings);
}

TEST(BenchPlan, MakesTheSameAgainFromItsOptions) {
    const Values values{
        {"accel", "all"}, {"depth", "3"}, {"time", "0.5"}, {"size", "64x48,32x24"}, {"shadows", "hard"}};
    EXPECT_EQ(optionsOf(planned({"lite"}, values), values),
              " --depth=3 --shadows=hard --time=0.5 --size=64x48,32x24 --accel=auto,none,hierarchy");
}

TEST(BenchPlan, DividesByTheFirstRowOfTheScene) {
    const BenchPlan plan = planned({"lite", "pro"}, {{"depth", "1,2"}, {"shadows", "off,hard"}});
    EXPECT_EQ(plan.baselines, (std::vector<std::size_t>{0, 0, 0, 0, 4, 4, 4, 4}));
}

TEST(BenchPlan, DividesByTheRowThatDiffersInTheBaselineOnly) {
    const Values values{{"depth", "1,2"}, {"shadows", "off,hard"}};
    EXPECT_EQ(planned({"lite", "pro"}, values, "shadows=hard").baselines,
              (std::vector<std::size_t>{1, 1, 3, 3, 5, 5, 7, 7}));
    EXPECT_EQ(planned({"lite", "pro"}, values, "scene=pro,depth=2").baselines,
              (std::vector<std::size_t>{6, 7, 6, 7, 6, 7, 6, 7}));
}

TEST(BenchPlan, RefusesWhatItCannotDrawWithTheRemedy) {
    EXPECT_NE(refusal({{"depth", "1,9"}}).find("depth: 9 is out of range; use 1…8"), std::string::npos);
    EXPECT_NE(refusal({{"shadows", "off,haard"}}).find("did you mean 'hard'?"), std::string::npos);
    EXPECT_NE(refusal({{"depth", "1,2"}}, "depth=3").find("depth is never '3' here; add it to --depth"),
              std::string::npos);
    EXPECT_NE(refusal({}, "glow=on").find("'glow' does not vary here; use scene, size, depth, shadows"),
              std::string::npos);
    EXPECT_NE(refusal({}, "hard").find("write it as --baseline=shadows=off"), std::string::npos);
    EXPECT_NE(refusal({{"color-mode", "all"},
                       {"depth", "1,2,3,4,5,6,7,8"},
                       {"glow", "on,off"},
                       {"accel", "all"},
                       {"data", "all"}})
                  .find("more than 2000 rows"),
              std::string::npos);
}

TEST(BenchPlan, RefusesSettingsThatNoMeasuredFrameDependsOn) {
    EXPECT_NE(refusal({{"shadow", "off"}}).find("there is no setting 'shadow'; did you mean 'shadows'?"),
              std::string::npos);
    EXPECT_NE(refusal({{"pause", "on"}}).find("pause: no frame that is drawn for measuring depends on it"),
              std::string::npos);
    Problems problems;
    planBench({}, {}, "", problems);
    EXPECT_EQ(toString(problems), "command line: scenes: there is none; name at least one\n");
}

TEST(BenchPlan, SaysWhereSettingsWereGivenAndWritesThemAsThere) {
    Problems problems;
    const Values values{{"depth", "1,2"}};
    planBench({"lite"}, values, "depth=3", problems, "compare");
    EXPECT_EQ(toString(problems),
              "compare: baseline: depth is never '3' here; add it to depth, or choose one of its values\n");
}

TEST(BenchPlan, TellsEachRowInWords) {
    const BenchPlan plan = planned({"pro"}, {{"depth", "1"}, {"shadows", "hard"}, {"glow", "on,off"}, {"size", "8x8"}});
    EXPECT_EQ(toString(plan, plan.entries.back()), "pro, size 8x8, glow off, depth 1, shadows hard");
}

BenchCost cost(std::vector<double> seconds) {
    BenchCost cost;
    cost.drawn = true;
    cost.cpu = cost.calibrated = cost.wall = std::move(seconds);
    cost.program.sourceBytes = 7;
    return cost;
}

TEST(BenchSeries, ComeBackToTheLastBitFromTheirText) {
    BenchCost some = cost({0.1, 1.0 / 3.0, 2e-9});
    some.cpu.clear();
    some.passes = 2;
    some.firstSeconds = 0.7;
    some.program.compileMs = 1e3 / 7;
    const std::string text = seriesText({some, BenchCost{}});
    const std::vector<BenchCost> read = readSeries(text);
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].wall, some.wall);
    EXPECT_EQ(read[0].calibrated, some.calibrated);
    EXPECT_TRUE(read[0].cpu.empty());
    EXPECT_EQ(read[0].passes, 2);
    EXPECT_EQ(read[0].program.compileMs, some.program.compileMs);
    EXPECT_TRUE(read[0].drawn);
    EXPECT_FALSE(read[1].drawn);
    EXPECT_EQ(seriesText(read), text);
}

TEST(BenchSeries, AreNoneWhereTheTextIsAnother) {
    for (const char* text :
         {"", "x", "1 2 three\n", "1 1 7 0 0 0 99999 0\n", "1 1 7 0 0 0 -1 0 0 0\n", "1 1 7 0 0 0 0 0 0"})
        EXPECT_TRUE(readSeries(text).empty()) << text;
}

// The machine slows down from round to round: times say little, ratios of the same round are exact.
TEST(BenchTables, ShowMediansAndTheRatioRoundByRound) {
    const BenchPlan plan = planned({"lite"}, {{"depth", "1"}, {"shadows", "off,hard"}});
    const Table table = benchTable(plan, {{"osmesa", {}, {cost({0.01, 0.02, 0.04}), cost({0.03, 0.06, 0.12})}, 3}});
    ASSERT_EQ(table.rows.size(), 2U);
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    EXPECT_EQ(cell(table, 0, "frame"), Cell(20.0));
    EXPECT_EQ(cell(table, 0, "frame_low"), Cell(15.0));
    EXPECT_EQ(cell(table, 0, "frame_high"), Cell(30.0));
    EXPECT_EQ(cell(table, 0, "fps"), Cell(50.0));
    for (const char* key : {"ratio", "ratio_low", "ratio_high"})
        EXPECT_NEAR(std::get<double>(cell(table, 1, key)), 3, 1e-12) << key;
    EXPECT_EQ(cell(table, 1, "rounds"), Cell(3.0));
    EXPECT_EQ(table.keys, 5);
}

TEST(BenchTables, KeepWhatWasCompiledBeforeTheFirstRoundAndLeaveOutWhatCouldNotBeDrawn) {
    const BenchPlan plan = planned({"lite"}, {{"depth", "1"}, {"shadows", "off,hard"}});
    const Table table = benchTable(plan, {{"osmesa", {}, {BenchCost{}, cost({})}, 0}});
    ASSERT_EQ(table.rows.size(), 1U);
    EXPECT_EQ(cell(table, 0, "shadows"), Cell("hard"));
    for (const char* key : {"fps", "frame", "frame_low", "ratio"}) EXPECT_EQ(cell(table, 0, key), Cell{}) << key;
    EXPECT_EQ(cell(table, 0, "source"), Cell(7.0));
}

TEST(BenchTables, LeaveTheCpuOpenWhereTheHostCannotTell) {
    const BenchPlan plan = planned({"lite"}, {{"depth", "1"}, {"shadows", "off"}});
    BenchCost known = cost({0.01, 0.02, 0.04});
    known.cpu.clear();
    const Table table = benchTable(plan, {{"webgl2-firefox", {}, {known}, 3}});
    for (const char* key : {"cpu", "cpu_low", "cpu_high"}) EXPECT_EQ(cell(table, 0, key), Cell{}) << key;
    EXPECT_EQ(cell(table, 0, "frame"), Cell(20.0));
}

TEST(BenchTables, NameTheContextOfWhatDiffersBetweenThem) {
    const Environment merged =
        mergedEnvironment({{"osmesa", {{"context", "osmesa"}, {"gl", "4.5"}, {"system", "x"}}, {}, 0},
                           {"egl", {{"context", "egl"}, {"gl", "ES 3.2"}, {"system", "x"}}, {}, 0}});
    EXPECT_EQ(merged, (Environment{{"context", "osmesa; egl"}, {"gl", "osmesa: 4.5; egl: ES 3.2"}, {"system", "x"}}));
}

// Every chart draws columns that the table has, and each of them some of its rows.
TEST(BenchTables, ChartFpsOverDepthForAllElseThatVaries) {
    const BenchPlan plan = planned({"lite"}, {{"size", "8x8,4x4"}, {"glow", "on,off"}, {"shadows", "off,hard"}});
    const std::vector<std::string> contexts{"osmesa", "egl"};
    const Table table = benchTable(plan, {});
    const auto charts = benchCharts(plan, contexts);
    EXPECT_EQ(charts.size(), 8U) << "two contexts, sizes and glows";
    for (const Chart& chart : charts) {
        EXPECT_EQ(chart.where.size(), 3U);
        std::vector<std::string> used{chart.x, chart.series, chart.facet, chart.y.front().first};
        for (const auto& [column, value] : chart.where) used.push_back(column);
        for (const std::string& key : used)
            EXPECT_TRUE(std::any_of(table.columns.begin(), table.columns.end(), [&](const Column& column) {
                return column.key == key;
            })) << key;
    }
    EXPECT_EQ(benchCharts(planned({"lite"}, {{"depth", "4"}}), {"osmesa"}).front().x, "shadows") << "bars";
}

} // namespace
} // namespace gnomon
