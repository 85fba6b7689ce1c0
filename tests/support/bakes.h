/// Fields as tests bake, read and judge them. Errors are told in sizes of the patch: the greater of its longer side and
/// the range of its heights.
#pragma once

#include "tracer/render/pass/bake_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace gnomon::test {

inline CodegenTarget bakeTarget() { return {.es300 = gl::info().essl300}; }

inline std::vector<float> readField(const gl::Volume& field) {
    std::vector<float> distances;
    std::vector<glm::vec4> slice(std::size_t(field.size.x * field.size.y));
    glBindFramebuffer(GL_FRAMEBUFFER, field.framebuffer.get());
    for (int z = 0; z < field.size.z; ++z) {
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, field.texture.get(), 0, z);
        glReadPixels(0, 0, field.size.x, field.size.y, GL_RGBA, GL_FLOAT, slice.data());
        for (const glm::vec4& texel : slice) distances.push_back(texel.x);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return distances;
}

/// Programs are kept for the tests that follow in the same context.
struct Baker {
    ProgramCache cache{false};
    BakePass pass;
    gl::Volume field;
    Problems problems;

    void begin(const FieldBake& bake) {
        field = gl::makeVolume(glm::ivec3(bake.resolution), bake.format, false);
        EXPECT_TRUE(pass.begin(bake, bakeTarget(), problems)) << toString(problems);
    }
    void go(int slices) { EXPECT_TRUE(pass.step(cache, field, {}, slices, problems)) << toString(problems); }
    void finish(int slices = 1 << 20) {
        while (pass.done() < 1 && problems.empty()) go(slices);
    }
    std::vector<float> operator()(const FieldBake& bake) {
        begin(bake);
        finish();
        return readField(field);
    }
};

/// Over the patch's rectangle and the range of its heights, with room above and below.
inline FieldBox fieldBoxOf(const Heights& heights, glm::dvec3 center, glm::dvec3 size) {
    auto [low, high] = heightRange(heights);
    low *= size.y;
    high *= size.y;
    const double margin = 0.05 * std::max({size.x, size.z, high - low});
    return {center + glm::dvec3(-size.x / 2, low - margin, -size.z / 2),
            center + glm::dvec3(size.x / 2, high + margin, size.z / 2)};
}

inline FieldBake bakeOf(const Heights& heights, int resolution, BakeMethod method = BakeMethod::Exact,
                        glm::dvec3 center = glm::dvec3(0), glm::dvec3 size = glm::dvec3(1)) {
    FieldBake bake{heights, center, size, fieldBoxOf(heights, center, size), resolution};
    bake.method = method;
    return bake;
}

inline double sizeOf(const FieldBake& bake) {
    const auto [low, high] = heightRange(bake.heights);
    return std::max({bake.size.x, bake.size.z, (high - low) * bake.size.y});
}

inline glm::dvec3 sampleOf(const FieldBake& bake, std::size_t texel) {
    const std::size_t n = std::size_t(bake.resolution);
    const glm::dvec3 index(double(texel % n), double(texel / n % n), double(texel / n / n));
    return bake.box.low + (bake.box.high - bake.box.low) * index / double(n - 1);
}

inline std::string placeOf(const FieldBake& bake, std::size_t texel) {
    const std::size_t n = std::size_t(bake.resolution);
    return " at texel " + std::to_string(texel % n) + " " + std::to_string(texel / n % n) + " " +
           std::to_string(texel / n / n);
}

/// By how much texels are wrong, in sizes of the patch.
using Signed = std::function<double(glm::dvec3)>;
inline std::vector<double> errorsOf(const FieldBake& bake, const std::vector<float>& field, const Signed& truth) {
    std::vector<double> errors(field.size());
    const double size = sizeOf(bake);
    for (std::size_t i = 0; i < field.size(); ++i)
        errors[i] = std::abs(double(field[i]) - truth(sampleOf(bake, i))) / size;
    return errors;
}

inline double worst(const std::vector<double>& errors) {
    double most = 0;
    for (const double error : errors) most = error <= most ? most : error; // what is no number is worst
    return most;
}

} // namespace gnomon::test
