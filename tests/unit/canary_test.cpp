// What the canary says, and when it says that the numerics hold.
#include "tracer/lab/canary.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace gnomon {
namespace {

Canary good() {
    Canary canary;
    canary.measured = true;
    canary.rays = 2048;
    canary.worstPoint = 1.31;
    canary.worstAlong = 0.5;
    return canary;
}

bool begins(const std::string& text, const std::string& with) { return text.rfind(with, 0) == 0; }

TEST(Canary, HoldsWithinItsBoundsOnly) {
    EXPECT_TRUE(good().holds());
    EXPECT_FALSE(Canary{}.holds());
    Canary wrong = good(), point = good(), along = good(), none = good();
    wrong.wrong = 1;
    point.worstPoint = 4.01;
    along.worstAlong = 1.51;
    none.rays = 0;
    for (const Canary& canary : {wrong, point, along, none}) EXPECT_FALSE(canary.holds()) << toString(canary);
}

TEST(Canary, SaysInOneLineWhatItFoundAndWhatThatMeans) {
    EXPECT_EQ(toString(good()), "numerics exact: 0 of 2048 decisions wrong, surface point within 1.3 · 2^-23, "
                                "distance within 0.5 ulp");
    Canary bad = good();
    bad.wrong = 311;
    EXPECT_TRUE(begins(toString(bad), "numerics NOT EXACT: 311 of 2048 decisions wrong")) << toString(bad);
    EXPECT_NE(toString(bad).find("; this driver changes float arithmetic"), std::string::npos) << toString(bad);
    Canary unable;
    unable.problem = "no float32 pictures";
    EXPECT_EQ(toString(unable), "numerics not measured: no float32 pictures");
}

TEST(Canary, IsTheSameAsJson) {
    const auto json = nlohmann::json::parse(toJson(good()));
    EXPECT_EQ(json["rays"], 2048);
    EXPECT_EQ(json["holds"], true);
    EXPECT_EQ(json["worst_point"], 1.31);
    EXPECT_EQ(json["summary"], toString(good()));
}

} // namespace
} // namespace gnomon
