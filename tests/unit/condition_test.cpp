#include "tracer/shader/condition.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

std::optional<int> evaluate(std::string_view text) {
    std::string error;
    return evaluateCondition(
        text,
        [](std::string_view name) -> std::optional<int> {
            if (name == "ONE") return 1;
            if (name == "ZERO") return 0;
            if (name == "SEVEN") return 7;
            return std::nullopt;
        },
        error);
}

TEST(Condition, KnowsNumbersAndNames) {
    EXPECT_EQ(evaluate("12"), 12);
    EXPECT_EQ(evaluate(" SEVEN "), 7);
}

TEST(Condition, BindsNotTighterThanComparisonTighterThanAndTighterThanOr) {
    EXPECT_EQ(evaluate("ONE || ZERO && ZERO"), 1);
    EXPECT_EQ(evaluate("(ONE || ZERO) && ZERO"), 0);
    EXPECT_EQ(evaluate("!ZERO && SEVEN > 3"), 1);
    EXPECT_EQ(evaluate("SEVEN == 7 && SEVEN != 8 && SEVEN <= 7 && SEVEN >= 7 && !(SEVEN < 7)"), 1);
}

TEST(Condition, RefusesWhatItDoesNotUnderstand) {
    EXPECT_FALSE(evaluate("UNKNOWN"));
    EXPECT_FALSE(evaluate(""));
    EXPECT_FALSE(evaluate("(ONE"));
    EXPECT_FALSE(evaluate("ONE ONE"));
    EXPECT_FALSE(evaluate("ONE &&"));
}

} // namespace
} // namespace gnomon
