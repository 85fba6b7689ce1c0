/// The source's shadow models on the GPU: tau and its inverse, the tangent cone, exact answers where the model holds,
/// and what must be the same from both ends of the cone.
#include "tests/support/light_fractions.h"
#include "tracer/render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gnomon {
namespace {

using namespace test;

/// Answers of a function of the shader for `x` in coordinate of a model's, which gets it as the light's radius.
std::vector<double> answersOf(const std::string& expression, const std::vector<double>& xs) {
    const std::string text =
        "// Test\n#include \"shadow/cone.glsl\"\n#include \"shadow/fraction_inverse.glsl\"\n"
        "float visibility(ShadowQuery query) { float x = query.lightRadius; ShadowCone cone = coneOf(query); return " +
        expression + "; }\n";
    const ShaderFile file{"shadow/cone_base.glsl", text};
    std::vector<BatchLit> lit;
    for (const double x : xs) lit.push_back(under(x));
    return lightFractionsOf(R"({"sphere": {"center": [99, 0, 0], "radius": 1}})", settingsFor(ShadowModel::ConeBase),
                            lit, {&file, 1});
}

TEST(LightFraction, IsTauAndItsInverse) {
    std::vector<double> xs;
    for (int i = 0; i <= 2000; ++i) xs.push_back(i / 1000.0);
    const auto fractions = answersOf("fractionOf(x - 1.0)", xs),
               back = answersOf("fractionOf(fractionInverse(0.5 * x))", xs);
    ASSERT_EQ(fractions.size(), xs.size());
    for (std::size_t i = 0; i < xs.size(); ++i) {
        EXPECT_NEAR(fractions[i], tau(xs[i] - 1), 1e-6) << xs[i] - 1;
        EXPECT_NEAR(back[i], xs[i] / 2, 2e-6) << xs[i] / 2;
    }
}

TEST(TangentCone, TouchesBothSpheres) {
    const std::vector<double> radii{0, 0.05, 0.3, 1, 2, 4, 5.5};
    const auto slopes = answersOf("cone.slope", radii), starts = answersOf("cone.radius", radii),
               lengths = answersOf("cone.reach", radii);
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double r0 = 5e-4, length = kAway - r0, sine = (radii[i] - r0) / length,
                     cosine = std::sqrt(1 - sine * sine);
        EXPECT_NEAR(lengths[i], length, 1e-5);
        EXPECT_NEAR(slopes[i], sine / cosine, 1e-6 / cosine / cosine / cosine) << radii[i];
        EXPECT_NEAR(starts[i], r0 / cosine, 1e-9 / cosine) << radii[i];
    }
}

constexpr ShadowModel kCones[] = {ShadowModel::ConeBase, ShadowModel::ConeLinear, ShadowModel::ConeDiscrete,
                                  ShadowModel::ConeConvex};

class Cones : public testing::TestWithParam<std::tuple<ShadowModel, ConeOrigin>> {
  protected:
    ShadowModel model_ = std::get<0>(GetParam());
    Settings settings(double epsilon = 1.0 / 256) { return settingsFor(model_, epsilon, std::get<1>(GetParam())); }
};

/// kWall about z = 3, as thick as asked for.
std::string wall(double half) {
    return R"({"box": {"center": [-50, 0, 3], "half_size": [50, 50, )" + std::to_string(half) + "]}}";
}

double toWall(double x, double z, double half) {
    const double dx = x, dz = std::abs(z - 3) - half;
    return dx > 0 && dz > 0 ? std::hypot(dx, dz) : std::max(dx, dz);
}

/// tau of the least relative distance along the cone from the surface sphere to the light, by looking everywhere.
double leastFraction(double x, double radius, double half) {
    const double r0 = 5e-4, length = kAway - r0, sine = (radius - r0) / length, cosine = std::sqrt(1 - sine * sine);
    double least = 1;
    for (int i = 0; i <= 200000; ++i) {
        const double t = length * i / 200000.0;
        least = std::min(least, toWall(x, r0 + t, half) / (r0 / cosine + t * sine / cosine));
    }
    return tau(least);
}

