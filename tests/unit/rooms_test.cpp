/// The rooms of the house, read off the sources: a room includes only rooms that it stands on, and its files are short.
///
/// A room is a folder of tracer, lab, lab/reference or native; web is one, and so are the files beside those folders.

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {
namespace {

namespace fs = std::filesystem;

// ---- Sources

struct Source {
    std::string path; ///< from the root of the checkout
    std::vector<std::string> lines;
};

std::vector<std::string> linesOf(std::istream& text) {
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
}

/// Files under these folders whose names end so; "" are those without an ending.
std::vector<Source> sourcesIn(const std::vector<std::string>& folders, const std::set<std::string>& endings) {
    const fs::path root = GNOMON_SOURCE_DIR;
    std::vector<Source> sources;
    for (const std::string& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (!entry.is_regular_file() || !endings.contains(entry.path().extension())) continue;
            std::ifstream file(entry.path());
            sources.push_back({entry.path().lexically_relative(root).generic_string(), linesOf(file)});
        }
    std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
    return sources;
}

Source invented(const std::string& path, const std::string& text) {
    std::istringstream in(text);
    return {path, linesOf(in)};
}

const std::vector<std::string> kShipped{"tracer", "lab", "native", "web"};

// ---- Includes

struct Include {
    std::string from, to; ///< files
    std::string line;     ///< file:line: what stands there
};

std::string roomOf(const std::string& file) {
    const std::size_t slash = file.find('/', file.starts_with("lab/reference/") ? 14 : file.find('/') + 1);
    if (file.starts_with("web/") || slash == std::string::npos) return file.substr(0, file.find('/'));
    return file.substr(0, slash);
}

std::vector<Include> includesOf(const std::vector<Source>& sources) {
    constexpr std::string_view kWords = "#include \"";
    std::vector<Include> includes;
    for (const Source& source : sources)
        for (std::size_t i = 0; i < source.lines.size(); ++i) {
            const std::string& line = source.lines[i];
            if (!line.starts_with(kWords)) continue;
            std::string to = line.substr(kWords.size(), line.find('"', kWords.size()) - kWords.size());
            if (to.find('/') == std::string::npos) continue; // a file beside this one
            includes.push_back({source.path, to, source.path + ":" + std::to_string(i + 1) + ": " + line});
        }
    return includes;
}

/// Each circle of rooms once, the shortest through the room that comes first: an include line a step.
std::vector<std::string> circlesIn(const std::vector<Include>& includes) {
    std::map<std::string, std::map<std::string, const Include*>> rooms; // the first line that leads from one to another
    for (const Include& include : includes)
        if (roomOf(include.from) != roomOf(include.to))
            rooms[roomOf(include.from)].emplace(roomOf(include.to), &include);

    std::vector<std::string> circles;
    std::set<std::set<std::string>> told;
    for (const auto& [start, doors] : rooms) {
        std::map<std::string, const Include*> entered; // by which line, the fewest rooms away from the start
        std::deque<std::string> open{start};
        for (; !open.empty() && !entered.contains(start); open.pop_front())
            for (const auto& [next, include] : rooms[open.front()])
                if (entered.emplace(next, include).second) open.push_back(next);
        if (!entered.contains(start)) continue;
        std::set<std::string> members;
        std::string lines;
        std::string room = start;
        do {
            lines = "  " + entered[room]->line + "\n" + lines;
            room = roomOf(entered[room]->from);
            members.insert(room);
        } while (room != start);
        if (told.insert(members).second) circles.push_back(start + " includes itself by way of others:\n" + lines);
    }
    return circles;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

TEST(Rooms, AreFoldersAndFilesBesideThem) {
    EXPECT_EQ(roomOf("tracer/plan/plan.h"), "tracer/plan");
    EXPECT_EQ(roomOf("tracer/image.h"), "tracer");
    EXPECT_EQ(roomOf("tracer/render/pass/trace.cpp"), "tracer/render");
    EXPECT_EQ(roomOf("lab/reference/exact/exact_shape.h"), "lab/reference/exact");
    EXPECT_EQ(roomOf("web/page/main.js"), "web");
}

TEST(Rooms, InACircleAreToldWithTheirLines) {
    const auto pair = circlesIn(includesOf({invented("tracer/a/one.h", "\n#include \"tracer/b/two.h\"\n"),
                                            invented("tracer/b/two.h", "#include \"tracer/b/own.h\"\n"),
                                            invented("tracer/b/other.cpp", "#include \"tracer/a/one.h\"\n"),
                                            invented("lab/x.cpp", "#include \"tracer/a/one.h\"\n")}));
    ASSERT_EQ(pair.size(), 1U) << joined(pair);
    EXPECT_NE(pair[0].find("tracer/a/one.h:2: #include \"tracer/b/two.h\""), std::string::npos) << pair[0];
    EXPECT_NE(pair[0].find("tracer/b/other.cpp:1: #include \"tracer/a/one.h\""), std::string::npos) << pair[0];

    const auto three = circlesIn(includesOf({invented("tracer/a/a.h", "#include \"tracer/b/b.h\"\n"),
                                             invented("tracer/b/b.h", "#include \"tracer/c/c.h\"\n"),
                                             invented("tracer/c/c.h", "#include \"tracer/a/a.h\"\n")}));
    EXPECT_EQ(three.size(), 1U) << joined(three);
    EXPECT_TRUE(circlesIn(includesOf({invented("lab/a/a.h", "#include \"tracer/b/b.h\"\n")})).empty());
}

TEST(Rooms, IncludeNoRoomThatIncludesThem) {
    const auto includes = includesOf(sourcesIn(kShipped, {".h", ".cpp"}));
    ASSERT_GT(includes.size(), 300U);
    const auto circles = circlesIn(includes);
    EXPECT_TRUE(circles.empty()) << joined(circles);
}

TEST(Rooms, OfTheTracerKnowNeitherLabNorProgram) {
    for (const Include& include : includesOf(sourcesIn({"tracer"}, {".h", ".cpp"})))
        EXPECT_TRUE(include.to.starts_with("tracer/") || include.to.find('/') == std::string::npos) << include.line;
}

TEST(Rooms, ThatAreShippedNeitherIncludeNorLinkTests) {
    for (const Include& include : includesOf(sourcesIn(kShipped, {".h", ".cpp"})))
        EXPECT_FALSE(include.to.starts_with("tests/")) << include.line;
    for (const Source& source : sourcesIn(kShipped, {".txt", ".cmake"}))
        for (const std::string& line : source.lines)
            EXPECT_EQ(line.substr(0, line.find('#')).find("tests/"), std::string::npos) << source.path << ": " << line;
}

// ---- Lengths

constexpr std::size_t kMostLines = 400, kMostLinesOfAHost = 300, kMostColumns = 120;

/// Longer, or wider, than that: tables, which a cut would make no clearer.
const std::map<std::string, std::string> kTables{
    {"tests/cli/cli_test.cpp", "one test for each thing a user may type"},
    {"tests/shader/accel_test.cpp", "one table of scenes for all searches"},
    {"tests/shader/distance_test.cpp", "one table of points for all shapes"},
    {"tracer/scene/scene_format.cpp", "one table of all that a scene file may say"},
    {"tests/unit/hierarchy_test.cpp", "one table of trees for all of their tests"},
};

std::size_t columnsOf(const std::string& line) { // of UTF-8
    return std::size_t(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

bool isHost(const std::string& path) {
    return (path.starts_with("web/") && path.ends_with(".cpp")) ||
           (path.starts_with("native/window/") && path.ends_with("_host.cpp"));
}

std::vector<std::string> tooLong(const Source& source) {
    std::vector<std::string> found;
    const std::size_t most = isHost(source.path) ? kMostLinesOfAHost : kMostLines;
    if (source.lines.size() > most)
        found.push_back(source.path + ": " + std::to_string(source.lines.size()) + " lines, at most " +
                        std::to_string(most));
    for (std::size_t i = 0; i < source.lines.size(); ++i)
        if (const std::size_t columns = columnsOf(source.lines[i]); columns > kMostColumns)
            found.push_back(source.path + ":" + std::to_string(i + 1) + ": " + std::to_string(columns) + " columns");
    return found;
}

TEST(Files, ThatAreTooLongAreTold) {
    const std::string wide(kMostColumns + 1, 'x'), umlauts = [] {
        std::string text;
        for (std::size_t i = 0; i < kMostColumns; ++i) text += "ü";
        return text;
    }();
    const std::string lines(kMostLinesOfAHost + 1, '\n');
    EXPECT_EQ(tooLong(invented("tracer/a.h", "\n" + wide)), std::vector<std::string>{"tracer/a.h:2: 121 columns"});
    EXPECT_TRUE(tooLong(invented("tracer/a.h", umlauts)).empty());
    EXPECT_EQ(tooLong(invented("native/window/sdl_host.cpp", lines)).size(), 1U);
    EXPECT_EQ(tooLong(invented("web/host.cpp", lines)).size(), 1U);
    EXPECT_TRUE(tooLong(invented("tracer/a.cpp", lines)).empty());
    EXPECT_EQ(tooLong(invented("tracer/a.cpp", std::string(kMostLines + 1, '\n'))).size(), 1U);
}

TEST(Files, AreShortAndNarrow) {
    const auto sources = sourcesIn({"tracer", "lab", "native", "web", "shaders", "tests", "scripts"},
                                   {"", ".h", ".cpp", ".glsl", ".frag", ".vert", ".js", ".mjs"});
    ASSERT_GT(sources.size(), 300U);
    std::vector<std::string> found;
    for (const Source& source : sources) {
        const auto here = tooLong(source);
        if (!kTables.contains(source.path))
            found.insert(found.end(), here.begin(), here.end());
        else if (here.empty())
            found.push_back(source.path + " is short and narrow: take it off the list of tables");
    }
    EXPECT_TRUE(found.empty()) << joined(found);
}

} // namespace
} // namespace gnomon
