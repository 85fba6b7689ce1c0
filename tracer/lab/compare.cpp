#include "tracer/lab/compare.h"

#include "tracer/lab/quartiles.h"

#include <algorithm>
#include <map>

namespace gnomon {
namespace {

constexpr std::string_view kFaster = "faster", kSlower = "slower", kSame = "the same within noise";

std::optional<std::size_t> columnOf(const Table& table, const std::string& key) {
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (table.columns[i].key == key) return i;
    return std::nullopt;
}

/// Key columns of both, as places in each.
struct Keys {
    std::vector<std::size_t> before, after;
};

Keys commonKeys(const Table& before, const Table& after) {
    Keys keys;
    for (std::size_t i = 0; i < std::size_t(after.keys); ++i) {
        const auto at = columnOf(before, after.columns[i].key);
        if (!at || *at >= std::size_t(before.keys)) continue;
        keys.before.push_back(*at);
        keys.after.push_back(i);
    }
    return keys;
}

std::string nameOf(const std::vector<Cell>& row, const std::vector<std::size_t>& keys) {
    std::string name;
    for (const std::size_t key : keys) name += (name.empty() ? "" : ", ") + shown(row[key]);
    return name;
}

/// Rows by name. A problem where two have one name.
std::map<std::string, std::size_t> rowsByName(const Table& table, const std::vector<std::size_t>& keys,
                                              Problems& problems) {
    std::map<std::string, std::size_t> rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const std::string name = nameOf(table.rows[i], keys);
        if (rows.emplace(name, i).second) continue;
        problems.push_back({{},
                            0,
                            "table " + inQuotes(table.name),
                            "several rows are " + inQuotes(name),
                            "compare runs that vary the same settings"});
        return {};
    }
    return rows;
}

struct Pair {
    const std::vector<Cell>*before, *after;
};

/// Rows of both runs, in the order of the later one.
std::vector<Pair> matchRows(const Table& before, const Table& after, const Keys& keys, Problems& problems) {
    const std::size_t known = problems.size();
    const auto old = rowsByName(before, keys.before, problems);
    rowsByName(after, keys.after, problems);
    std::vector<Pair> pairs;
    if (problems.size() > known) return pairs;
    for (const auto& row : after.rows)
        if (const auto found = old.find(nameOf(row, keys.after)); found != old.end())
            pairs.push_back({&before.rows[found->second], &row});
    return pairs;
}

/// A column of times, where it is in one table.
struct Timed {
    std::size_t median;
    QuartileColumns quartiles;
    std::optional<std::size_t> rounds;

    std::optional<Quartiles> of(const std::vector<Cell>& row) const {
        const double *low = std::get_if<double>(&row[quartiles.low]), *middle = std::get_if<double>(&row[median]),
                     *high = std::get_if<double>(&row[quartiles.high]);
        return low && middle && high && *middle > 0 ? std::optional(Quartiles{*low, *middle, *high}) : std::nullopt;
    }
    double roundsOf(const std::vector<Cell>& row) const {
        const double* count = rounds ? std::get_if<double>(&row[*rounds]) : nullptr;
        return count ? *count : 1;
    }
};

std::optional<Timed> timed(const Table& table, const std::string& key, std::string_view unit) {
    const auto at = columnOf(table, key);
    if (!at || table.columns[*at].unit != unit) return std::nullopt;
    const auto quartiles = quartileColumns(table, *at);
    const auto passes = columnOf(table, "passes");
    return quartiles ? std::optional(Timed{*at, *quartiles, passes ? passes : columnOf(table, "rounds")})
                     : std::nullopt;
}

/// The same column in both runs.
struct TimedTwice {
    Timed before, after;

