/// What the laboratory of shadows makes of its measurements.
#include "lab/shadows/shadow_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

ShadowCost cost(ShadowWay way, double seconds, double rmse, double evaluations = 10) {
    ShadowCost one{way, {seconds, seconds, seconds}, evaluations, {}, {}, {}, false, {}};
    one.visibility.rmse = rmse;
    one.picture.rmse = rmse / 2;
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
    plan.models = {ShadowModel::Hard, ShadowModel::Montecarlo, ShadowModel::MontecarloMarch, ShadowModel::ConeLinear};
    plan.epsilons = {0.1, 0.01};
    plan.samples = {2, 8, 32};
    EXPECT_EQ(waysOf(plan).size(), 1U + 3U + 3U + 2U * 2U);
    plan.bothOrigins = false;
    EXPECT_EQ(waysOf(plan).size(), 1U + 3U + 3U + 2U);
}

TEST(ShadowTables, HoldEveryWayAndItsRivals) {
    const ShadowWay linear{ShadowModel::ConeLinear};
    ShadowCosts costs{
        "simple", 0.5, {1, 1, 1}, {cost(linear, 4, 0.04, 40), cost({ShadowModel::Silhouette}, 2, 0.01, 0)}, {}};
    costs.ways.push_back(cost({ShadowModel::Montecarlo, ConeOrigin::Surface, 1.0 / 30, 1}, 1.5, 0.2, 0));
    costs.ways.push_back(cost({ShadowModel::Montecarlo, ConeOrigin::Surface, 1.0 / 30, 16}, 3.9, 0.05, 0));
    costs.ways.push_back(cost({ShadowModel::Montecarlo, ConeOrigin::Surface, 1.0 / 30, 64}, 12, 0.02, 0));
    costs.ways.push_back(cost({ShadowModel::MontecarloMarch, ConeOrigin::Surface, 1.0 / 30, 16}, 20, 0.06, 160));
    costs.ways.push_back(cost({ShadowModel::MontecarloMarch, ConeOrigin::Surface, 1.0 / 30, 4}, 6, 0.12, 38));
    costs.ways.push_back(cost({ShadowModel::MontecarloMarch, ConeOrigin::Surface, 1.0 / 30, 2}, 4.5, 0.2, 20));
    EXPECT_EQ(shadowTable({costs}).rows.size(), 8U);
    const Table variants = variantTable({costs});
    ASSERT_EQ(variants.rows.size(), 1U);
    EXPECT_EQ(variants.rows[0][5], Cell(4.0)) << "beside a frame without shadows";
    EXPECT_EQ(variants.rows[0][4], Cell{}) << "the base variant was not measured";
    const Table rivals = rivalTable({costs});
    ASSERT_EQ(rivals.rows.size(), 4U);
    EXPECT_EQ(rivals.rows[0][2], Cell(std::string("silhouette")));
    EXPECT_EQ(rivals.rows[0][3], Cell(0.5));
    EXPECT_EQ(rivals.rows[0][4], Cell(0.25));
    EXPECT_EQ(rivals.rows[1][2], Cell(std::string("montecarlo 16"))) << "the most samples in the same time";
    EXPECT_EQ(rivals.rows[2][2], Cell(std::string("montecarlo-march 2"))) << "all take longer: the fastest";
    EXPECT_EQ(rivals.rows[3][2], Cell(std::string("montecarlo-march 4"))) << "the most in as many evaluations";
    EXPECT_EQ(rivals.rows[3][4], Cell(3.0)) << "error of the fraction";
    EXPECT_EQ(rivals.rows[3][5], Cell(3.0)) << "and of the picture";
    EXPECT_EQ(rivals.rows[3][6], Cell(0.95)) << "evaluations";
}

TEST(ShadowTables, TakeARoundedEpsilonForWhatItIsCalled) {
    ShadowWay linear{ShadowModel::ConeLinear};
    linear.epsilon = 0.0333333;
    const ShadowCosts costs{"simple", 0.5, {1}, {cost(linear, 4, 0.04), cost({ShadowModel::Quilez}, 2, 0.1)}, {}};
    EXPECT_EQ(rivalTable({costs}).rows.size(), 1U);
}

TEST(ShadowTables, DrawTheFrontOfEachRadiusApart) {
    const std::vector<ShadowCosts> one{{"simple", 0.5, {1}, {}, {}}, {"complex", 1, {1}, {}, {}}};
    ASSERT_EQ(shadowCharts(one).size(), 2U) << "a light for each scene: one row of charts";
    EXPECT_EQ(shadowCharts(one).front().front, "front");
    const std::vector<ShadowCosts> two{{"simple", 0.5, {1}, {}, {}}, {"simple", 1, {1}, {}, {}}};
    ASSERT_EQ(shadowCharts(two).size(), 3U);
    EXPECT_EQ(shadowCharts(two).front().where.front().second, "0.5");
}

TEST(ShadowTables, HoldEveryPictureAgainstTheReference) {
    const auto image = [](std::uint8_t value) { return Image{1, 1, {value, value, value, 255}}; };
    ShadowCosts costs{
        "simple", 0.5, {1}, {cost({ShadowModel::Quilez}, 1, 1), cost({ShadowModel::Hard}, 1, 1)}, image(9)};
    costs.ways[0].image = image(9);
    costs.ways[1].image = image(5);
    Results results{"", "", {}, {shadowTable({costs})}, {}};
    addShadowPictures({costs}, "exact", results);
    ASSERT_EQ(results.pictures.size(), 2U);
    EXPECT_EQ(results.images.size(), 2U) << "the same image only once";
    EXPECT_EQ(results.pictures[0].image, *results.pictures[0].reference);
    EXPECT_NE(results.pictures[1].image, *results.pictures[1].reference);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_TRUE(std::equal(results.pictures[i].row.begin(), results.pictures[i].row.end(),
                               results.tables[0].rows[i].begin()))
            << "its row's keys";
}

} // namespace
} // namespace gnomon
