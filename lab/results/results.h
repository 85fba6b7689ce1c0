/// What a measurement found, in one form for every laboratory, bench, host and report (docs/results.md).
///
/// A table says all that was measured; a chart only says which of its columns to draw against each other; a picture
/// shows what a row is of.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace gnomon {

/// How a column's numbers are held against those of another run (compare.h).
enum class Kind {
    None,  ///< not at all: keys, words, what follows from other columns
    Time,  ///< differs from run to run; means little without quartiles
    Ratio, ///< of times taken in one run: what slows the machine cancels, chance does not
    Error, ///< how far from what is right, 0 at best; computed alike in every run
    Count, ///< a whole or mean number of things, the same in every run
};
/// Which way a column's numbers improve.
enum class Better { Untold, Lower, Higher };

struct Column {
    std::string key, title;
    std::string unit; ///< empty: a plain number or a word
    std::string help;
    Kind kind = Kind::None;
    Better better = Better::Untold;
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
    std::string front; ///< column that says `yes` of points that no other one betters in x and y; may be empty
};

/// What a row of a table looks like, beside what it should look like.
struct Picture {
    std::string title, table;
    std::vector<Cell> row; ///< cells of the table's key columns
    std::size_t image = 0; ///< in Results::images
    std::optional<std::size_t> reference;
    std::string referenceTitle;
};

/// Where numbers come from, as names and values to be shown.
using Environment = std::vector<std::pair<std::string, std::string>>;

struct Results {
    std::string title;
    std::string command; ///< that makes them again
    Environment environment;
    std::vector<Table> tables;
    std::vector<Chart> charts;
    std::vector<std::string> images; ///< each once: PNGs as data URLs
    std::vector<Picture> pictures;
};

/// As files call them; empty for None and Untold.
std::string_view nameOf(Kind);
std::string_view nameOf(Better);

/// UTF-8 JSON of docs/results.md's format.
std::string toJson(const Results&);

/// The table as Markdown, numbers in two or three digits, quartiles behind their median; lined up for a terminal.
std::string toMarkdown(const Table&);

/// A number as a table shows it: four digits, no trailing zeros.
std::string shown(const Cell&);

} // namespace gnomon
