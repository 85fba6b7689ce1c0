/// What `gnomon lab trace` makes of its measurements: ratios round by round, growth, and the verdict on a choice.
#include "lab/trace/trace_tables.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

const TraceWay kSource{Accel::None, DataPath::Block, true}, kNone{Accel::None, DataPath::Block},
    kHierarchy{Accel::Hierarchy, DataPath::Block}, kAuto{Accel::Auto, DataPath::Block};

TraceCost cost(TraceWay way, std::vector<double> seconds, const std::string& search) {
    return {way, std::move(seconds), Work{1, 2, 3}, {}, search, {}};
}

/// The cell of a row in the column called `key`.
Cell cell(const Table& table, std::size_t row, const std::string& key) {
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (table.columns[i].key == key) return table.rows.at(row).at(i);
    ADD_FAILURE() << "no column " << key;
    return {};
}
double number(const Table& table, std::size_t row, const std::string& key) {
    return std::get<double>(cell(table, row, key));
}

ViewCosts view(double chosen) {
    ViewCosts costs{"a view",
                    {cost(kSource, {2, 4, 8}, "s"), cost(kNone, {1, 2, 4}, "loop"),
                     cost(kHierarchy, {0.5, 1, 2}, "boxes"), cost(kAuto, {chosen, 2 * chosen, 4 * chosen}, "mask")}};
    costs.ways[0].work.reset();
    return costs;
}

// The machine slows down from round to round; a median of times would say nothing, that of ratios is exact.
TEST(TraceTables, CompareWaysRoundByRound) {
    const Table table = viewTable({view(0.25)});
    ASSERT_EQ(table.rows.size(), 4U);
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    for (const char* key : {"ratio", "ratio_low", "ratio_high"}) EXPECT_EQ(number(table, 2, key), 0.5);
    EXPECT_EQ(number(table, 3, "speed_up"), 8);
    EXPECT_EQ(number(table, 2, "objects"), 2);
    EXPECT_EQ(cell(table, 0, "objects"), Cell{}) << "the source's way does not count";
}

TEST(TraceTables, FindQuartilesBetweenValues) {
    const Quartiles four = quartilesOf({4, 1, 3, 2});
    EXPECT_DOUBLE_EQ(four.low, 1.75);
    EXPECT_DOUBLE_EQ(four.median, 2.5);
    EXPECT_DOUBLE_EQ(four.high, 3.25);
}

TEST(TraceTables, CallAChoiceRightWithinFifteenPerCentOfTheBest) {
    const Table table = choiceTable({view(0.25), view(0.57), view(0.58)}, {});
    ASSERT_EQ(table.rows.size(), 3U);
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    EXPECT_EQ(cell(table, 0, "best"), Cell("auto"));
    EXPECT_EQ(cell(table, 1, "best"), Cell("hierarchy"));
    EXPECT_EQ(cell(table, 1, "right"), Cell("yes"));
    EXPECT_NEAR(number(table, 2, "ratio"), 1.16, 1e-9);
    EXPECT_EQ(cell(table, 2, "right"), Cell("no"));
}

TEST(TraceTables, HoldAChoiceOnlyAgainstOtherSearchesOfOurs) {
    ViewCosts costs = view(0.9);
    costs.ways[0].seconds = {0.1, 0.1, 0.1};
    costs.ways[2].search = "mask";
    EXPECT_EQ(cell(choiceTable({costs}, {}), 0, "best"), Cell("auto"))
        << "the source cannot be chosen, and the hierarchy came to the same program";
}

TEST(TraceTables, TellGrowthFromTheFewestSpheresOfTheSameKindAndWay) {
    const TraceWay loop{Accel::None, DataPath::Texture}, boxes{Accel::Hierarchy, DataPath::Texture};
    const std::vector<GrowthCosts> growth{
        {Arrangement::Random, 10, {{cost(loop, {1, 2}, ""), 1, 2}, {cost(boxes, {2, 4}, ""), 1, 2}}},
        {Arrangement::Random, 5000, {{cost(boxes, {6, 12}, ""), 1, 2}}},
        {Arrangement::Regular, 8, {{cost(boxes, {5, 5}, ""), 1, 2}}},
        {Arrangement::Regular, 4913, {{cost(boxes, {10, 10}, ""), 1, 2}}}};
    const Table table = growthTable(growth);
    ASSERT_EQ(table.rows.size(), 5U);
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    EXPECT_EQ(number(table, 1, "growth"), 1);
    EXPECT_EQ(number(table, 2, "growth"), 3);
    EXPECT_EQ(number(table, 4, "growth"), 2);
    EXPECT_EQ(growthSummary(growth), "random spheres, 10 to 5000: a frame takes 3.00 times as long (hierarchy)\n"
                                     "regular spheres, 8 to 4913: a frame takes 2.00 times as long (hierarchy)\n");
}

// Every chart draws columns that its table has.
TEST(TraceTables, ChartWhatTheyHold) {
    for (const Chart& chart : traceCharts()) {
        const Table table = chart.table == "scenes" ? viewTable({}) : growthTable({});
        EXPECT_EQ(table.name, chart.table);
        std::vector<std::string> used{chart.x, chart.series};
        if (!chart.facet.empty()) used.push_back(chart.facet);
        for (const auto& [column, label] : chart.y) used.push_back(column);
        for (const auto& [column, value] : chart.where) used.push_back(column);
        for (const std::string& key : used)
            EXPECT_TRUE(std::any_of(table.columns.begin(), table.columns.end(),
                                    [&](const Column& column) { return column.key == key; }))
                << chart.title << ": " << key;
    }
}

TEST(TraceTables, HoldEveryPictureAgainstThePlainLoop) {
    const auto image = [](std::uint8_t value) { return Image{1, 1, {value, value, value, 255}}; };
    ViewCosts drawn = view(0.25);
    for (TraceCost& way : drawn.ways) way.image = image(way.way.source ? 1 : 2);
    Results results{"", "", {}, {viewTable({drawn})}, {}};
    addTracePictures({drawn}, {}, results);
    ASSERT_EQ(results.pictures.size(), 4U);
    EXPECT_EQ(results.images.size(), 2U) << "all but the source's draw the same";
    EXPECT_EQ(results.pictures[0].referenceTitle, "none, block");
    EXPECT_NE(results.pictures[0].image, *results.pictures[0].reference);
    EXPECT_EQ(results.pictures[3].image, *results.pictures[3].reference);
    EXPECT_EQ(results.pictures[3].row, (std::vector<Cell>{"a view", "auto", "block"}));
}

} // namespace
} // namespace gnomon
