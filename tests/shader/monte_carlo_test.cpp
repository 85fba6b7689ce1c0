/// Shadow models that take samples of a light: light fractions behind known shapes, and as many samples as asked for.
#include "tests/support/light_fractions.h"
#include "tracer/render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

using namespace test;

/// Of the models that take samples of a light.
class MonteCarlo : public testing::TestWithParam<ShadowModel> {
  protected:
    Settings settings(int samples) {
        Settings settings = settingsFor(GetParam());
        settings.samples = samples;
        return settings;
    }

    /// In parts: llvmpipe ends all loops of a pixel early.
    std::vector<double> lightFractionsOfMany(const std::string& objects, int samples,
                                             const std::vector<BatchLit>& lit) {
        constexpr int kMost = 256;
        Settings part = settings(std::min(samples, kMost));
        std::vector<double> means(lit.size());
        for (; part.firstSample < samples; part.firstSample += kMost) {
            const auto fractions = lightFractionsOf(objects, part, lit);
            for (std::size_t i = 0; i < fractions.size(); ++i) means[i] += fractions[i] * part.samples / samples;
        }
        return means;
    }
};

/// What so many samples may be off, as root of the mean square.
double samplingError(int samples) { return 0.6 / std::pow(samples, 0.75); }

TEST_P(MonteCarlo, ConvergesToTheLightFractionAtAnEdge) {
    double before = 1;
    for (const int samples : {16, 256, 4096}) {
        std::vector<BatchLit> lit;
        const double slope = slopeOf(2);
        for (int i = -60; i <= 60; ++i) lit.push_back(under(2, {float(i / 50.0 * 4 * slope), 0, 0}));
        const auto fractions = lightFractionsOfMany(kWall, samples, lit);
        std::vector<double> exact;
        for (const BatchLit& one : lit) exact.push_back(tau(std::min(one.point.x / 2, one.point.x / 4) / slope));
        const double error = apart(fractions, exact);
        EXPECT_LE(error, samplingError(samples)) << samples;
        EXPECT_LT(error, before);
        before = error;
    }
}

/// Of a sphere before the middle of the light: the sines of both are known, and the fraction is that of two discs.
TEST_P(MonteCarlo, FindsTheLightFractionBehindASphere) {
    constexpr int kSamples = 256;
    const std::vector<BatchLit> lit(100, under(2));
    for (const double radius : {0.1, 0.3, 0.6, 0.9}) {
        const double sine = radius / 3, covered = sine / std::sqrt(1 - sine * sine) / slopeOf(2);
        const auto fractions = lightFractionsOf(
            R"({"sphere": {"center": [0, 0, 3], "radius": )" + std::to_string(radius) + "}}", settings(kSamples), lit);
        const std::vector<double> exact(lit.size(), 1 - covered * covered);
        EXPECT_LE(apart(fractions, exact), samplingError(kSamples)) << radius;
    }
}

TEST_P(MonteCarlo, KnowsNothingAndEverything) {
    const std::string ground = R"({"plane": {"point": [0, 0, 0], "normal": [0, 0, 1]}})";
    for (const double radius : {0.0, 0.05, 1.0, 4.0}) {
        BatchLit onGround = under(radius);
        onGround.object = 0;
        const auto fraction = [&](const std::string& objects) {
            return lightFractionsOf(ground + objects, settings(64), {onGround})[0];
        };
        EXPECT_EQ(fraction(""), 1) << radius;
        EXPECT_EQ(fraction(R"(, {"box": {"center": [0, 0, 20], "half_size": [40, 40, 2]}})"), 1)
            << "beyond, " << radius;
        EXPECT_EQ(fraction(R"(, {"box": {"center": [0, 0, 3], "half_size": [40, 40, 2]}})"), 0) << radius;
        EXPECT_EQ(fraction(R"(, {"box": {"center": [0, 0, 6], "half_size": [5, 5, 5]}})"), 0)
            << "light inside, " << radius;
    }
}

TEST_P(MonteCarlo, SeesHalfOfALightOnTheHorizon) {
    BatchLit level = under(2);
    level.object = 0;
    level.light = {kAway, 0, 0};
    constexpr int kSamples = 256;
    const std::vector<BatchLit> lit(100, level);
    const auto fractions =
        lightFractionsOf(R"({"plane": {"point": [0, 0, 0], "normal": [0, 0, 1]}})", settings(kSamples), lit);
    EXPECT_LE(apart(fractions, std::vector<double>(lit.size(), 0.5)), samplingError(kSamples));
}