TEST_P(Cones, FindTheLeastRelativeDistance) {
    for (const double radius : {0.05, 0.25, 1.0, 3.0}) {
        const double half = std::min(1.5, 4 * slopeOf(radius));
        std::vector<BatchLit> lit;
        for (int i = -15; i <= 15; ++i) lit.push_back(under(radius, {float(i / 12.0 * 3 * slopeOf(radius)), 0, 0}));
        const auto fractions = lightFractionsOf(wall(half), settings(1.0 / 128), lit);
        for (std::size_t i = 0; i < lit.size(); ++i)
            EXPECT_NEAR(fractions[i], leastFraction(lit[i].point.x, radius, half), 1.0 / 128 + 1e-3)
                << "radius " << radius << " x " << lit[i].point.x;
    }
}

/// Where what hides the light is the half plane that the model takes it for: a wall that is thin against its distance
/// and thick against the cone, under a small light.
TEST_P(Cones, FindTheLightFractionAtAnEdge) {
    for (const double radius : {0.05, 0.1}) {
        const double slope = slopeOf(radius), half = 4 * slope;
        std::vector<BatchLit> lit;
        for (int i = -60; i <= 60; ++i) lit.push_back(under(radius, {float(i / 50.0 * 3 * slope), 0, 0}));
        const auto fractions = lightFractionsOf(wall(half), settings(), lit);
        for (std::size_t i = 0; i < lit.size(); ++i) {
            const double x = lit[i].point.x, exact = tau(std::min(x / (3 - half), x / (3 + half)) / slope);
            EXPECT_NEAR(fractions[i], exact, 0.01) << "radius " << radius << " x " << x;
        }
    }
}

TEST_P(Cones, KnowNothingAndEverything) {
    for (const double radius : {0.0, 0.05, 1.0, 4.0}) {
        const auto fraction = [&](const char* objects) {
            return lightFractionsOf(objects, settings(), {under(radius)})[0];
        };
        const double level = model_ == ShadowModel::ConeDiscrete ? 0.01 : 1e-3;
        // A cone that touches the surface sphere at its start finds cos(alpha) there, not 1.
        const double widest = tau(std::sqrt(1 - radius * radius / kAway / kAway));
        EXPECT_GE(fraction(R"({"sphere": {"center": [90, 0, 0], "radius": 1}})"), 1 - level) << radius;
        EXPECT_GE(fraction(R"({"plane": {"point": [0, 0, 0], "normal": [0, 0, 1]}})"), widest - 0.01) << radius;
        // A wider cone than these are thick is not filled by what they are deep.
        if (radius <= 1) {
            EXPECT_LE(fraction(R"({"box": {"center": [0, 0, 3], "half_size": [40, 40, 2]}})"), 0.01) << radius;
            EXPECT_LE(fraction(R"({"sphere": {"center": [0, 0, 6], "radius": 5}})"), 0.01)
                << "light inside, " << radius;
        }
        EXPECT_GE(fraction(R"({"box": {"center": [0, 0, 20], "half_size": [40, 40, 2]}})"), 1 - level)
            << "beyond, radius " << radius;
    }
}

TEST_P(Cones, StayWithinBoundsWhereThePointIsOnTheLight) {
    BatchLit on = under(4, {0, 0, 0});
    on.light = on.point + glm::vec3(0, 0, 1);
    BatchLit at = on;
    at.light = at.point;
    for (const double fraction : lightFractionsOf(kWall, settings(), {on, at})) {
        EXPECT_GE(fraction, 0);
        EXPECT_LE(fraction, 1);
    }
}