    std::optional<Ratio> ratio(const Pair& pair) const {
        const auto was = before.of(*pair.before), is = after.of(*pair.after);
        if (!was || !is) return std::nullopt;
        return ratioOfMedians(*is, after.roundsOf(*pair.after), *was, before.roundsOf(*pair.before));
    }
};

std::optional<TimedTwice> timedTwice(const Table& before, const Table& after, const std::string& key,
                                     std::string_view unit) {
    const auto old = timed(before, key, unit), now = timed(after, key, unit);
    return old && now ? std::optional(TimedTwice{*old, *now}) : std::nullopt;
}

/// What is compared of two tables: times to be shown, and those whose ratio counts.
struct Measured {
    Column column;
    TimedTwice shown, counted;
};

std::vector<Measured> measuredIn(const Table& before, const Table& after) {
    std::vector<Measured> byTime, byYards;
    for (const Column& column : after.columns) {
        const auto time = timedTwice(before, after, column.key, "ms");
        if (!time) continue;
        byTime.push_back({column, *time, *time});
        if (const auto yards = timedTwice(before, after, column.key + "_yards", "yardsticks"))
            byYards.push_back({column, *time, *yards});
    }
    return byYards.empty() ? byTime : byYards;
}

void appendColumns(const std::string& key, const std::string& unit, const std::string& help, const char* spread,
                   Table& table) {
    table.columns.push_back({key, key, unit, help});
    table.columns.push_back({key + "_low", key + ", low", unit, spread});
    table.columns.push_back({key + "_high", key + ", high", unit, spread});
}

Table emptyTable(const Table& after, const Column& measured, const Keys& keys) {
    Table table{after.name + "_" + measured.key, after.title + ": " + measured.title, {}, {}};
    for (const std::size_t key : keys.after) table.columns.push_back(after.columns[key]);
    table.keys = int(keys.after.size());
    appendColumns("old", measured.unit, "Median", "Quartile of the rounds", table);
    appendColumns("new", measured.unit, "Median", "Quartile of the rounds", table);
    appendColumns("ratio", "old = 1",
                  "Of the medians in yardsticks, where both runs have them, and what noise leaves it",
                  "End of the interval that noise leaves the ratio", table);
    table.columns.push_back(
        {"verdict", "new is", "", "faster or slower where neither noise nor tolerance explains it"});
    return table;
}

std::string verdictOf(const Ratio& ratio, double tolerance) {
    if (ratio.high < 1 && ratio.value < 1 - tolerance) return std::string(kFaster);
    return std::string(ratio.low > 1 && ratio.value > 1 + tolerance ? kSlower : kSame);
}

Table compareColumn(const Table& after, const Measured& measured, const std::vector<Pair>& pairs, const Keys& keys,
                    double tolerance) {
    Table table = emptyTable(after, measured.column, keys);
    for (const Pair& pair : pairs) {
        const auto was = measured.shown.before.of(*pair.before), is = measured.shown.after.of(*pair.after);
        const auto ratio = measured.counted.ratio(pair);
        if (!was || !is || !ratio) continue;
        std::vector<Cell> row;
        for (const std::size_t key : keys.after) row.push_back((*pair.after)[key]);
        for (const double value :
             {was->median, was->low, was->high, is->median, is->low, is->high, ratio->value, ratio->low, ratio->high})
            row.emplace_back(value);
        row.emplace_back(verdictOf(*ratio, tolerance));
        table.rows.push_back(std::move(row));
    }
    return table;
}

Environment difference(const Environment& before, const Environment& after) {
    Environment all;
    for (const auto& now : after) {
        const auto old =
            std::find_if(before.begin(), before.end(), [&](const auto& entry) { return entry.first == now.first; });
        const bool same = old == before.end() || old->second == now.second;
        all.emplace_back(now.first, same ? now.second : old->second + " → " + now.second);
    }
    return all;
}

void tellMissing(const char* which, const Table& table, std::size_t matched, Environment& environment) {
    if (const std::size_t missing = table.rows.size() - matched; missing > 0)
        environment.emplace_back(std::string("rows only in ") + which, std::to_string(missing) + " of " + table.name);
}

} // namespace

Results compareRuns(const Results& before, const Results& after, double tolerance, Problems& problems) {
    Results all{after.title + ": new against old", {}, difference(before.environment, after.environment), {}, {}};
    for (const Table& now : after.tables) {
        const auto was = std::find_if(before.tables.begin(), before.tables.end(),
                                      [&](const Table& table) { return table.name == now.name; });
        if (was == before.tables.end()) continue;
        const Keys keys = commonKeys(*was, now);
        if (keys.after.empty()) continue;
        const std::vector<Pair> pairs = matchRows(*was, now, keys, problems);
        if (!problems.empty()) return all;
        tellMissing("old", *was, pairs.size(), all.environment);
        tellMissing("new", now, pairs.size(), all.environment);
        for (const Measured& measured : measuredIn(*was, now)) {
            Table table = compareColumn(now, measured, pairs, keys, tolerance);
            if (!table.rows.empty()) all.tables.push_back(std::move(table));
        }
    }
    if (all.tables.empty())
        problems.push_back({{},
                            0,
                            {},
                            "the two runs have no row of times in common",
                            "give two files of `gnomon bench --json=FILE` with the same scenes and settings"});
    return all;
}

std::string comparisonSummary(const Results& comparison) {
    std::string text;
    for (const Table& table : comparison.tables) {
        std::string counts;
        for (const std::string_view word : {kFaster, kSlower, kSame}) {
            const auto count = std::count_if(table.rows.begin(), table.rows.end(),
                                             [&](const auto& row) { return row.back() == Cell(std::string(word)); });
            counts += (counts.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(word);
        }
        text += table.title + ": " + counts + "\n";
    }
    return text;
}

} // namespace gnomon
