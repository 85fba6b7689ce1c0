/// What a measurement found, in one form for every laboratory, bench, host and report (docs/results.md).
///
/// A table says all that was measured; a chart only says which of its columns to draw against each other.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gnomon {

struct Column {
    std::string key, title;
    std::string unit; ///< empty: a plain number or a word
    std::string help;
};

/// A number, a word, or nothing where a row has no such value. Infinities are written as words: JSON has none.
using Cell = std::variant<std::monostate, double, std::string>;

struct Table {
    std::string name, title;
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;
    int keys = 0; ///< so many of the first columns say what a row is of; 0: not told
};

/// Where the quartiles of a column stand whose values are medians: the columns KEY_low and KEY_high.
struct QuartileColumns {
    std::size_t low, high;
};
std::optional<QuartileColumns> quartileColumns(const Table&, std::size_t column);

/// Lines of the columns `y` over `x`, one for each of `series`, small multiples by `facet`; rows are those where every
/// `where` holds.
struct Chart {
    std::string title, table;
    std::string x;
    std::vector<std::pair<std::string, std::string>> y; ///< columns and what the legend calls them; one unit for all
    std::string series, facet;                          ///< columns; may be empty
    std::vector<std::pair<std::string, std::string>> where;
    bool logX = false, logY = false;
};

/// Where numbers come from, as names and values to be shown.
using Environment = std::vector<std::pair<std::string, std::string>>;

struct Results {
    std::string title;
    std::string command; ///< that makes them again
    Environment environment;
    std::vector<Table> tables;
    std::vector<Chart> charts;
};

/// UTF-8 JSON of docs/results.md's format.
std::string toJson(const Results&);

/// The table as Markdown, numbers in two or three digits, quartiles behind their median; lined up for a terminal.
std::string toMarkdown(const Table&);

/// A number as a table shows it: four digits, no trailing zeros.
std::string shown(const Cell&);

} // namespace gnomon
