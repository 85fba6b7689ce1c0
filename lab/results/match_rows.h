/// Which rows of two tables are the same: those whose key columns hold the same.
#pragma once

#include "lab/results/results.h"
#include "tracer/problem.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gnomon {

std::optional<std::size_t> columnOf(const Table&, const std::string& key);

/// Key columns of both, as indices in each.
struct Keys {
    std::vector<std::size_t> before, after;
};

Keys commonKeys(const Table& before, const Table& after);

/// Rows by the text of their keys. A problem where two have the same.
std::map<std::string, std::size_t> rowsByName(const Table&, const std::vector<std::size_t>& keys, Problems&);
std::string nameOf(const std::vector<Cell>& row, const std::vector<std::size_t>& keys);

struct Pair {
    const std::vector<Cell>*before, *after;
};

/// Rows of both runs, in the order of the later one.
std::vector<Pair> matchRows(const Table& before, const Table& after, const Keys&, Problems&);

/// Two tables of one name, and what they have in common.
struct Twins {
    const Table &before, &after;
    Keys keys;
    std::vector<Pair> pairs;

    std::vector<Column> keyColumns() const {
        std::vector<Column> columns;
        for (const std::size_t key : keys.after) columns.push_back(after.columns[key]);
        return columns;
    }
    std::vector<Cell> keyCells(const Pair& pair) const {
        std::vector<Cell> cells;
        for (const std::size_t key : keys.after) cells.push_back((*pair.after)[key]);
        return cells;
    }
};

} // namespace gnomon
