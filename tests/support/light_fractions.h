/// Light fractions of receivers under one round light, as the GPU answers them.
#pragma once

#include "lab/batch/light_batch.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace gnomon::test {

constexpr double kAway = 6; ///< of the light, straight above the receivers

inline double tau(double r) {
    r = std::clamp(r, -1.0, 1.0);
    return 0.5 + (r * std::sqrt(1 - r * r) + std::asin(r)) / std::numbers::pi;
}

inline double slopeOf(double radius) {
    const double sine = radius / kAway;
    return sine / std::sqrt(1 - sine * sine);
}

inline Settings settingsFor(ShadowModel model, double epsilon = 1.0 / 256,
                            ConeOrigin coneOrigin = ConeOrigin::Surface) {
    Settings settings;
    settings.shadows = model;
    settings.epsilon = epsilon;
    settings.coneOrigin = coneOrigin;
    settings.shadowSteps = 4000;
    return settings;
}

/// A wall so thick and long that all its shadow comes from one edge, at x = 0 between z = 2 and 4.
constexpr const char* kWall = R"({"box": {"center": [-50, 0, 3], "half_size": [50, 50, 1]}})";

/// A receiver at the origin that looks up at a light `kAway` above it.
inline BatchLit under(double radius, glm::vec3 point = glm::vec3(0)) {
    return {point, 1e-3f, {0, 0, 1}, -1, point + glm::vec3(0, 0, kAway), float(radius)};
}

inline std::vector<double> lightFractionsOf(const std::string& objects, const Settings& settings,
                                            const std::vector<BatchLit>& lit,
                                            std::span<const ShaderFile> overrides = {}) {
    offscreen();
    Problems problems;
    LightBatch batch(sceneFrom(R"({"lights": [{"point": {"position": [0, 0, 9]}}], "objects": [)" + objects + "]}"),
                     settings, problems, overrides);
    EXPECT_TRUE(batch.valid()) << toString(problems);
    std::vector<double> fractions;
    if (batch.valid())
        for (const BatchShade& shade : batch.shade(lit)) fractions.push_back(shade.visibility);
    return fractions;
}

/// Root of the mean squared difference.
inline double apart(const std::vector<double>& a, const std::vector<double>& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(squares / double(a.size()));
}

} // namespace gnomon::test
