/// Results of a few rows, for what reads and compares them, and comparisons of them.
#pragma once

#include "lab/results/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace gnomon::test {

/// Rows of scene, depth and a frame with quartiles, and over the calibration workload.
inline Table runTable(const std::vector<std::vector<Cell>>& rows) {
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
inline std::vector<Cell> row(const std::string& scene, double depth, double frame, double calibrated) {
    return {scene, depth, frame, frame, frame, calibrated, 0.99 * calibrated, 1.01 * calibrated, 1.0, 1.0, 1.0, 4.0};
}
inline Results run(const std::vector<std::vector<Cell>>& rows) {
    return {"T", "c", {{"gl", "4.5"}}, {runTable(rows)}, {}};
}

inline Results compared(const Results& before, const Results& after) {
    Problems problems;
    Results all = compareRuns(before, after, 0.05, problems);
    EXPECT_TRUE(problems.empty()) << toString(problems);
    return all;
}

/// The only table of that name.
inline const Table& named(const Results& results, const std::string& name) {
    const auto found = std::find_if(results.tables.begin(), results.tables.end(),
                                    [&](const Table& table) { return table.name == name; });
    EXPECT_NE(found, results.tables.end()) << "no table " << name;
    static const Table none;
    return found == results.tables.end() ? none : *found;
}

} // namespace gnomon::test
