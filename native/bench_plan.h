/// What `gnomon bench` draws: every combination of scenes and values of settings. No GL.
#pragma once

#include "native/command_line.h"

#include <cstddef>
#include <span>
#include <string>
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
/// wrong one is a problem.
BenchPlan planBench(const std::vector<std::string>& scenes, std::span<const std::pair<std::string, std::string>> values,
                    const std::string& baseline, Problems&);

/// ` --KEY=VALUE,…` for all that was asked for: makes the same plan again.
std::string optionsOf(const BenchPlan&, std::span<const std::pair<std::string, std::string>> values);

} // namespace gnomon