/// Some GLs end all loops of a pixel early: as many samples at once as a user may ask for must not be fewer.
TEST_P(MonteCarlo, TakesAsManySamplesAsAsked) {
    offscreen();
    const int stretch = shadowRow(GetParam()).batch, all = 32 * stretch, part = stretch / 4;
    Settings settings = this->settings(part);
    settings.size = {24, 18};
    settings.depth = 1;
    settings.lightRadius = 0.5;
    const Scene scene = sceneNamed("mandelbulb");
    std::vector<double> means;
    for (int first = 0; first < all; first += part) {
        settings.firstSample = first;
        const FloatImage fractions = outputOf(scene, settings, Aov::Visibility);
        means.resize(fractions.pixels.size());
        for (std::size_t i = 0; i < means.size(); ++i) means[i] += double(fractions.pixels[i]) * part / all;
    }
    settings.firstSample = 0;
    settings.samples = all;
    const FloatImage whole = outputOf(scene, settings, Aov::Visibility);
    ASSERT_EQ(whole.pixels.size(), means.size());
    EXPECT_GT(std::count_if(means.begin(), means.end(), [](double v) { return v > 0.01 && v < 0.99; }), 10);
    for (std::size_t i = 0; i < means.size(); ++i) EXPECT_NEAR(whole.pixels[i], means[i], 1e-6) << i;
}

std::vector<ShadowModel> samplingModels() {
    std::vector<ShadowModel> models;
    for (const ShadowRow& row : kShadowModels)
        if (row.batch > 0) models.push_back(row.model);
    return models;
}

INSTANTIATE_TEST_SUITE_P(All, MonteCarlo, testing::ValuesIn(samplingModels()), [](const auto& test) {
    std::string name(shadowRow(test.param).key);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

/// Traces through distances look at the same points as rays to shapes. They start half a pixel beside the surface,
/// which moves shadows less than samples are off where pixels are small.
TEST(MonteCarloMarch, SeesWhatRaysSee) {
    offscreen();
    Settings settings = settingsFor(ShadowModel::Montecarlo);
    settings.size = {640, 480};
    settings.depth = 1;
    const Scene scene = sceneNamed("simple");
    const auto fractions = [&](ShadowModel model, int samples) {
        settings.shadows = model;
        settings.samples = samples;
        const FloatImage image = outputOf(scene, settings, Aov::Visibility);
        return std::vector<double>(image.pixels.begin(), image.pixels.end());
    };
    const auto rays = fractions(ShadowModel::Montecarlo, 4);
    const double noise = apart(rays, fractions(ShadowModel::Montecarlo, 64));
    EXPECT_LE(apart(fractions(ShadowModel::MontecarloMarch, 4), rays), noise);
}

/// What is averaged is light, and encoded once: a picture of two stretches is that of their mean.
TEST(MonteCarloPicture, AveragesLightNotPixels) {
    offscreen();
    Settings settings = settingsFor(ShadowModel::Montecarlo);
    settings.size = {64, 48};
    settings.lightRadius = 1;
    for (const char* name : {"pro", "mandelbulb"}) { // with the sRGB curve and without
        const Scene scene = sceneNamed(name);
        const auto pictureOf = [&](int samples) {
            Problems problems;
            Renderer renderer;
            settings.samples = samples;
            EXPECT_TRUE(renderer.setScene(scene, problems));
            renderer.configure(settings);
            EXPECT_TRUE(renderer.finish(problems)) << toString(problems);
            return renderer.readPicture({scene.camera, 0, settings.size.x, settings.size.y}, problems);
        };
        const Image once = pictureOf(32), mean = pictureOf(33);
        ASSERT_EQ(mean.rgba.size(), once.rgba.size());
        double bias = 0;
        int most = 0;
        for (std::size_t i = 0; i < once.rgba.size(); ++i) {
            const int off = int(mean.rgba[i]) - once.rgba[i];
            bias += double(off) / double(once.rgba.size());
            most = std::max(most, std::abs(off));
        }
        EXPECT_LT(std::abs(bias), 0.05) << name;
        EXPECT_LE(most, 16) << name << ": one ray of 33 may change a pixel by so much";
    }
}

} // namespace
} // namespace gnomon
