/// Results as JSON: what goes in comes out, and what JSON cannot say is said in words.

#include "lab/results/results.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace gnomon {
namespace {

TEST(Results, KeepEveryCell) {
    Results results{"A title", "gnomon lab x", {{"gl", "4.5"}}, {}, {}};
    results.tables = {{"t", "Table", {{"a", "A", "ms", "help"}, {"b", "B", "", ""}, {"c", "C", "", ""}}, {}}};
    results.tables[0].rows = {{0.1, std::string("w\"ord"), Cell{}},
                              {std::numeric_limits<double>::infinity(), 1e300, -0.5}};
    results.charts = {{"Chart", "t", "a", {{"c", "ours"}}, "b", "", {{"b", "x"}}, true, false}};
    const auto json = nlohmann::json::parse(toJson(results));
    EXPECT_EQ(json["version"], 1);
    EXPECT_EQ(json["environment"]["gl"], "4.5");
    const auto& rows = json["tables"][0]["rows"];
    EXPECT_EQ(rows[0][0], 0.1);
    EXPECT_EQ(rows[0][1], "w\"ord");
    EXPECT_TRUE(rows[0][2].is_null());
    EXPECT_EQ(rows[1][0], "inf");
    EXPECT_EQ(rows[1][1], 1e300);
    EXPECT_EQ(json["charts"][0]["y"][0]["label"], "ours");
    EXPECT_EQ(json["charts"][0]["where"]["b"], "x");
}

TEST(Results, ShowFourDigits) {
    EXPECT_EQ(shown(Cell(1234567.0)), "1234567");
    EXPECT_EQ(shown(Cell(0.123456)), "0.1235");
    EXPECT_EQ(shown(Cell(std::string("word"))), "word");
    EXPECT_EQ(shown(Cell{}), "–");
}

} // namespace
} // namespace gnomon
