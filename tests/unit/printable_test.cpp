// What steers a terminal is shown instead of sent to it.
#include "tracer/printable.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

TEST(Printable, LeavesWhatIsOnlySeen) {
    for (const char* text : {"", "plain", "Grüße, 月, 🌍", "back\\slash \"quoted\""}) EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesControlsAndDirectionsAsJsonDoes) {
    EXPECT_EQ(printable("a\x1b[2J\a\x7f"), "a\\u001b[2J\\u0007\\u007f");
    EXPECT_EQ(printable("\xc2\x80\xc2\x9b\xc2\xa0"), "\\u0080\\u009b\xc2\xa0");
    EXPECT_EQ(printable("\u202e\u2066\u2028\ufeff"), "\\u202e\\u2066\\u2028\\ufeff");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "\\u0000");
}

TEST(Printable, KeepsLineEndsOnlyOfTexts) {
    EXPECT_EQ(printable("a\nb\r"), "a\\u000ab\\u000d");
    EXPECT_EQ(printable("a\nb\r", true), "a\nb\\u000d");
}

TEST(Printable, EscapesBytesThatAreNoUtf8) {
    EXPECT_EQ(printable("a\x9b"), "a\\x9b");
    EXPECT_EQ(printable("\xc0\x80"), "\\xc0\\x80") << "a zero byte the long way round";
    EXPECT_EQ(printable("\xe2\x80"), "\\xe2\\x80") << "cut off";
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a surrogate pair";
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
}

} // namespace
} // namespace gnomon
