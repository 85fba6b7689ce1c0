/// Pictures beside the oracle's: see scenes_test.cpp for what is claimed. GNOMON_PICTURES=FOLDER keeps both of each
/// test.
#pragma once

#include "lab/reference/exact/picture.h"
#include "native/file/image_file.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace gnomon::test {

using oracle::Difference;
using oracle::Picture;

/// A quarter of one step of an eight-bit channel. The peak of a highlight may fall between the oracle's samples, at
/// most 1/8 pixel from one: where a pixel turns the normal by a, that is specular * shininess * a² / 128 short of the
/// peak, here at most 7.4e-4 (the still life's torus: 0.3, 20, 0.126; the torus in the open: 0.5, 40, 0.058). Float32
/// adds 1e-5: a few roundings of a unit normal, 2^-22, times shininess.
constexpr double kTolerance = 1.0 / 1024;

inline Settings sized(int width, int height, int depth = 4) {
    Settings settings;
    settings.size = {width, height};
    settings.depth = depth;
    settings.threshold = 0; // the oracle follows every ray
    return settings;
}

inline std::uint8_t encoded(double linear) {
    const double c = std::clamp(linear, 0.0, 1.0);
    const double shown = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    return std::uint8_t(std::lround(255 * shown));
}

template<typename ColorAt>
inline void save(const std::string& name, int width, int height, ColorAt colorAt) {
    const char* folder = std::getenv("GNOMON_PICTURES");
    if (!folder) return;
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 color = colorAt(x, y);
            for (int c = 0; c < 3; ++c) image.rgba.push_back(encoded(color[c]));
            image.rgba.push_back(255);
        }
    Problems problems;
    writeImage(std::string(folder) + "/" + name + ".png", image, problems);
    EXPECT_EQ(toString(problems), "");
}

/// Compares, tells the figures, keeps the pictures.
inline Difference held(const std::string& name, const FloatImage& image, const Picture& oracle) {
    save(name, image.width, image.height, [&](int x, int y) {
        const float* p = image.at(x, y);
        return glm::dvec3(p[0], p[1], p[2]);
    });
    save(name + "-oracle", image.width, image.height, [&](int x, int y) { return oracle.middle(x, y); });
    const Difference d = compare(image, oracle, kTolerance);
    std::printf("%s: %d outliers, worst %.2g at (%d, %d), %d moved, rmse %.2g\n", name.c_str(), d.outliers, d.worst,
                d.worstAt.x, d.worstAt.y, d.moved, d.rmse);
    return d;
}

inline Difference differenceOf(const std::string& name, const Scene& scene, const Settings& settings) {
    return held(name, outputOf(scene, settings, Aov::Color),
                Picture(scene, settings.size.x, settings.size.y, settings.depth));
}

} // namespace gnomon::test
