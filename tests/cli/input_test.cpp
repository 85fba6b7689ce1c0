// What a user gives to be read: pipes are scenes as files are, and what is too large or cannot be read is told at once.
#include "tests/cli/cli.h"

namespace fs = std::filesystem;

TEST_F(Cli, ReadsScenesFromStandardInputAndFromPipes) {
    write("ball.json", kScene);
    ASSERT_EQ(system(("mkfifo '" + (folder_ / "pipe").string() + "'").c_str()), 0);
    EXPECT_EQ(gnomon("check - < ball.json").out, "standard input: right (1 object, 1 light, 2 materials, 0 images)\n");
    EXPECT_EQ(gnomon("check -", "cat ball.json |").code, 0);
    EXPECT_EQ(gnomon("check /dev/stdin < ball.json").code, 0);
    EXPECT_EQ(gnomon("check pipe", "(cat ball.json > pipe &) ;").code, 0);
    EXPECT_EQ(gnomon("render - --size=8x6 -o x.png < ball.json").code, 0);
    expectRefused("check - < /dev/null", 1, "standard input: is a device");
}

TEST_F(Cli, MeasuresFilesBeforeItReadsThem) {
    ASSERT_EQ(system(("truncate -s 2G '" + (folder_ / "big.json").string() + "'").c_str()), 0);
    const std::string little = "ulimit -v 400000; env -u DISPLAY"; // KiB: what the program needs, but no such file
    EXPECT_EQ(gnomon("check big.json", little).err, "gnomon: error: big.json: the file has 2147483648 bytes; at most "
                                                    "4194304 are read; use a smaller scene\n");
    EXPECT_NE(gnomon("report big.json -o x.html", little).err.find("measure less at a time"), std::string::npos);
    EXPECT_NE(gnomon("check -", "yes |").err.find("there are more than 4194304 bytes"), std::string::npos);
    expectRefused("check /dev/zero", 1, "/dev/zero: is a device; name a file");
    expectRefused("report /dev/zero -o x.html", 1, "/dev/zero: is a device; name a file");
}

TEST_F(Cli, SaysWhyAFileCannotBeRead) {
    for (const char* command : {"check /proc/self/mem", "report /proc/self/mem -o x.html", "bench /proc/self/mem"})
        expectRefused(command, 1, "/proc/self/mem: cannot be read: Input/output error");
    write("bare.json", R"({"materials": {"m": {"texture": "picture"}},
                           "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "m"}]})");
    ASSERT_EQ(system(("truncate -s 2G '" + (folder_ / "picture.png").string() + "'").c_str()), 0);
    expectRefused("check bare.json", 1, "picture.png: the file has 2147483648 bytes; at most 134217728 are read");
}
