// What a result is written to may be there already, as a file, a link, a pipe or a device.
#include "native/file/output_file.h"

#include "tests/support/own_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>

#include <sys/stat.h>
#include <unistd.h>

using namespace gnomon;
namespace fs = std::filesystem;

namespace {

class OutputFile : public test::OwnFolder {
  protected:
    void put(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
    std::string text(const std::string& name) const {
        std::ifstream in(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void expectWritten(const std::string& name, const std::string& bytes) {
        Problems problems;
        EXPECT_TRUE(prepareOutput(path(name), problems)) << toString(problems);
        EXPECT_TRUE(writeOutput(path(name), bytes, problems)) << toString(problems);
        EXPECT_EQ(text(name), bytes);
    }
    /// Refused, with these words, when the disk or the file says no.
    void expectRefused(const std::string& file, const std::string& bytes, const std::string& words) {
        Problems problems;
        EXPECT_FALSE(prepareOutput(file, problems) && writeOutput(file, bytes, problems)) << file;
        EXPECT_NE(toString(problems).find(words), std::string::npos) << toString(problems);
    }
};

} // namespace

TEST_F(OutputFile, WritesThroughLinksWhetherTheirFileExistsOrNot) {
    fs::create_directories(path("inner"));
    put("inner/real", "old");
    fs::create_symlink("inner/real", path("link"));
    fs::create_symlink(path("link"), path("second"));
    fs::create_symlink("inner/new", path("dangling"));
    expectWritten("second", "through two links");
    EXPECT_EQ(text("inner/real"), "through two links");
    expectWritten("dangling", "made");
    EXPECT_EQ(text("inner/new"), "made");
    for (const char* link : {"link", "second", "dangling"}) EXPECT_TRUE(fs::is_symlink(path(link))) << link;
    EXPECT_EQ(files(), 4U) << "no draft is left";
}

TEST_F(OutputFile, KeepsTheModeOfAFileAndGivesNewOnesTheUsual) {
    put("secret", "old");
    chmod(path("secret").c_str(), 0600);
    expectWritten("secret", "new");
    struct stat now {};
    stat(path("secret").c_str(), &now);
    EXPECT_EQ(now.st_mode & 07777, 0600U);
    const mode_t mask = umask(027);
    expectWritten("fresh", "new");
    umask(mask);
    stat(path("fresh").c_str(), &now);
    EXPECT_EQ(now.st_mode & 07777, 0640U);
}

TEST_F(OutputFile, KeepsTheOtherNamesOfAFile) {
    put("one", "a longer old text");
    fs::create_hard_link(path("one"), path("two"));
    expectWritten("one", "new");
    EXPECT_EQ(text("two"), "new");
}

TEST_F(OutputFile, TakesNamesAsLongAsTheFileSystemDoes) {
    expectWritten(std::string(255, 'a'), "x");
    expectRefused(path(std::string(256, 'a')), "x", "File name too long");
    EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFile, GivesPipesTheirBytes) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_TRUE(isStream(path("pipe")));
    auto reader = std::async(std::launch::async, [this] { return text("pipe"); });
    Problems problems;
    const std::string much(200000, 'x'); // more than a pipe holds
    EXPECT_TRUE(prepareOutput(path("pipe"), problems) && writeOutput(path("pipe"), much, problems));
    EXPECT_EQ(reader.get(), much);
    EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(OutputFile, SaysWhyItCannotBeWritten) {
    fs::create_directories(path("folder"));
    fs::create_symlink("circle", path("circle"));
    put("file", "");
    expectRefused(path("folder"), "x", "is a folder; name a file");
    expectRefused(path("none/x"), "x", "there is no folder " + path("none"));
    expectRefused(path("file/x"), "x", "there is no folder");
    expectRefused(path("circle"), "x", "Too many levels of symbolic links");
    expectRefused("/dev/full", "x", "No space left on device");
    EXPECT_EQ(files(), 3U);
}
