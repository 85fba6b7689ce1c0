#include "lab/results/compare.h"

#include "lab/results/match_rows.h"
#include "lab/results/quartiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace gnomon {
namespace {

/// What became of a number.
enum class Verdict { Improved, Worsened, Same };
using Words = std::array<std::string_view, 3>; // as Verdict
constexpr Words kTimeWords{"faster", "slower", "the same within noise"}, kErrorWords{"better", "worse", "the same"},
    kCountWords{"less", "more", "the same"}; // where neither is better

std::string_view wordFor(const Column& column, Verdict verdict) {
    const bool time = column.kind == Kind::Time || column.kind == Kind::Ratio;
    const bool judged = column.kind == Kind::Error || column.better != Better::Untold;
    return (time ? kTimeWords : judged ? kErrorWords : kCountWords)[std::size_t(verdict)];
}

/// 1 where it is not told.
double countOf(const std::vector<Cell>& row, std::optional<std::size_t> column) {
    const double* count = column ? std::get_if<double>(&row[*column]) : nullptr;
    return count ? *count : 1;
}

/// A column of times, where it is in one table.
struct Timed {
    std::size_t median;
    QuartileColumns quartiles;
    std::optional<std::size_t> rounds, passes;

    std::optional<Spread> of(const std::vector<Cell>& row) const {
        const double *low = std::get_if<double>(&row[quartiles.low]), *middle = std::get_if<double>(&row[median]),
                     *high = std::get_if<double>(&row[quartiles.high]);
        if (!low || !middle || !high || *middle <= 0) return std::nullopt;
        return Spread{{*low, *middle, *high}, countOf(row, passes ? passes : rounds)};
    }
};

std::optional<Timed> timed(const Table& table, const std::string& key) {
    const auto at = columnOf(table, key);
    if (!at) return std::nullopt;
    const auto quartiles = quartileColumns(table, *at);
    return quartiles ? std::optional(Timed{*at, *quartiles, columnOf(table, "rounds"), columnOf(table, "passes")})
                     : std::nullopt;
}

/// The same column in both runs.
struct TimedTwice {
    Timed before, after;

