/// Fields of height patches as the GPU bakes them, beside the certified distance (lab/reference/exact/patch_distance.h)
/// and beside what else is known of them.
///
/// Size    of a patch: the greater of its longer side and the range of its heights; errors are told in it
/// Bounds  those that shaders/pass/bake_*.frag and shaders/field state
/// Scope   GNOMON_BAKES says how many random patches the exact field is held against, 40 unless it does

#include "lab/reference/exact/patch_distance.h"
#include "tests/support/bakes.h"
#include "tests/support/offscreen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

namespace gnomon {
namespace {

using namespace test;

Signed certified(const FieldBake& bake) {
    const oracle::PatchDistance exact(bake.heights, bake.center, bake.size);
    return [exact](glm::dvec3 q) { return exact.signedDistance(q); };
}

Heights heightsOf(const std::function<double(double u, double v)>& control) {
    Heights heights;
    for (std::size_t i = 0; i < 16; ++i) heights[i] = control(double(i % 4) / 3, double(i / 4) / 3);
    return heights;
}

// ---- The exact field

constexpr double kBound = 1e-5, kMostly = 3e-7; // the latter but for one in a thousand

TEST(ExactBake, OfRandomPatchesIsTheCertifiedDistance) {
    offscreen();
    const char* asked = std::getenv("GNOMON_BAKES");
    const int patches = asked ? std::atoi(asked) : 40;
    Baker baker;
    std::vector<double> all;
    // First those in which a descent or the walk went wrong once.
    std::vector<unsigned> seeds{80, 110, 267, 388, 396, 687, 890, 894, 987, 20212, 20457, 20468, 20921};
    for (unsigned seed = 1; seed <= unsigned(patches); ++seed) seeds.push_back(seed);
    for (const unsigned seed : seeds) {
        const FieldBake bake = bakeOf(randomHeights(seed), 16);
        const std::vector<double> errors = errorsOf(bake, baker(bake), certified(bake));
        EXPECT_LE(worst(errors), kBound) << "seed " << seed;
        all.insert(all.end(), errors.begin(), errors.end());
    }
    std::sort(all.begin(), all.end());
    std::printf("%zu texels: at most %.2g, 99.9 %% %.2g, half %.2g\n", all.size(), all.back(),
                all[all.size() * 999 / 1000], all[all.size() / 2]);
    EXPECT_LE(all[all.size() * 999 / 1000], kMostly);
}

// Large bricks, rectangles of other sides, places and heights, boxes that are no power of two.
TEST(ExactBake, OfAnyRectangleIsTheCertifiedDistance) {
    offscreen();
    Baker baker;
    struct Patch {
        glm::dvec3 center, size;
        int resolution;
    };
    const Patch patches[]{{{0, 0, 0}, {1, 1, 1}, 33},         {{5, -3, 40}, {2, 0.5, 1}, 25},
                          {{-1, 2, 3}, {0.3, 0.05, 3}, 24},   {{0, 0, 0}, {200, 30, 150}, 9},
                          {{0, 0, 0}, {0.01, 0.01, 0.01}, 8}, {{0, 1, 0}, {10, 0.001, 10}, 16}};
    unsigned seed = 5000;
    for (const Patch& patch : patches) {
        const FieldBake bake =
            bakeOf(randomHeights(++seed), patch.resolution, BakeMethod::Exact, patch.center, patch.size);
        const std::vector<double> errors = errorsOf(bake, baker(bake), certified(bake));
        EXPECT_LE(worst(errors), kBound) << "seed " << seed;
    }
}

// Free of any reference: no two neighbours differ by more than they lie apart, along the axes and across.
TEST(ExactBake, ChangesNoFasterThanItsSamplesLieApart) {
    offscreen();
    Baker baker;
    for (unsigned seed = 9001; seed <= 9004; ++seed) {
        const FieldBake bake = bakeOf(randomHeights(seed), 40);
        const std::vector<float> field = baker(bake);
        const int n = bake.resolution;
        const double slack = 1e-6 * sizeOf(bake);
        for (std::size_t i = 0; i < field.size(); ++i)
            for (int step = 1; step < 8; ++step) {
                const int dx = step & 1, dy = step >> 1 & 1, dz = step >> 2;
                const int x = int(i) % n + dx, y = int(i) / n % n + dy, z = int(i) / n / n + dz;
                if (std::max({x, y, z}) >= n) continue;
                const std::size_t j = std::size_t((z * n + y) * n + x);
                const double apart = glm::length(sampleOf(bake, j) - sampleOf(bake, i));
                ASSERT_LE(std::abs(double(field[j]) - double(field[i])), apart + slack)
                    << "seed " << seed << placeOf(bake, i) << " and " << placeOf(bake, j);
            }
    }
}

// A twisted patch has two feet of equal distance under its middle, where a descent from there stays on a saddle:
// distance² is h² up to the focal point, (2 k h - 1) / k² above it.
TEST(ExactBake, LeavesTheSaddleOfATwistedPatch) {
    offscreen();
    Baker baker;
    const double k = 6;
    FieldBake bake = bakeOf(heightsOf([&](double u, double v) { return k * (u - 0.5) * (v - 0.5); }), 17);
    bake.box.low.y = 0;
    bake.box.high.y = 0.4;
    const std::vector<float> field = baker(bake);
    const int n = bake.resolution;
    for (int y = 1; y < n; ++y) {
        const double h = 0.4 * y / (n - 1);
        const double exact = k * h > 1 ? std::sqrt(2 * k * h - 1) / k : h;
        EXPECT_NEAR(field[std::size_t((n / 2 * n + y) * n + n / 2)], exact, 3e-7 * sizeOf(bake)) << "height " << h;
    }
}

TEST(ExactBake, OfAPlaneAndOfAFlatPatchIsTheTextbooks) {
    offscreen();
    Baker baker;
    const FieldBake flat = bakeOf(heightsOf([](double, double) { return 0.25; }), 12);
    EXPECT_LE(worst(errorsOf(flat, baker(flat), [](glm::dvec3 q) { return q.y - 0.25; })), 2e-7);
    const double a = 0.5, b = -0.25;
    const FieldBake plane = bakeOf(heightsOf([&](double u, double v) { return a * u + b * v; }), 12);
    const std::vector<float> field = baker(plane);
    int met = 0;
    for (std::size_t i = 0; i < field.size(); ++i) {
        const glm::dvec3 q = sampleOf(plane, i);
        const double above = (q.y - a * (q.x + 0.5) - b * (q.z + 0.5)) / (1 + a * a + b * b);
        const glm::dvec2 foot = glm::dvec2(q.x, q.z) + above * glm::dvec2(a, b);
        if (std::max(std::abs(foot.x), std::abs(foot.y)) > 0.5) continue; // that foot is beside the patch
        ++met;
        EXPECT_NEAR(field[i], above * std::sqrt(1 + a * a + b * b), 2e-7) << placeOf(plane, i);
    }
    EXPECT_GT(met, 500);
}

TEST(ExactBake, InHalfFloatsIsTheSameRounded) {
    offscreen();
    Baker baker;
    FieldBake bake = bakeOf(randomHeights(77), 16);
    const std::vector<float> whole = baker(bake);
    bake.format = GL_R16F;
    const std::vector<float> half = baker(bake);
    for (std::size_t i = 0; i < whole.size(); ++i) // which way halves are rounded is the GL's
        ASSERT_LE(std::abs(half[i] - whole[i]), std::max(std::abs(whole[i]) * 0x1p-10, 0x1p-24)) << placeOf(bake, i);
}

// ---- Steps and contexts

TEST(Bake, InManyStepsIsWhatItIsAtOnce) {
    offscreen();
    Baker baker;
    for (const BakeMethod method : {BakeMethod::Exact, BakeMethod::AdaMax}) {
        const FieldBake bake = bakeOf(randomHeights(3), 21, method);
        const std::vector<float> atOnce = baker(bake);
        baker.begin(bake);
        EXPECT_EQ(baker.pass.done(), 0);
        for (int steps = 0; baker.pass.done() < 1 && steps < 100; ++steps) {
            const double before = baker.pass.done();
            baker.go(2);
            EXPECT_LE(baker.pass.done(), before + 2.001 / 21);
        }
        EXPECT_EQ(readField(baker.field), atOnce);
    }
}

TEST(Bake, SatisfiesGlslang) {
    const auto folder = std::filesystem::temp_directory_path() / "gnomon-glslang-bakes";
    std::filesystem::create_directories(folder);
    std::string files;
    for (const ShaderFile& shader : shaderLibrary())
        for (const bool es300 : {true, false}) {
            if (!shader.name.starts_with("pass/bake_")) continue;
            Plan plan;
            plan.target.es300 = es300;
            Problems problems;
            const auto file = folder / (std::string(shader.name.substr(5)) + (es300 ? ".es.frag" : ".gl.frag"));
            std::ofstream(file) << buildShader(shader.name, plan, problems).text;
            EXPECT_EQ(toString(problems), "");
            files += " " + file.string();
        }
    EXPECT_NE(files, "");
    const std::string log = (folder / "log").string();
    EXPECT_EQ(std::system(("glslangValidator" + files + " > " + log + " 2>&1").c_str()), 0)
        << std::ifstream(log).rdbuf();
    std::filesystem::remove_all(folder);
}

TEST(Bake, CompilesInBothPreludesAndOtherGls) {
    for (const ContextKind kind : {ContextKind::OsMesa, ContextKind::Egl}) {
        offscreen(kind);
        for (const bool es300 : {true, false}) {
            if (!es300 && gl::info().es) continue;
            for (int method = 0; method <= int(BakeMethod::Lipschitz); ++method) {
                Baker baker;
                EXPECT_TRUE(baker.pass.begin(bakeOf(randomHeights(1), 4, BakeMethod(method)), {.es300 = es300},
                                             baker.problems));
                baker.finish();
                EXPECT_EQ(toString(baker.problems), "") << nameOf(kind) << " method " << method;
            }
        }
    }
}

// ---- The third source's methods

TEST(LipschitzBake, IsTheHeightOverTheConstantAndNeverMoreThanTheDistance) {
    offscreen();
    Baker baker;
    for (const unsigned seed : {11U, 12U}) {
        FieldBake bake = bakeOf(randomHeights(seed), 16, BakeMethod::Lipschitz, {1, 2, 3}, {2, 1, 3});
        const std::vector<float> byNet = baker(bake);
        const oracle::PatchDistance exact(bake.heights, bake.center, bake.size);
        bake.lipschitz = 50;
        const std::vector<float> byConstant = baker(bake);
        const double slack = 1e-7 * sizeOf(bake);
        for (std::size_t i = 0; i < byNet.size(); ++i) {
            const glm::dvec3 q = sampleOf(bake, i), t = (q - bake.center) / bake.size + 0.5;
            const double above = q.y - bake.center.y - heightAt(bake.heights, t.x, t.z);
            ASSERT_NEAR(byConstant[i], above / 50, slack) << placeOf(bake, i);
            ASSERT_LE(std::abs(byNet[i]), exact.nearest(q).distance + slack) << placeOf(bake, i);
            ASSERT_NEAR(byNet[i] / byConstant[i], byNet[0] / byConstant[0], 1e-5 * byNet[0] / byConstant[0]);
        }
    }
}

TEST(BruteForceBake, IsTheNearestOfItsSamples) {
    offscreen();
    Baker baker;
    FieldBake bake = bakeOf(randomHeights(21), 16, BakeMethod::Brute, {0, 0, 0}, {2, 1, 1});
    bake.samples = 13;
    const auto nearest = [&](glm::dvec3 q) {
        double best = 1e30;
        for (int j = 0; j < 13; ++j)
            for (int i = 0; i < 13; ++i) {
                const double u = i / 12.0, v = j / 12.0;
                const glm::dvec3 p((u - 0.5) * 2, heightAt(bake.heights, u, v), v - 0.5);
                best = std::min(best, glm::length(p - q));
            }
        return q.y < heightAt(bake.heights, q.x / 2 + 0.5, q.z + 0.5) ? -best : best;
    };
    EXPECT_LE(worst(errorsOf(bake, baker(bake), nearest)), 3e-7);
}

} // namespace
} // namespace gnomon
