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

TEST_F(Cli, BoundsTheMemoryOfImagesBeforeItDecodesThem) {
    // A header alone: nothing may come to the point where the rest is missed.
    const auto header = [](char side) {
        return std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) + std::string("\0\0", 2) + side +
               std::string("\0\0\0", 3) + side + std::string("\0\x08\x06\0\0\0\0\0\0\0", 10);
    };
    std::string materials, objects;
    for (const char* name : {"a", "b", "c", "d"}) {
        const std::string comma = materials.empty() ? "" : ",", quoted = "\"" + std::string(name) + "\"";
        materials += comma + quoted + R"(:{"texture":)" + quoted + "}";
        objects += comma + R"({"sphere":{"center":[0,0,0],"radius":1},"material":)" + quoted + "}";
        write(std::string(name) + ".png", header(0x20));
    }
    write("four.json", "{\"materials\":{" + materials + "},\"objects\":[" + objects + "]}");
    expectRefused("check four.json", 1, "four.json: its images take 1024 MB; 512 MB are the most");
    expectRefused("render four.json -o x.png", 1, "four.json: its images take 1024 MB");
    write("one.json", R"({"materials":{"m":{"texture":"large"}},
                          "objects":[{"sphere":{"center":[0,0,0],"radius":1},"material":"m"}]})");
    write("large.PNG", header(0x2d)); // 11520 a side: less than 512 MB as pixels, more to decode
    expectRefused("check one.json", 1,
                  "large.PNG: its 11520 x 11520 pixels take 1012 MB to decode; 512 MB are the most");
}
