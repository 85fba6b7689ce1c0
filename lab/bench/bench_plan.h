/// What `gnomon bench` and the page's compare() draw: every combination of scenes and values of settings. No GL.
#pragma once

#include "tracer/problem.h"
#include "tracer/settings/settings.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gnomon {

/// A setting and the values it takes, as textOf() writes them.
struct Axis {
    const SettingRow* setting;
    std::vector<std::string> values;
};

/// One of them drawn: a scene with settings.
struct BenchEntry {
    std::size_t scene = 0;           ///< as counted in BenchPlan::scenes
    std::vector<std::string> values; ///< one of each axis
    Settings settings;
};

struct BenchPlan {
    std::vector<std::string> scenes;
    std::vector<Axis> axes; ///< size, what else has several values, depth, shadows; the last one varies fastest
    std::vector<BenchEntry> entries;
    std::vector<std::size_t> baselines; ///< of each entry, the one that its ratio is told by
    std::string baselineText;           ///< for people
};

/// Whether a setting says anything about a frame that is drawn for measuring.
bool isBenchSetting(const SettingRow&);
/// Whether a comma parts values of the setting: in a point it does not.
bool takesList(const SettingRow&);

/// `values` are options as they were typed: lists with commas, `all` for every value of a setting that has names.
/// `baseline` is empty, or `KEY=VALUE,…`: each entry is then told by the one that differs from it in these only. Every
/// wrong one is a problem; `source` is where they were given.
BenchPlan planBench(const std::vector<std::string>& scenes, std::span<const std::pair<std::string, std::string>> values,
                    const std::string& baseline, Problems&, std::string_view source = "command line");

/// All that was asked for and what stood in for the rest, in the order of the table: makes the same plan again.
std::vector<std::pair<std::string, std::string>> valuesOf(const BenchPlan&,
                                                          std::span<const std::pair<std::string, std::string>> values);
/// The same as ` --KEY=VALUE,…`.
std::string optionsOf(const BenchPlan&, std::span<const std::pair<std::string, std::string>> values);
/// What is drawn, for people: `pro, size 800x600, depth 4, shadows hard`.
std::string toString(const BenchPlan&, const BenchEntry&);

} // namespace gnomon
