// Where results go: standard output, pipes, links, and files that a failed write must leave as they were.
#include "tests/cli/cli.h"

#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace {

const std::string kPng = "\x89PNG\r\n\x1a\n", kSmall = "render lite --size=8x6 ";

bool isPng(const std::string& bytes) { return bytes.starts_with(kPng) && bytes.find("IEND") == bytes.size() - 8; }

} // namespace

TEST_F(Cli, WritesAPictureToStandardOutputAndWhatPeopleReadToStderr) {
    const Answer png = gnomon(kSmall + "-o -"), same = gnomon(kSmall + "-o /dev/stdout --format=png"),
                 pfm = gnomon(kSmall + "-o - --format=pfm --aov=distance");
    EXPECT_EQ(png.code, 0) << png.err;
    EXPECT_TRUE(isPng(png.out));
    EXPECT_NE(png.err.find("lite, 8 x 6"), std::string::npos) << png.err;
    EXPECT_EQ(same.out, png.out);
    EXPECT_EQ(pfm.out.substr(0, 12), "Pf\n8 6\n-1.0\n");
    EXPECT_EQ(pfm.out.size(), 12U + 8 * 6 * 4);
    EXPECT_EQ(files(), 0U);
    expectRefused(kSmall + "-o - --aov=distance", 2, "a PNG cannot hold distance");
    expectRefused(kSmall + "-o x.png --format=jpg", 2, "\"jpg\" is none of png|pfm|exr");
    expectRefused(kSmall + "-o - >/dev/full", 1, "standard output: cannot be written: No space left on device");
}

TEST_F(Cli, TakesAPicturesFormatFromTheOptionOrTheNameWhateverItsCase) {
    EXPECT_EQ(gnomon(kSmall + "-o x.PNG").code, 0);
    EXPECT_TRUE(isPng(readText(folder_ / "x.PNG")));
    EXPECT_EQ(gnomon(kSmall + "-o picture --format=pfm").code, 0);
    EXPECT_EQ(readText(folder_ / "picture").substr(0, 3), "PF\n");
}

TEST_F(Cli, GivesAPictureToThePipeItIsSentTo) {
    const Answer run = gnomon(kSmall + "-o pipe.png", "mkfifo pipe.png; (cat pipe.png > got.png &) ;");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(isPng(readText(folder_ / "got.png")));
    EXPECT_TRUE(fs::is_fifo(folder_ / "pipe.png"));
}

TEST_F(Cli, WritesResultsAsItWritesPictures) {
    const std::string bench = "bench lite --depth=1 --shadows=off --size=16x12 --repeats=1 ";
    write("real.json", "old");
    fs::create_symlink("real.json", folder_ / "link.json");
    EXPECT_EQ(gnomon(bench + "--json=link.json").code, 0);
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.json"));
    EXPECT_TRUE(nlohmann::json::accept(readText(folder_ / "real.json")));
    const Answer streamed = gnomon(bench + "--json=-");
    EXPECT_EQ(streamed.code, 0) << streamed.err;
    EXPECT_TRUE(nlohmann::json::accept(streamed.out)) << streamed.out;
    EXPECT_NE(streamed.err.find("Times are medians"), std::string::npos) << "tables are for people";
    expectRefused(bench + "--json=- --html=-", 2, "standard output: takes one result only");
    const Answer page = gnomon("report real.json -o -");
    EXPECT_EQ(page.code, 0) << page.err;
    EXPECT_TRUE(page.out.starts_with("<!doctype html>"));
    EXPECT_EQ(files(), 2U);
}

TEST_F(Cli, WritesOverNothingThatItReads) {
    const std::string scene = R"({"materials": {"m": {"texture": "skin"}},
        "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "m"}]})";
    write("ball.json", scene);
    ASSERT_EQ(gnomon(kSmall + "-o skin.png").code, 0);
    const std::string skin = readText(folder_ / "skin.png"), lost = "has been read here, and would be lost";
    fs::create_hard_link(folder_ / "ball.json", folder_ / "same.png");
    expectRefused("render ball.json -o ball.json --format=png", 2, lost);
    expectRefused("render ball.json -o same.png", 2, lost);
    expectRefused("render ball.json -o skin.png", 2, lost);
    expectRefused("bench ball.json --depth=1 --shadows=off --size=16x12 --repeats=1 --json=ball.json", 2, lost);
    EXPECT_EQ(readText(folder_ / "ball.json"), scene);
    EXPECT_EQ(readText(folder_ / "skin.png"), skin);
    ASSERT_EQ(gnomon("bench lite --depth=1 --shadows=off --size=16x12 --repeats=1 --json=run.json").code, 0);
    const std::string run = readText(folder_ / "run.json");
    expectRefused("report run.json -o run.json", 1, lost);
    EXPECT_EQ(readText(folder_ / "run.json"), run);
}
