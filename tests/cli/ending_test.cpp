// How the program ends: interrupted, without room for what it prints, with a driver that crashes, without memory.
#include "tests/cli/cli.h"

#include <nlohmann/json.hpp>

#include <future>
#include <utility>

namespace fs = std::filesystem;

namespace {

std::string after(int seconds, const std::string& signal) {
    return "timeout --foreground --preserve-status --signal=" + signal + " " + std::to_string(seconds) +
           " env -u DISPLAY -u WAYLAND_DISPLAY";
}

} // namespace

TEST_F(Cli, BenchAndLabsKeepWhatTheyMeasuredWhereTheyAreInterrupted) {
    for (const char* command :
         {"bench lite --depth=1 --shadows=off --size=32x24 --repeats=10000",
          "lab intersect --shapes=sphere,disc --rays=100000",
          "lab trace --scenes=simple --spheres=10 --size=32x24 --repeats=1000",
          "lab shadows --scenes=simple --models=hard --size=640x480 --reference=16 --repeats=1000"}) {
        const auto interrupted = [&](const std::string& signal) {
            return gnomon(std::string(command) + " --json=" + signal + ".json", after(8, signal));
        };
        auto byInt = std::async(std::launch::async, interrupted, "INT");
        const Answer byTerm = interrupted("TERM");
        for (const auto& [run, signal] : {std::pair(byInt.get(), "INT"), std::pair(byTerm, "TERM")}) {
            EXPECT_EQ(run.code, 130) << command << signal << "\n" << run.err;
            EXPECT_NE(run.out.find("nterrupted: what "), std::string::npos) << command << signal << "\n" << run.out;
            const fs::path file = folder_ / (std::string(signal) + ".json");
            EXPECT_TRUE(nlohmann::json::accept(readText(file))) << command << signal;
            fs::remove(file);
        }
    }
}

TEST_F(Cli, EndsWithOneCodeWhereItIsInterruptedAndLeavesTheOldFile) {
    write("x.png", "old");
    for (const char* signal : {"INT", "TERM"}) {
        EXPECT_EQ(gnomon("render pro -o x.png --size=8000x8000 --depth=8", after(2, signal)).code, 130) << signal;
        EXPECT_EQ(gnomon("check -", "sleep 5 | " + after(1, signal)).code, 130) << signal;
    }
    EXPECT_EQ(readText(folder_ / "x.png"), "old");
    EXPECT_EQ(files(), 1U);
}

TEST_F(Cli, FailsWhereWhatItPrintsCannotBeWritten) {
    for (const char* command : {"scenes", "scenes --json", "settings", "shader lite", "check lite", "info", "--help",
                                "render --help", "--version"}) {
        const Answer full = gnomon(std::string(command) + " > /dev/full"),
                     closed = gnomon(std::string(command) + " >&-");
        EXPECT_EQ(full.code, 1) << command;
        EXPECT_EQ(closed.code, 1) << command;
        for (const Answer& run : {full, closed})
            EXPECT_NE(run.err.find("standard output: cannot be written"), std::string::npos) << command << run.err;
    }
    EXPECT_EQ(gnomon("render lite --size=8x6 -o x.png >&-").code, 1);
    EXPECT_EQ(readText(folder_ / "x.png").substr(1, 3), "PNG") << "nothing was printed into the picture";
}

TEST_F(Cli, KeepsTheOldFileWhereTheNewOneMayNotGrow) {
    write("page.html", "old");
    ASSERT_EQ(gnomon("bench lite --depth=1 --shadows=off --size=16x12 --repeats=1 --json=r.json").code, 0);
    const Answer run = gnomon("report r.json -o page.html", "ulimit -f 32;");
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("page.html: cannot be written: File too large"), std::string::npos) << run.err;
    EXPECT_EQ(readText(folder_ / "page.html"), "old");
    EXPECT_EQ(files(), 2U);
}

TEST_F(Cli, TellsInWordsThatGlOrMemoryFailed) {
    const std::string render = "render lite --size=8x6 -o x.png";
    for (const char* driver :
         {"GALLIUM_DRIVER=nonsense", "MESA_EXTENSION_OVERRIDE='-GL_ARB_texture_float -GL_EXT_color_buffer_float'"}) {
        const Answer run = gnomon(render, "env -u DISPLAY -u WAYLAND_DISPLAY " + std::string(driver));
        EXPECT_EQ(run.code, 3) << driver << run.err;
        EXPECT_TRUE(run.err.starts_with("gnomon: error: osmesa context: ")) << driver << run.err;
    }
    for (int mebibytes = 50; mebibytes < 700; mebibytes += 50) {
        const Answer run = gnomon(render, "ulimit -v " + std::to_string(1024 * mebibytes) + "; env -u DISPLAY");
        EXPECT_TRUE(run.code == 0 || run.code == 1 || run.code == 3) << mebibytes << " MiB: " << run.code << run.err;
        EXPECT_NE(run.code == 0, run.err.starts_with("gnomon: error: ")) << mebibytes << " MiB: " << run.err;
    }
    const Answer loaded = gnomon(render, "ulimit -v 150000; env -u DISPLAY");
    EXPECT_NE(loaded.err.find("libOSMesa cannot be loaded: "), std::string::npos) << loaded.err;
}
