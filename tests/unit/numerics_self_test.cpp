// What the numerics self-test says, and when it says that the numerics hold.
#include "lab/batch/numerics_self_test.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace gnomon {
namespace {

NumericsSelfTest good() {
    NumericsSelfTest selfTest;
    selfTest.measured = true;
    selfTest.rays = 2048;
    selfTest.worstPoint = 1.31;
    selfTest.worstAlong = 0.5;
    return selfTest;
}

bool begins(const std::string& text, const std::string& with) { return text.rfind(with, 0) == 0; }

TEST(NumericsSelfTest, HoldsWithinItsBoundsOnly) {
    EXPECT_TRUE(good().holds());
    EXPECT_FALSE(NumericsSelfTest{}.holds());
    NumericsSelfTest wrong = good(), point = good(), along = good(), none = good();
    wrong.wrong = 1;
    point.worstPoint = 4.01;
    along.worstAlong = 1.51;
    none.rays = 0;
    for (const NumericsSelfTest& selfTest : {wrong, point, along, none})
        EXPECT_FALSE(selfTest.holds()) << toString(selfTest);
}

TEST(NumericsSelfTest, SaysInOneLineWhatItFoundAndWhatThatMeans) {
    EXPECT_EQ(toString(good()), "numerics exact: 0 of 2048 decisions wrong, surface point within 1.3 · 2^-23, "
                                "distance within 0.5 ulp");
    NumericsSelfTest bad = good();
    bad.wrong = 311;
    EXPECT_TRUE(begins(toString(bad), "numerics NOT EXACT: 311 of 2048 decisions wrong")) << toString(bad);
    EXPECT_NE(toString(bad).find("; this driver changes float arithmetic"), std::string::npos) << toString(bad);
    NumericsSelfTest unable;
    unable.problem = "no float32 pictures";
    EXPECT_EQ(toString(unable), "numerics not measured: no float32 pictures");
}

TEST(NumericsSelfTest, IsTheSameAsJson) {
    const auto json = nlohmann::json::parse(toJson(good()));
    EXPECT_EQ(json["rays"], 2048);
    EXPECT_EQ(json["holds"], true);
    EXPECT_EQ(json["worst_point"], 1.31);
    EXPECT_EQ(json["summary"], toString(good()));
}

} // namespace
} // namespace gnomon