TEST_P(Cones, EndAHardShadowWithinAPixel) {
    std::vector<BatchLit> lit;
    for (int i = -200; i <= 200; ++i) {
        lit.push_back(under(0, {float(i) * 5e-4f, 0, 0}));
        lit.back().width = 0.02f;
    }
    const auto fractions = lightFractionsOf(kWall, settings(), lit);
    bool between = false;
    for (std::size_t i = 0; i < lit.size(); ++i) {
        const float x = lit[i].point.x;
        if (std::abs(x) > 0.02f) {
            EXPECT_NEAR(fractions[i], x > 0 ? 1 : 0, 0.01) << x;
        }
        between |= fractions[i] > 0.2 && fractions[i] < 0.8;
    }
    EXPECT_TRUE(between) << "the edge is smooth";
}

INSTANTIATE_TEST_SUITE_P(All, Cones,
                         testing::Combine(testing::ValuesIn(kCones),
                                          testing::Values(ConeOrigin::Surface, ConeOrigin::Light)),
                         [](const auto& test) {
                             std::string name(shadowRow(std::get<0>(test.param)).key);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name + (std::get<1>(test.param) == ConeOrigin::Surface ? "_A" : "_B");
                         });

constexpr const char* kOccluders = R"({"sphere": {"center": [0.3, 0.2, 2.5], "radius": 0.6}},
    {"capsule": {"from": [-1.5, -1, 2], "to": [-1, 1.2, 3], "radius": 0.2}},
    {"torus": {"center": [1.4, -0.6, 2], "axis": [0.3, 0.2, 1], "major_radius": 0.6, "minor_radius": 0.2}},
    {"smooth_union": [{"sphere": {"center": [0.2, 1.8, 2], "radius": 0.4}}, {"sphere": {"center": [0.8, 1.6, 2.3],
        "radius": 0.3}}]})";

std::vector<BatchLit> everywhere(double radius) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> coordinate(-2.5f, 2.5f);
    std::vector<BatchLit> lit;
    for (int i = 0; i < 3000; ++i) lit.push_back(under(radius, {coordinate(random), coordinate(random), 0}));
    return lit;
}

TEST(ConeOrigins, FindTheSameLightFraction) {
    for (const ShadowModel model : {ShadowModel::ConeBase, ShadowModel::ConeLinear, ShadowModel::ConeConvex})
        for (const double radius : {0.1, 0.5, 1.5})
            for (const double epsilon : {1.0 / 30, 1.0 / 128}) {
                const auto lit = everywhere(radius);
                const auto a = lightFractionsOf(kOccluders, settingsFor(model, epsilon), lit);
                const auto b = lightFractionsOf(kOccluders, settingsFor(model, epsilon, ConeOrigin::Light), lit);
                for (std::size_t i = 0; i < a.size(); ++i)
                    ASSERT_NEAR(a[i], b[i], 1.1 * epsilon + 1e-3) << shadowRow(model).key << " radius " << radius
                                                                  << " at " << lit[i].point.x << " " << lit[i].point.y;
            }
}

TEST(Epsilon, BringsTheLightFractionNearerAsItFalls) {
    for (const ShadowModel model :
         {ShadowModel::ConeBase, ShadowModel::ConeLinear, ShadowModel::ConeDiscrete, ShadowModel::ConeConvex}) {
        const auto lit = everywhere(0.8);
        const auto exact = lightFractionsOf(kOccluders, settingsFor(ShadowModel::ConeLinear, 1.0 / 1024), lit);
        double before = 1;
        for (const double epsilon : {0.5, 0.25, 0.125, 1.0 / 16, 1.0 / 32, 1.0 / 64, 1.0 / 128}) {
            const double error = apart(lightFractionsOf(kOccluders, settingsFor(model, epsilon), lit), exact);
            EXPECT_LE(error, before * 1.02 + 1e-4) << shadowRow(model).key << " " << epsilon;
            EXPECT_LE(error, epsilon) << shadowRow(model).key << " " << epsilon;
            before = error;
        }
    }
}

} // namespace
} // namespace gnomon
