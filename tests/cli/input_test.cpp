// What a user gives to be read: pipes are scenes as files are, and what is too large or cannot be read is told at once.
#include "tests/cli/cli.h"

#include <sys/resource.h>

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
    write("mesh.json", R"({"objects": [{"mesh": {"file": "pipe"}}]})"); // nobody writes into it
    EXPECT_NE(gnomon("check mesh.json").err.find("is a pipe or a device; name a file"), std::string::npos);
}

TEST_F(Cli, MeasuresFilesBeforeItReadsThem) {
    ASSERT_EQ(system(("truncate -s 2G '" + (folder_ / "big.json").string() + "'").c_str()), 0);
    const std::string little = "ulimit -v 400000; env -u DISPLAY"; // KiB: what the program needs, but no such file
    EXPECT_EQ(gnomon("check big.json", little).err, "gnomon: error: big.json: the file has 2147483648 bytes; at most "
                                                    "16777216 are read; use a smaller scene\n");
    EXPECT_NE(gnomon("report big.json -o x.html", little).err.find("measure less at a time"), std::string::npos);
    EXPECT_NE(gnomon("check -", "yes |").err.find("there are more than 16777216 bytes"), std::string::npos);
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

/// A grey JPEG: blocks of two bits each, "as before" and "nothing else".
std::string greyJpeg(int width, int height) {
    const auto two = [](int n) { return std::string{char(n >> 8), char(n)}; };
    const auto codes = [](char kind) { // one, of one bit, for the symbol 0
        return std::string("\xff\xc4\0\x14", 4) + kind + '\1' + std::string(16, '\0');
    };
    const std::string quantisation = std::string("\xff\xdb\0\x43\0", 5) + std::string(64, '\1');
    const std::string frame = std::string("\xff\xc0\0\x0b\x08", 5) + two(height) + two(width) + "\1\1\x11" + '\0';
    const std::string scan("\xff\xda\0\x08\1\1\0\0\x3f\0", 10);
    return "\xff\xd8" + quantisation + frame + codes('\0') + codes('\x10') + scan +
           std::string(std::size_t(width / 8) * std::size_t(height / 8) / 4 + 8, '\0') + "\xff\xd9";
}

// Texels, the GL's copy with its levels, what decoding takes: what is drawn, and what is refused for that.
TEST_F(Cli, TakesLessThanAGigabyteForImages) {
    for (const char* name : {"a.jpg", "b.jpg"}) write(name, greyJpeg(8192, 8192));
    write("sky.jpg", greyJpeg(8192, 4096));
    write("large.json", R"({"background":{"image":"sky"},"materials":{"m":{"texture":"a"}},
                            "objects":[{"sphere":{"center":[0,0,0],"radius":1},"material":"m"}]})");
    write("two.json", R"({"materials":{"a":{"texture":"a"},"b":{"texture":"b"}},
                          "objects":[{"sphere":{"center":[0,0,0],"radius":1},"material":"a"},
                                     {"sphere":{"center":[2,0,0],"radius":1},"material":"b"}]})");
    EXPECT_EQ(gnomon("render large.json --size=32x24 -o x.png").code, 0);
    expectRefused("render two.json --size=32x24 -o y.png", 1,
                  "two.json: its images and the textures that they become take 1258 MB; 850 MB are the most");
#ifndef GNOMON_SANITIZED
    const auto takesLess = [&] {
        for (const char* scene : {"large", "two"})
            gnomon(std::string("render ") + scene + ".json --size=32x24 -o z.png");
        rusage used{};
        getrusage(RUSAGE_CHILDREN, &used);
        return used.ru_maxrss < 1000000; // KB
    };
    // In a process of its own, which has started no other program before.
    EXPECT_EXIT(std::_Exit(takesLess() ? 0 : 1), testing::ExitedWithCode(0), "");
#endif
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
