#include "lab/results/results.h"
#include "tracer/printable.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;

Json jsonOf(const Cell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    const auto* number = std::get_if<double>(&cell);
    if (!number) return nullptr;
    return std::isfinite(*number) ? Json(*number) : Json(shown(cell));
}

Json jsonOf(const Column& column) {
    Json all{{"key", column.key}, {"title", column.title}, {"unit", column.unit}, {"help", column.help}};
    if (column.kind != Kind::None) all["kind"] = nameOf(column.kind);
    if (column.better != Better::Untold) all["better"] = nameOf(column.better);
    return all;
}

Json jsonOf(const std::vector<Cell>& row) {
    Json cells = Json::array();
    for (const Cell& cell : row) cells.push_back(jsonOf(cell));
    return cells;
}

Json jsonOf(const Table& table) {
    Json columns = Json::array(), rows = Json::array();
    for (const Column& column : table.columns) columns.push_back(jsonOf(column));
    for (const auto& row : table.rows) rows.push_back(jsonOf(row));
    Json all{{"name", table.name}, {"title", table.title}};
    if (table.keys > 0) all["keys"] = table.keys;
    all["columns"] = std::move(columns);
    all["rows"] = std::move(rows);
    return all;
}

Json jsonOf(const Chart& chart) {
    Json where = Json::object(), y = Json::array();
    for (const auto& [key, label] : chart.y) y.push_back({{"column", key}, {"label", label}});
    for (const auto& [key, value] : chart.where) where[key] = value;
    Json all{{"title", chart.title},   {"table", chart.table}, {"x", chart.x},   {"y", y},
             {"series", chart.series}, {"facet", chart.facet}, {"where", where}, {"log_x", chart.logX},
             {"log_y", chart.logY}};
    if (!chart.front.empty()) all["front"] = chart.front;
    return all;
}

Json jsonOf(const Picture& picture) {
    Json all{
        {"title", picture.title}, {"table", picture.table}, {"row", jsonOf(picture.row)}, {"image", picture.image}};
    if (picture.reference) all["reference"] = {{"image", *picture.reference}, {"title", picture.referenceTitle}};
    return all;
}

/// Three digits, but never fewer than there are before the point.
std::string brief(const Cell& cell) {
    const auto* number = std::get_if<double>(&cell);
    if (!number || !std::isfinite(*number)) return shown(cell);
    const double size = std::abs(*number);
    const bool whole = *number == std::floor(*number) || (size >= 100 && size < 1e9);
    const bool middling = size >= 1 && size < 1e9;
    char digits[40];
    if (middling)
        std::snprintf(digits, sizeof digits, "%.*f", whole ? 0 : size >= 10 ? 1 : 2, *number);
    else
        std::snprintf(digits, sizeof digits, whole ? "%.0f" : "%.3g", *number);
    return digits;
}

std::size_t widthOf(const std::string& utf8) {
    return std::size_t(std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Heading, rule and cells of a column, all of one width; numbers to the right.
std::vector<std::string> markdownColumn(const Table& table, std::size_t at) {
    const Column& column = table.columns[at];
    const auto quartiles = quartileColumns(table, at);
    std::vector<std::string> lines{printable(column.title + (column.unit.empty() ? "" : ", " + column.unit)), ""};
    bool words = true;
    for (const auto& row : table.rows) {
        const bool known = !std::holds_alternative<std::monostate>(row[at]);
        words = words && (!known || std::holds_alternative<std::string>(row[at]));
        std::string text = printable(brief(row[at]));
        if (quartiles && known) text += " (" + brief(row[quartiles->low]) + "…" + brief(row[quartiles->high]) + ")";
        lines.push_back(std::move(text));
    }
    std::size_t width = 3;
    for (const std::string& line : lines) width = std::max(width, widthOf(line));
    for (std::string& line : lines) line.insert(words ? line.size() : 0, width - widthOf(line), ' ');
    lines[1] = std::string(width - !words, '-') + (words ? "" : ":");
    return lines;
}

} // namespace

std::string_view nameOf(Kind kind) {
    constexpr std::array<std::string_view, 5> kNames{"", "time", "ratio", "error", "count"};
    return kNames[std::size_t(kind)];
}

std::string_view nameOf(Better better) {
    constexpr std::array<std::string_view, 3> kNames{"", "lower", "higher"};
    return kNames[std::size_t(better)];
}

std::string toJson(const Results& results) {
    Json environment = Json::object(), tables = Json::array(), charts = Json::array(), pictures = Json::array();
    for (const auto& [name, value] : results.environment) environment[name] = value;
    for (const Table& table : results.tables) tables.push_back(jsonOf(table));
    for (const Chart& chart : results.charts) charts.push_back(jsonOf(chart));
    for (const Picture& picture : results.pictures) pictures.push_back(jsonOf(picture));
    Json all{{"format", "gnomon-results"}, {"version", kVersion},        {"title", results.title},
             {"command", results.command}, {"environment", environment}, {"tables", std::move(tables)},
             {"charts", std::move(charts)}};
    if (!pictures.empty()) {
        all["images"] = results.images;
        all["pictures"] = std::move(pictures);
    }
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<QuartileColumns> quartileColumns(const Table& table, std::size_t column) {
    const auto find = [&](const std::string& key) {
        const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                        [&](const Column& other) { return other.key == key; });
        return std::size_t(found - table.columns.begin());
    };
    const std::string& key = table.columns[column].key;
    const QuartileColumns at{find(key + "_low"), find(key + "_high")};
    return std::max(at.low, at.high) < table.columns.size() ? std::optional(at) : std::nullopt;
}

std::string toMarkdown(const Table& table) {
    std::vector<bool> quartiles(table.columns.size());
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (const auto at = quartileColumns(table, i)) quartiles[at->low] = quartiles[at->high] = true;
    std::vector<std::vector<std::string>> columns;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (!quartiles[i]) columns.push_back(markdownColumn(table, i));
    std::string text;
    for (std::size_t line = 0; line < table.rows.size() + 2; ++line) {
        for (const auto& column : columns) text += "| " + column[line] + " ";
        text += "|\n";
    }
    return text;
}

std::string shown(const Cell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    const auto* number = std::get_if<double>(&cell);
    if (!number) return "–";
    char text[40];
    const bool whole = *number == std::floor(*number) && std::abs(*number) < 1e7;
    std::snprintf(text, sizeof text, whole ? "%.0f" : "%.4g", *number);
    return text;
}

} // namespace gnomon
