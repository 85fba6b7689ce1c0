#include "lab/results/read_results.h"

#include "lab/results/earlier_names.h"
#include "tracer/scene/json_document.h"

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

using Json = JsonValue::Kind;

const char* const kRemedy = "write it anew with --json=FILE";
const std::string_view kPng = "data:image/png;base64,";
constexpr std::array kKinds{Kind::Time, Kind::Ratio, Kind::Error, Kind::Count};
constexpr std::array kBetters{Better::Lower, Better::Higher};

std::string entry(const std::string& path, std::size_t index) { return path + "[" + std::to_string(index) + "]"; }

/// Takes a document apart. The first thing that is wrong is told; from then on nothing is, and the rest reads as empty.
class ResultsReader {
  public:
    ResultsReader(const std::string& file, Problems& problems) : file_(file), problems_(problems) {}

    bool failed() const { return failed_; }

    Results results(const JsonValue& root) {
        Results results;
        if (!checkFormat(root)) return results;
        results.title = text(root, "", "title");
        results.command = text(root, "", "command");
        for (const JsonValue& value : members(root, "", "environment"))
            results.environment.emplace_back(value.key, word(value, memberPath("environment", value.key)));
        const auto& tables = entries(root, "", "tables");
        for (std::size_t i = 0; i < tables.size(); ++i) results.tables.push_back(table(tables[i], entry("tables", i)));
        const auto& charts = entries(root, "", "charts");
        for (std::size_t i = 0; i < charts.size(); ++i)
            results.charts.push_back(chart(charts[i], entry("charts", i), results.tables));
        if (root.find("pictures")) readPictures(root, results);
        return results;
    }

  private:
    bool checkFormat(const JsonValue& root) {
        const JsonValue* format = root.find("format");
        if (!format || format->kind != Json::String || format->text != "gnomon-results")
            complain(format ? *format : root, format ? "format" : "", "this is no file of results",
                     "give a file that `gnomon bench` or `gnomon lab` wrote with --json=FILE");
        const double version = failed_ ? 1 : number(root, "", "version");
        if (!failed_ && version != 1)
            complain(*root.find("version"), "version",
                     "version " + toString(version) + " of results is unknown; this program reads version 1",
                     "read it with the gnomon that wrote it");
        return !failed_;
    }

