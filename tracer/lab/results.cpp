#include "tracer/lab/results.h"

#include <nlohmann/json.hpp>

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

Json jsonOf(const Table& table) {
    Json columns = Json::array(), rows = Json::array();
    for (const Column& column : table.columns)
        columns.push_back({{"key", column.key}, {"title", column.title}, {"unit", column.unit}, {"help", column.help}});
    for (const auto& row : table.rows) {
        Json cells = Json::array();
        for (const Cell& cell : row) cells.push_back(jsonOf(cell));
        rows.push_back(std::move(cells));
    }
    return {{"name", table.name}, {"title", table.title}, {"columns", std::move(columns)}, {"rows", std::move(rows)}};
}

Json jsonOf(const Chart& chart) {
    Json where = Json::object(), y = Json::array();
    for (const auto& [key, label] : chart.y) y.push_back({{"column", key}, {"label", label}});
    for (const auto& [key, value] : chart.where) where[key] = value;
    return {{"title", chart.title},   {"table", chart.table}, {"x", chart.x},   {"y", y},
            {"series", chart.series}, {"facet", chart.facet}, {"where", where}, {"log_x", chart.logX},
            {"log_y", chart.logY}};
}

} // namespace

std::string toJson(const Results& results) {
    Json environment = Json::object(), tables = Json::array(), charts = Json::array();
    for (const auto& [name, value] : results.environment) environment[name] = value;
    for (const Table& table : results.tables) tables.push_back(jsonOf(table));
    for (const Chart& chart : results.charts) charts.push_back(jsonOf(chart));
    const Json all{{"format", "gnomon-results"}, {"version", kVersion},        {"title", results.title},
                   {"command", results.command}, {"environment", environment}, {"tables", std::move(tables)},
                   {"charts", std::move(charts)}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
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
