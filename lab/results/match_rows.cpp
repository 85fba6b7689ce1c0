#include "lab/results/match_rows.h"

namespace gnomon {

std::optional<std::size_t> columnOf(const Table& table, const std::string& key) {
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (table.columns[i].key == key) return i;
    return std::nullopt;
}

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

} // namespace gnomon
