/// What the laboratory of shadows makes of its measurements.
#include "native/shadow_tables.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gnomon {
namespace {

ShadowCost cost(ShadowWay way, double seconds, double rmse, double evaluations = 10) {
    ShadowCost one{way, {seconds, seconds, seconds}, evaluations, {}, {}, {}, false};
    one.visibility.rmse = rmse;
    return one;
}

TEST(ShadowErrors, AreOfAllDifferences) {
    std::vector<double> differences(1000, 0.0);
    differences[0] = -0.5;
    differences[1] = 0.1;
    const Errors errors = errorsOf(differences);
    EXPECT_NEAR(errors.rmse, std::sqrt((0.25 + 0.01) / 1000), 1e-12);
    EXPECT_NEAR(errors.mean, -0.4 / 1000, 1e-12);
    EXPECT_EQ(errors.most, 0.5);
    EXPECT_EQ(errors.most999, 0.1);
    EXPECT_EQ(errorsOf({}).rmse, 0);
}

TEST(ShadowWays, TakeWhatTheirModelDependsOn) {
    ShadowPlan plan;
    plan.models = {ShadowModel::Hard, ShadowModel::Montecarlo, ShadowModel::ConeLinear};
    plan.epsilons = {0.1, 0.01};
    plan.samples = {2, 8, 32};
    EXPECT_EQ(waysOf(plan).size(), 1U + 3U + 2U * 2U);
    plan.bothDirections = false;
    EXPECT_EQ(waysOf(plan).size(), 1U + 3U + 2U);
}

TEST(ShadowTables, HoldEveryWayAndItsRivals) {
    const ShadowWay linear{ShadowModel::ConeLinear};
    ShadowCosts costs{
        "simple", 0.5, {1, 1, 1}, {cost(linear, 4, 0.04, 40), cost({ShadowModel::Silhouette}, 2, 0.01, 0)}};
    costs.ways.push_back(cost({ShadowModel::Montecarlo, Direction::FromSurface, 1.0 / 30, 1}, 1.5, 0.2, 0));
    costs.ways.push_back(cost({ShadowModel::Montecarlo, Direction::FromSurface, 1.0 / 30, 16}, 3.9, 0.05, 0));
    costs.ways.push_back(cost({ShadowModel::Montecarlo, Direction::FromSurface, 1.0 / 30, 64}, 12, 0.02, 0));
    EXPECT_EQ(shadowTable({costs}).rows.size(), 5U);
    const Table variants = variantTable({costs});
    ASSERT_EQ(variants.rows.size(), 1U);
    EXPECT_EQ(variants.rows[0][5], Cell(4.0)) << "beside a frame without shadows";
    EXPECT_EQ(variants.rows[0][4], Cell{}) << "the base variant was not measured";
    const Table rivals = rivalTable({costs});
    ASSERT_EQ(rivals.rows.size(), 2U);
    EXPECT_EQ(rivals.rows[0][2], Cell(std::string("silhouette")));
    EXPECT_EQ(rivals.rows[0][3], Cell(0.5));
    EXPECT_EQ(rivals.rows[0][4], Cell(0.25));
    EXPECT_EQ(rivals.rows[1][2], Cell(std::string("montecarlo 16"))) << "the most samples in the same time";
}

} // namespace
} // namespace gnomon
