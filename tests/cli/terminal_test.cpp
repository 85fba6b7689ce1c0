// What files bring is shown, never obeyed: by terminals, by shells, by browsers.
#include "tests/cli/cli.h"

#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace {

const std::string kSteering = "\x1b]0;owned\a\x1b[2J\x7f\xc2\x9b"
                              "31m\xe2\x80\xae"
                              "cod\r\n";

bool steers(const std::string& text) {
    const bool control = std::any_of(text.begin(), text.end(), [](char c) {
        return c == 0x7f || (static_cast<unsigned char>(c) < 0x20 && c != '\n');
    });
    return control || text.find("\xc2\x9b") != std::string::npos || text.find("\xe2\x80\xae") != std::string::npos;
}

} // namespace

TEST_F(Cli, ShowsControlCharactersWithoutObeyingThem) {
    fs::create_directories(folder_ / "assets/scenes");
    nlohmann::json scene = nlohmann::json::parse(kScene);
    scene["title"] = kSteering;
    write("assets/scenes/a.json", scene.dump());
    const std::string bare = kSteering.substr(0, kSteering.size() - 1), file = "'" + bare + "\n.json'";
    write(bare + "\n.json", kScene);
    write("wrong.json", R"({"\u001b[2J\u009b31m": 1, "title": "\u202e", "objects": [{"sphere\u007f": {}, "\u0085": 2,
                            "material": "\u001b[31m\u202e"}]})");
    const std::string assets = "env GNOMON_ASSETS=" + (folder_ / "assets").string() + " ";
    for (const std::string& command :
         {std::string("scenes"), std::string("scenes --json"), "check " + file, std::string("check wrong.json"),
          "render " + file + " --size=8x6 -o " + "'" + bare + ".png'",
          "check " + kSteering.substr(0, 0) + "'" + bare + "'", "render lite --" + std::string("'") + bare + "'",
          "report " + file + " -o x.html"}) {
        const Answer run = gnomon(command, assets);
        EXPECT_FALSE(steers(run.out)) << command << "\n" << run.out;
        EXPECT_FALSE(steers(run.err)) << command << "\n" << run.err;
        EXPECT_TRUE(run.out.size() + run.err.size() > 0) << command;
    }
    EXPECT_EQ(nlohmann::json::parse(gnomon("scenes --json", assets).out)[0]["title"], kSteering);
    EXPECT_NE(
        gnomon("scenes", assets).out.find("\\u001b]0;owned\\u0007\\u001b[2J\\u007f\\u009b31m\\u202ecod\\u000d\\u000a"),
        std::string::npos);
}

TEST_F(Cli, QuotesTheWordsOfRecordedCommands) {
    const std::string odd = "it's $(touch pwn) `x` \"y\".json", quoted = "'it'\\''s $(touch pwn) `x` \"y\".json'";
    write(odd, kScene);
    ASSERT_EQ(gnomon("bench " + quoted + " --depth=1 --shadows=off --size=8x6 --repeats=1 --json=b.json").code, 0);
    ASSERT_EQ(
        gnomon("lab shadows --models=hard --size=8x6 --reference=16 --repeats=1 --json=s.json --scenes=" + quoted).code,
        0);
    for (const char* file : {"b.json", "s.json"}) {
        const std::string command = nlohmann::json::parse(readText(folder_ / file))["command"];
        EXPECT_NE(command.find(quoted), std::string::npos) << command;
    }
    fs::copy(folder_ / "b.json", folder_ / odd, fs::copy_options::overwrite_existing);
    ASSERT_EQ(gnomon("report --against b.json " + quoted + " --json=c.json").code, 0);
    EXPECT_EQ(nlohmann::json::parse(readText(folder_ / "c.json"))["command"],
              "gnomon report --against b.json " + quoted + " --tolerance=5");
}

TEST_F(Cli, ReportShowsMarkupAsTextAndLetsNothingElseRun) {
    ASSERT_EQ(gnomon("bench lite --depth=1 --shadows=off --size=8x6 --repeats=1 --json=r.json").code, 0);
    auto results = nlohmann::json::parse(readText(folder_ / "r.json"));
    const std::string markup = "<!--<script></script><img src=x onerror=alert(1)>";
    results["title"] = markup;
    write("r.json", results.dump());
    ASSERT_EQ(gnomon("report r.json -o page.html").code, 0);
    const std::string page = readText(folder_ / "page.html"),
                      begin = "<script id=\"results\" type=\"application/json\">";
    const std::size_t from = page.find(begin) + begin.size(), to = page.find("</script>", from);
    const auto shown = nlohmann::json::parse(page.substr(from, to - from));
    EXPECT_EQ(shown[0]["title"], markup);
    EXPECT_EQ(page.substr(from, to - from).find('<'), std::string::npos);
    EXPECT_NE(page.find("default-src 'none'; script-src 'sha256-"), std::string::npos);
    EXPECT_EQ(page.find("unsafe"), std::string::npos);
}