    /// What a row has of both.
    struct Spreads {
        Spread before, after;
    };
    std::optional<Spreads> of(const Pair& pair) const {
        const auto was = before.of(*pair.before), is = after.of(*pair.after);
        return was && is ? std::optional(Spreads{*was, *is}) : std::nullopt;
    }
};

std::optional<TimedTwice> timedTwice(const Table& before, const Table& after, const std::string& key) {
    const auto old = timed(before, key), now = timed(after, key);
    return old && now ? std::optional(TimedTwice{*old, *now}) : std::nullopt;
}

/// A column of both runs that says what it holds.
struct Compared {
    Column column;
    std::size_t before, after;
};

/// The later run's word for a column's kind counts.
std::vector<Compared> comparedIn(const Table& before, const Table& after, std::initializer_list<Kind> kinds) {
    std::vector<Compared> all;
    for (std::size_t i = 0; i < after.columns.size(); ++i) {
        const Column& column = after.columns[i];
        const auto old = columnOf(before, column.key);
        if (old && std::find(kinds.begin(), kinds.end(), column.kind) != kinds.end()) all.push_back({column, *old, i});
    }
    return all;
}

/// Times to be shown, and those whose ratio counts.
struct Measured {
    Column column;
    TimedTwice shown, counted;
};

std::vector<Measured> measuredIn(const Table& before, const Table& after) {
    std::vector<Measured> times, calibrated, ratios;
    for (const auto& [column, old, now] : comparedIn(before, after, {Kind::Time, Kind::Ratio})) {
        const auto time = timedTwice(before, after, column.key);
        if (!time) continue;
        (column.kind == Kind::Ratio ? ratios : times).push_back({column, *time, *time});
        if (const auto steady = timedTwice(before, after, column.key + "_calibrated"))
            calibrated.push_back({column, *time, *steady});
    }
    std::vector<Measured> all = calibrated.empty() ? times : calibrated;
    all.insert(all.end(), ratios.begin(), ratios.end());
    return all;
}

/// How many rows became what.
struct Tally {
    std::array<int, 3> rows{}; // as Verdict
    int& operator[](Verdict verdict) { return rows[std::size_t(verdict)]; }
};

Table summaryTable() {
    return {"changes",
            "What changed",
            {{"table", "table", "", ""},
             {"number", "number", "", "Column of the table"},
             {"kind", "kind", "", "time, ratio: noise; error: no noise; count: exact"},
             {"rows", "rows", "", "Compared"},
             {"improved", "better", "", "Faster, nearer to what is right, or less"},
             {"worsened", "worse", "", "Slower, farther from what is right, or more"},
             {"same", "the same", "", "Within noise or tolerance"}},
            {},
            2};
}

void addSummary(const Table& of, const Column& column, Tally tally, Table& summary) {
    const auto& [improved, worsened, same] = tally.rows;
    summary.rows.push_back({of.title, column.title, std::string(nameOf(column.kind)),
                            double(improved + worsened + same), double(improved), double(worsened), double(same)});
}

// --- times -----------------------------------------------------------------------------------------------------------

void appendColumns(const std::string& key, const std::string& unit, const std::string& help, const char* spread,
                   Table& table) {
    table.columns.push_back({key, key, unit, help});
    table.columns.push_back({key + "_low", key + ", low", unit, spread});
    table.columns.push_back({key + "_high", key + ", high", unit, spread});
}

Table timeTable(const Twins& twins, const Column& measured) {
    Table table{twins.after.name + "_" + measured.key,
                twins.after.title + ": " + measured.title,
                twins.keyColumns(),
                {},
                int(twins.keys.after.size())};
    appendColumns("old", measured.unit, "Median", "Quartile of the rounds", table);
    appendColumns("new", measured.unit, "Median", "Quartile of the rounds", table);
    appendColumns("ratio", "old = 1",
                  "Of the medians over the calibration workload, where both runs have them, and what noise leaves it: "
                  "the intervals of "
                  "all rows hold together with 95 %",
                  "End of the interval that noise leaves the ratio", table);
    table.columns.push_back({"verdict", "new is", "",
                             "faster or slower where neither noise nor tolerance explains it: of one program twice, in "
                             "one of twenty such tables at most"});
    return table;
}

Verdict verdictOf(const Ratio& ratio, Better better, double tolerance) {
    const bool less = ratio.high < 1 && ratio.value<1 - tolerance, more = ratio.low> 1 && ratio.value > 1 + tolerance;
    if (!less && !more) return Verdict::Same;
    return less == (better != Better::Higher) ? Verdict::Improved : Verdict::Worsened;
}

Table compareTimes(const Twins& twins, const Measured& measured, double tolerance, Tally& tally) {
    struct Row {
        const Pair& pair;
        TimedTwice::Spreads shown, counted;
    };
    std::vector<Row> rows; // all of them, for an interval's width depends on how many there are
    for (const Pair& pair : twins.pairs)
        if (const auto shown = measured.shown.of(pair), counted = measured.counted.of(pair); shown && counted)
            rows.push_back({pair, *shown, *counted});
    Table table = timeTable(twins, measured.column);
    for (const Row& row : rows) {
        const Ratio ratio = ratioOfMedians(row.counted.after, row.counted.before, rows.size());
        const Verdict verdict = verdictOf(ratio, measured.column.better, tolerance);
        std::vector<Cell> cells = twins.keyCells(row.pair);
        const Quartiles &old = row.shown.before.quartiles, &now = row.shown.after.quartiles;
        for (const double value :
             {old.median, old.low, old.high, now.median, now.low, now.high, ratio.value, ratio.low, ratio.high})
            cells.emplace_back(value);
        cells.emplace_back(std::string(wordFor(measured.column, verdict)));
        table.rows.push_back(std::move(cells));
        ++tally[verdict];
    }
    return table;
}

// --- errors and counts -----------------------------------------------------------------------------------------------

/// A number that may be infinite, or none at all, which is as bad.
std::optional<double> numberIn(const Cell& cell) {
    if (const double* number = std::get_if<double>(&cell)) return *number;
    if (const auto* word = std::get_if<std::string>(&cell);
        word && (*word == "inf" || *word == "-inf" || *word == "nan"))
        return std::numeric_limits<double>::infinity();
    return std::nullopt;
}

Verdict verdictOf(double was, double is, const Column& column) {
    if (was == is) return Verdict::Same;
    if (column.kind == Kind::Count)
        return (is < was) == (column.better != Better::Higher) ? Verdict::Improved : Verdict::Worsened;
    const double before = std::abs(was), after = std::abs(is);
    const double most = std::max(before, after);
    if (std::isfinite(most) && std::abs(is - was) <= kErrorTolerance * most) return Verdict::Same;
    return after < before ? Verdict::Improved : Verdict::Worsened;
}

Table changedTable(const Twins& twins) {
    Table table{twins.after.name + "_changed",
                twins.after.title + ": errors and counts that changed",
                twins.keyColumns(),
                {},
                int(twins.keys.after.size()) + 1};
    table.columns.insert(table.columns.end(), {{"number", "number", "", "Column of the table"},
                                               {"unit", "unit", "", ""},
                                               {"kind", "kind", "", ""},
                                               {"old", "old", "", ""},
                                               {"new", "new", "", ""},
                                               {"ratio", "ratio", "old = 1", ""},
                                               {"verdict", "new is", "", ""}});
    return table;
}

Tally compareNumbers(const Twins& twins, const Compared& compared, Table& changed) {
    Tally tally;
    const Column& column = compared.column;
    for (const Pair& pair : twins.pairs) {
        const auto was = numberIn((*pair.before)[compared.before]), is = numberIn((*pair.after)[compared.after]);
        if (!was || !is) continue;
        const Verdict verdict = verdictOf(*was, *is, column);
        ++tally[verdict];
        if (verdict == Verdict::Same) continue;
        std::vector<Cell> row = twins.keyCells(pair);
        row.insert(row.end(), {column.title, column.unit, std::string(nameOf(column.kind)), *was, *is,
                               *was == 0 ? Cell{} : Cell(*is / *was), std::string(wordFor(column, verdict))});
        changed.rows.push_back(std::move(row));
    }
    return tally;
}

// --- what only one run has -------------------------------------------------------------------------------------------

void addMissing(const char* run, const Table& table, const std::vector<std::size_t>& keys, const Table& other,
                const std::vector<std::size_t>& otherKeys, Table& missing) {
    Problems none; // both were told apart before
    const auto there = rowsByName(other, otherKeys, none);
    for (const auto& row : table.rows)
        if (const std::string name = nameOf(row, keys); !there.count(name))
            missing.rows.push_back({table.title, name, std::string(run)});
}

Table missingTable() {
    return {"missing",
            "Rows that only one run has",
            {{"table", "table", "", ""}, {"row", "row", "", "Its keys"}, {"run", "only in", "", ""}},
            {},
            2};
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

void compareTables(const Twins& twins, double tolerance, Table& summary, std::vector<Table>& tables) {
    for (const Measured& measured : measuredIn(twins.before, twins.after)) {
        Tally tally;
        Table table = compareTimes(twins, measured, tolerance, tally);
        if (table.rows.empty()) continue;
        addSummary(twins.after, measured.column, tally, summary);
        tables.push_back(std::move(table));
    }
    Table changed = changedTable(twins);
    for (const Compared& compared : comparedIn(twins.before, twins.after, {Kind::Error, Kind::Count}))
        if (const Tally tally = compareNumbers(twins, compared, changed); tally.rows != std::array<int, 3>{})
            addSummary(twins.after, compared.column, tally, summary);
    if (!changed.rows.empty()) tables.push_back(std::move(changed));
}

} // namespace

Results compareRuns(const Results& before, const Results& after, double tolerance, Problems& problems) {
    Results all{after.title + ": new against old", {}, difference(before.environment, after.environment), {}, {}};
    Table summary = summaryTable(), missing = missingTable();
    for (const Table& now : after.tables) {
        const auto was = std::find_if(before.tables.begin(), before.tables.end(),
                                      [&](const Table& table) { return table.name == now.name; });
        if (was == before.tables.end()) continue;
        const Keys keys = commonKeys(*was, now);
        if (keys.after.empty()) continue;
        const Twins twins{*was, now, keys, matchRows(*was, now, keys, problems)};
        if (!problems.empty()) return all;
        addMissing("old", *was, keys.before, now, keys.after, missing);
        addMissing("new", now, keys.after, *was, keys.before, missing);
        compareTables(twins, tolerance, summary, all.tables);
    }
    if (summary.rows.empty())
        problems.push_back({{},
                            0,
                            {},
                            "the two runs have no measured row in common",
                            "give two files that `gnomon bench` or one `gnomon lab` wrote with --json=FILE, with the "
                            "same scenes and settings"});
    all.tables.insert(all.tables.begin(), std::move(summary));
    if (!missing.rows.empty()) all.tables.push_back(std::move(missing));
    return all;
}

} // namespace gnomon