    Table table(const JsonValue& value, const std::string& path) {
        Table table{text(value, path, "name"), text(value, path, "title"), {}, {}};
        const auto& columns = entries(value, path, "columns");
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const std::string at = entry(path + ".columns", i);
            table.columns.push_back({text(columns[i], at, "key"), text(columns[i], at, "title"),
                                     text(columns[i], at, "unit"), text(columns[i], at, "help"),
                                     named<Kind>(columns[i], at, "kind", kKinds),
                                     named<Better>(columns[i], at, "better", kBetters)});
        }
        const auto& rows = entries(value, path, "rows");
        for (std::size_t i = 0; i < rows.size(); ++i)
            table.rows.push_back(row(rows[i], entry(path + ".rows", i), columns.size()));
        if (value.find("keys")) table.keys = keysOf(value, path, columns.size());
        return table;
    }

    int keysOf(const JsonValue& table, const std::string& path, std::size_t columns) {
        const double keys = number(table, path, "keys");
        if (!failed_ && !(keys >= 0 && keys <= double(columns) && keys == double(int(keys))))
            complain(*table.find("keys"), path + ".keys",
                     toString(keys) + " is no number of columns; there are " + std::to_string(columns), kRemedy);
        return failed_ ? 0 : int(keys);
    }

    std::vector<Cell> row(const JsonValue& value, const std::string& path, std::size_t columns) {
        std::vector<Cell> cells;
        if (!is(value, Json::Array, path)) return cells;
        if (value.children.size() != columns)
            complain(value, path,
                     "the row has " + std::to_string(value.children.size()) + " cells instead of " +
                         std::to_string(columns),
                     kRemedy);
        for (const JsonValue& cell : value.children) {
            if (cell.kind == Json::Number)
                cells.emplace_back(cell.number);
            else if (cell.kind == Json::String)
                cells.emplace_back(cell.text);
            else if (cell.kind == Json::Null)
                cells.emplace_back();
            else
                complain(cell, entry(path, cells.size()),
                         std::string(describe(cell.kind)) + " is no number, text or null", kRemedy);
        }
        return cells;
    }

    Chart chart(const JsonValue& value, const std::string& path, const std::vector<Table>& tables) {
        Chart chart;
        chart.title = text(value, path, "title");
        chart.table = text(value, path, "table");
        const Table* table = tableOf(value, path, chart.table, tables);
        if (!table) return chart;
        chart.x = column(value, path, "x", *table, false);
        chart.series = column(value, path, "series", *table, true);
        chart.facet = column(value, path, "facet", *table, true);
        const auto& lines = entries(value, path, "y");
        if (!failed_ && lines.empty()) complain(value, path + ".y", "the chart has no lines", kRemedy);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string at = entry(path + ".y", i);
            chart.y.emplace_back(column(lines[i], at, "column", *table, false), text(lines[i], at, "label"));
        }
        for (const JsonValue& where : members(value, path, "where"))
            chart.where.emplace_back(where.key, word(where, memberPath(path + ".where", where.key)));
        chart.logX = flag(value, path, "log_x");
        chart.logY = flag(value, path, "log_y");
        if (value.find("front")) chart.front = column(value, path, "front", *table, true);
        return chart;
    }

    void readPictures(const JsonValue& root, Results& results) {
        for (const JsonValue& value : entries(root, "", "images")) {
            const std::string at = entry("images", results.images.size());
            results.images.push_back(word(value, at));
            if (!failed_ && results.images.back().rfind(kPng, 0) != 0)
                complain(value, at, "is no PNG as a data URL", kRemedy);
        }
        const auto& pictures = entries(root, "", "pictures");
        for (std::size_t i = 0; i < pictures.size(); ++i)
            results.pictures.push_back(picture(pictures[i], entry("pictures", i), results));
    }

    Picture picture(const JsonValue& value, const std::string& path, const Results& results) {
        Picture picture;
        picture.title = text(value, path, "title");
        picture.table = text(value, path, "table");
        const Table* table = tableOf(value, path, picture.table, results.tables);
        if (!table) return picture;
        if (const JsonValue* cells = member(value, path, "row", Json::Array))
            picture.row = row(*cells, path + ".row", std::size_t(table->keys));
        picture.image = imageOf(value, path, results);
        if (const JsonValue* reference = value.find("reference")) {
            picture.reference = imageOf(*reference, path + ".reference", results);
            picture.referenceTitle = text(*reference, path + ".reference", "title");
        }
        return picture;
    }

    std::size_t imageOf(const JsonValue& value, const std::string& path, const Results& results) {
        const double index = number(value, path, "image");
        const bool known = index >= 0 && index < double(results.images.size()) && index == double(std::size_t(index));
        if (!failed_ && !known)
            complain(*value.find("image"), path + ".image",
                     toString(index) + " is no image; there are " + std::to_string(results.images.size()), kRemedy);
        return known ? std::size_t(index) : 0;
    }

    /// Null, with a problem, where there is none of that name.
    const Table* tableOf(const JsonValue& value, const std::string& path, const std::string& name,
                         const std::vector<Table>& tables) {
        const auto table = std::find_if(tables.begin(), tables.end(), [&](const Table& t) { return t.name == name; });
        if (!failed_ && table == tables.end())
            complain(value, path + ".table", "there is no table " + inQuotes(name), kRemedy);
        return failed_ ? nullptr : &*table;
    }

    std::string column(const JsonValue& value, const std::string& path, const char* key, const Table& table,
                       bool optional) {
        const std::string name = text(value, path, key);
        const bool known = std::any_of(table.columns.begin(), table.columns.end(),
                                       [&](const Column& column) { return column.key == name; });
        if (!failed_ && !known && !(optional && name.empty()))
            complain(*value.find(key), memberPath(path, key),
                     "table " + inQuotes(table.name) + " has no column " + inQuotes(name), kRemedy);
        return name;
    }

    /// One of `known` by its name; what zero stands for where nothing is said.
    template<class Named, std::size_t count>
    Named named(const JsonValue& object, const std::string& path, const char* key,
                const std::array<Named, count>& known) {
        if (failed_ || !object.find(key)) return {};
        const std::string name = text(object, path, key);
        std::string names;
        for (const Named one : known) {
            if (nameOf(one) == name) return one;
            names += (names.empty() ? "" : ", ") + std::string(nameOf(one));
        }
        if (!failed_)
            complain(*object.find(key), memberPath(path, key), inQuotes(name) + " is none of " + names, kRemedy);
        return {};
    }

    // --- values of one kind -----------------------------------------------------------------------------------------

    std::string text(const JsonValue& object, const std::string& path, const char* key) {
        const JsonValue* value = member(object, path, key, Json::String);
        return value ? value->text : std::string();
    }
    double number(const JsonValue& object, const std::string& path, const char* key) {
        const JsonValue* value = member(object, path, key, Json::Number);
        return value ? value->number : 0;
    }
    bool flag(const JsonValue& object, const std::string& path, const char* key) {
        const JsonValue* value = member(object, path, key, Json::Boolean);
        return value && value->boolean;
    }
    const std::vector<JsonValue>& entries(const JsonValue& object, const std::string& path, const char* key) {
        const JsonValue* value = member(object, path, key, Json::Array);
        return value ? value->children : none_;
    }
    const std::vector<JsonValue>& members(const JsonValue& object, const std::string& path, const char* key) {
        const JsonValue* value = member(object, path, key, Json::Object);
        return value ? value->children : none_;
    }
    std::string word(const JsonValue& value, const std::string& path) {
        return is(value, Json::String, path) ? value.text : std::string();
    }

    const JsonValue* member(const JsonValue& object, const std::string& path, const char* key, Json kind) {
        if (!is(object, Json::Object, path)) return nullptr;
        const JsonValue* value = object.find(key);
        if (!value) complain(object, memberPath(path, key), "is missing", kRemedy);
        return value && is(*value, kind, memberPath(path, key)) ? value : nullptr;
    }
    bool is(const JsonValue& value, Json kind, const std::string& path) {
        if (value.kind != kind)
            complain(value, path,
                     "has to be " + std::string(describe(kind)) + ", not " + std::string(describe(value.kind)),
                     kRemedy);
        return !failed_;
    }
    void complain(const JsonValue& at, const std::string& path, const std::string& what, const std::string& remedy) {
        if (!failed_) problems_.push_back({file_, at.line, path, what, remedy});
        failed_ = true;
    }

    const std::string& file_;
    Problems& problems_;
    bool failed_ = false;
    const std::vector<JsonValue> none_;
};

} // namespace

std::optional<Results> readResults(std::string_view text, const std::string& file, Problems& problems) {
    // The parser's own words for these speak of scenes.
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        problems.push_back({file, 0, {}, "the file is empty", kRemedy});
        return std::nullopt;
    }
    if (text.size() > kMaxJsonBytes) {
        problems.push_back({file,
                            0,
                            {},
                            "the file has more than " + std::to_string(kMaxJsonBytes >> 20) + " MiB",
                            "measure less at a time"});
        return std::nullopt;
    }
    Problems found;
    const auto root = parseJson(text, file, found);
    if (!found.empty()) {
        problems.push_back(found.front());
        return std::nullopt;
    }
    ResultsReader reader(file, problems);
    Results results = reader.results(*root);
    if (reader.failed()) return std::nullopt;
    bringUpToDate(results);
    return results;
}

} // namespace gnomon
