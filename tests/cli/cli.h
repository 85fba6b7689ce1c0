// The program from outside, run in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/wait.h>

namespace fs = std::filesystem;

struct Answer {
    int code = -1;
    std::string out, err;
};

inline std::string readText(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline std::string binary() {
    const char* chosen = std::getenv("GNOMON_BINARY");
    return chosen ? chosen : GNOMON_BINARY;
}

/// Runs in a folder of its own, so that whatever is written there was written by the test.
class Cli : public ::testing::Test {
  protected:
    Cli() {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() / (std::string("gnomon-cli-") + test->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~Cli() override { fs::remove_all(folder_); }

    /// Two may run at once.
    Answer gnomon(const std::string& words, const std::string& before = "env -u DISPLAY -u WAYLAND_DISPLAY") {
        const fs::path err = folder_.string() + ".stderr" + std::to_string(++runs_);
        const std::string command =
            "cd '" + folder_.string() + "' && " + before + " '" + binary() + "' " + words + " 2>'" + err.string() + "'";
        Answer run;
        FILE* pipe = popen(command.c_str(), "r");
        std::array<char, 4096> piece;
        for (std::size_t n; (n = std::fread(piece.data(), 1, piece.size(), pipe)) > 0;) run.out.append(piece.data(), n);
        const int status = pclose(pipe);
        run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        run.err = readText(err);
        fs::remove(err);
        return run;
    }

    /// One message with `part` in it, the exit code, and no new file.
    void expectRefused(const std::string& words, int code, const std::string& part) {
        const std::size_t before = files();
        const Answer run = gnomon(words);
        EXPECT_EQ(run.code, code) << words << "\n" << run.err;
        EXPECT_EQ(run.err.rfind("gnomon: error: ", 0), 0U) << words << "\n" << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << words << "\n" << run.err;
        EXPECT_NE(run.err.find(part), std::string::npos) << words << "\n" << run.err;
        EXPECT_EQ(run.out, "") << words;
        EXPECT_EQ(files(), before) << words << " wrote something";
    }

    void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
    std::size_t files() const { return std::size_t(std::distance(fs::directory_iterator(folder_), {})); }

    fs::path folder_;
    std::atomic<int> runs_ = 0;
};

inline const char* const kScene = R"({
  "lights": [{"point": {"position": [0, 5, 5]}, "color": [1, 1, 1]}],
  "materials": {"red": {"diffuse": [1, 0, 0]}},
  "objects": [{"sphere": {"center": [0, 0, 0], "radius": 0.5}, "material": "red"}]
})";
