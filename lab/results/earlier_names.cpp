#include "lab/results/earlier_names.h"

#include "tracer/settings/settings.h"

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

/// `text` with an end that was once called otherwise: `cone-linear 1/30 A`.
std::string withEnd(std::string text, std::span<const Renamed> ends) {
    for (const auto& [was, is] : ends)
        if (text.size() > was.size() && text.ends_with(was) && text[text.size() - was.size() - 1] == ' ')
            return text.replace(text.size() - was.size(), was.size(), is);
    return text;
}

constexpr std::array kOrigins{Renamed{"A", "surface"}, Renamed{"B", "light"}};
constexpr std::array kWays{Renamed{"parts", "variants"}};

/// What a column is called today, and how its words are.
struct Present {
    std::string key, title;
    std::span<const Renamed> words;
};

Present presentOf(const Table& table, const std::string& key) {
    const bool shadows = table.name == "shadows" || table.name == "variants"; // tables of `gnomon lab shadows`
    if (shadows && key == "direction") return {"cone_origin", "cone origin", kOrigins};
    if (key == "way") return {key, key, kWays};
    const bool intersect = table.name == "summary" || table.name == "intersect"; // of `gnomon lab intersect`
    if (intersect && key == "body") return {"shape", "shape", {}};
    if (intersect && key.starts_with("naive_")) return presentOf(table, "textbook_" + key.substr(6));
    if (intersect && key == "share") return {"wrong_decisions", key, {}};
    if (intersect && key == "textbook_share") return {"textbook_wrong_decisions", key, {}};
    constexpr std::string_view kYards = "frame_yards"; // and its quartiles, of `gnomon bench`
    if (key.starts_with(kYards)) return {"frame_calibrated" + key.substr(kYards.size()), key, {}};
    const SettingRow* setting = table.name == "bench" ? findSetting(key) : nullptr;
    const auto* choice = setting ? std::get_if<ChoiceType>(&setting->type) : nullptr;
    if (choice) return {std::string(setting->key), std::string(setting->key), choice->renamed};
    return {key, key, {}};
}

void bringUpToDate(Cell& cell, const Present& column) {
    auto* text = std::get_if<std::string>(&cell);
    if (!text) return;
    *text = renamed(*text, column.words);
    if (column.key == "way") *text = withEnd(*text, kOrigins);
}

void bringUpToDate(Chart& chart, const Table& table) {
    for (std::string* key : {&chart.x, &chart.series, &chart.facet, &chart.front}) *key = presentOf(table, *key).key;
    for (auto& [key, label] : chart.y) key = presentOf(table, key).key;
    for (auto& [key, value] : chart.where) {
        const Present column = presentOf(table, key);
        value = renamed(value, column.words);
        key = column.key;
    }
}

void bringUpToDate(Table& table) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        Column& column = table.columns[i];
        const Present present = presentOf(table, column.key);
        if (column.title == column.key) column.title = present.title;
        column.key = present.key;
        for (auto& row : table.rows) bringUpToDate(row[i], present);
    }
}

} // namespace

void bringUpToDate(Results& results) {
    const auto tableOf = [&](const std::string& name) {
        return std::find_if(results.tables.begin(), results.tables.end(),
                            [&](const Table& t) { return t.name == name; });
    };
    for (Chart& chart : results.charts)
        if (const auto table = tableOf(chart.table); table != results.tables.end()) bringUpToDate(chart, *table);
    for (Picture& picture : results.pictures)
        if (const auto table = tableOf(picture.table); table != results.tables.end())
            for (std::size_t i = 0; i < std::min(picture.row.size(), table->columns.size()); ++i)
                bringUpToDate(picture.row[i], presentOf(*table, table->columns[i].key));
    for (Table& table : results.tables) bringUpToDate(table); // last: charts and pictures are told by the earlier keys
}

} // namespace gnomon
