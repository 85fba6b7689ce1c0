/// Two runs against each other: medians, noise, rows that belong together.
#include "lab/results/compare.h"
#include "lab/results/quartiles.h"
#include "tests/support/result_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace gnomon {
namespace {

using test::compared;
using test::named;
using test::row;
using test::run;

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

} // namespace
} // namespace gnomon
