/// Where rays meet height patches against closed forms, against dense samples of the tracer's own heights, and against
/// itself in 50 digits; and what it tells of rays that nearly decide otherwise.

#include "lab/reference/exact/patch_hit.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gnomon::oracle {
namespace {

using Vec = Vec3<double>;
using Digits50 = boost::multiprecision::cpp_bin_float_50;

const Vec kUnit{1, 1, 1}; ///< u is x + 1/2, v is z + 1/2, a height is y

class Random {
  public:
    explicit Random(unsigned seed) : random_(seed) {}
    double operator()(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }

  private:
    std::mt19937_64 random_;
};

struct Ray {
    Vec origin, direction;
};

/// From about a patch to a point in its box.
Ray rayTo(const Heights& heights, Random& random) {
    const auto [low, high] = heightRange(heights);
    const Vec origin(random(-1, 1), random(low - 1, high + 1), random(-1, 1)),
        target(random(-0.5, 0.5), random(low, high), random(-0.5, 0.5));
    return {origin, unit(target - origin)};
}

template<class R>
PatchHits<R> hitsOf(const Heights& heights, const Ray& ray) {
    return hitsOf(PatchSurface<R>(heights, {1, 1, 1}), Vec3<R>(ray.origin), Vec3<R>(ray.direction), R(0));
}

/// A cubic that vanishes at three places, by its control values: those of its polar form.
std::array<double, 4> cubicWithRoots(double a, double b, double c, double scale) {
    const auto polar = [&](double x, double y, double z) {
        return scale * (x * y * z - (a + b + c) * (x * y + y * z + z * x) / 3 +
                        (a * b + b * c + c * a) * (x + y + z) / 3 - a * b * c);
    };
    return {polar(0, 0, 0), polar(0, 0, 1), polar(0, 1, 1), polar(1, 1, 1)};
}

Heights productOf(const std::array<double, 4>& alongU, const std::array<double, 4>& alongV) {
    Heights heights;
    for (std::size_t i = 0; i < 16; ++i) heights[i] = alongU[i % 4] * alongV[i / 4];
    return heights;
}

void expectHits(const PatchHits<double>& hits, const std::vector<double>& t) {
    ASSERT_EQ(hits.t.size(), t.size());
    for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(hits.t[i], t[i], 1e-13) << i;
}

TEST(PatchHit, OfAPlaneIsThatOfThePlane) {
    Random random(1);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const double a = random(-9, 9), b = random(-9, 9), c = random(-1, 1);
        Heights plane;
        for (std::size_t n = 0; n < 16; ++n)
            plane[n] = a * (double(n % 4) / 3 - 0.5) + b * (double(n / 4) / 3 - 0.5) + c;
        const Ray ray = rayTo(plane, random);
        const auto over = [&](const Vec& p) { return p.y - a * p.x - b * p.z; };
        const double t = (c - over(ray.origin)) / over(ray.direction);
        const Vec p = ray.origin + t * ray.direction;
        const double within = 0.5 - std::max(std::abs(p.x), std::abs(p.z));
        if (std::abs(within) < 1e-9 || std::abs(t) < 1e-9) continue;
        const PatchHits<double> got = hitsOf<double>(plane, ray);
        const bool hit = t > 0 && within > 0;
        hits += hit;
        ASSERT_EQ(got.t.size(), hit ? 1U : 0U);
        if (hit) {
            EXPECT_NEAR(got.t[0] * over(ray.direction), t * over(ray.direction), 1e-13);
        }
    }
    EXPECT_GT(hits, 500);
}

// k x z: along a level line through the middle's height two hits in closed form.
TEST(PatchHit, OfATwistedPatchIsTheClosedForm) {
    const double k = 3, height = 0.05;
    const Heights twisted = productOf({-k / 2, -k / 6, k / 6, k / 2}, {-0.5, -1.0 / 6, 1.0 / 6, 0.5});
    const Ray ray{{-1, height, -0.75}, {1, 0, 0.75}}; // x = t - 1, z = 0.75 (t - 1)
    const double root = std::sqrt(height / (0.75 * k));
    expectHits(hitsOf<double>(twisted, ray), {1 - root, 1 + root});
}

// p(u) q(v) along the diagonal has the roots of both cubics: six, the most there are.
TEST(PatchHit, FindsAllSixRoots) {
    const Heights heights = productOf(cubicWithRoots(0.1, 0.3, 0.5, 40), cubicWithRoots(0.2, 0.6, 0.9, 40));
    const Ray along{{-1.5, 0, -1.5}, {1, 0, 1}}, back{{1.5, 0, 1.5}, {-1, 0, -1}};
    expectHits(hitsOf<double>(heights, along), {1.1, 1.2, 1.3, 1.5, 1.6, 1.9});
    expectHits(hitsOf<double>(heights, back), {1.1, 1.4, 1.5, 1.7, 1.8, 1.9});
    expectHits(hitsOf<double>(heights, {{-0.25, 0, -0.25}, {1, 0, 1}}), {0.05, 0.25, 0.35, 0.65});
}

// Roots closer than any sampling would part are parted.
TEST(PatchHit, PartsRootsThatAreNearlyOne) {
    for (const double gap : {1e-2, 1e-4, 1e-6}) {
        const Heights heights = productOf(cubicWithRoots(0.4, 0.4 + gap, 2, 1), {1, 1, 1, 1});
        const PatchHits<double> hits = hitsOf<double>(heights, {{-1, 0, 0.1}, {1, 0, 0}});
        ASSERT_EQ(hits.t.size(), 2U) << gap;
        EXPECT_NEAR(hits.t[0], 0.9, 1e-15 / gap + 1e-14);
        EXPECT_NEAR(hits.t[1], 0.9 + gap, 1e-15 / gap + 1e-14);
        const double deep = 1.6 * gap * gap / 4; // of (x - 0.4)(x - 0.4 - gap)(2 - x) between its roots
        EXPECT_NEAR(hits.margin, deep, 0.02 * deep) << gap;
    }
}

TEST(PatchHit, IsARootOfTheHeightOverTheSurface) {
    Random random(2);
    int hits = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Heights heights = randomHeights(seed);
        const PatchSurface<double> surface(heights, kUnit);
        for (int i = 0; i < 50; ++i) {
            const Ray ray = rayTo(heights, random);
            double before = 0;
            for (const double t : hitsOf(surface, ray.origin, ray.direction, 0.0).t) {
                ++hits;
                EXPECT_GE(t, before);
                before = t;
                const Vec p = ray.origin + t * ray.direction;
                ASSERT_LE(std::max(std::abs(p.x), std::abs(p.z)), 0.5 + 1e-14);
                const auto jet = surface.at(p.x, p.z);
                const double over = p.y - heightAt(heights, p.x + 0.5, p.z + 0.5), steep = std::hypot(1, jet.x, jet.z);
                EXPECT_LE(std::abs(over) / steep, 1e-14) << seed;
            }
        }
    }
    EXPECT_GT(hits, 5000);
}

// But for rays that come so near to a decision that the samples may step over it.
TEST(PatchHit, AreAsManyAsTheChangesOfSignAmongSamples) {
    constexpr int kSamples = 20000;
    constexpr double kFar = 16, kSure = 10 * kFar / kSamples;
    Random random(3);
    int decided = 0, several = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Heights heights = randomHeights(seed);
        for (int i = 0; i < 25; ++i) {
            const Ray ray = rayTo(heights, random);
            const PatchHits<double> hits = hitsOf<double>(heights, ray);
            if (hits.margin < kSure) continue;
            ++decided;
            several += hits.t.size() > 1;
            std::size_t changes = 0;
            int before = 0;
            for (int k = 0; k <= kSamples; ++k) {
                const Vec p = ray.origin + (kFar * k / kSamples) * ray.direction;
                const bool over = std::max(std::abs(p.x), std::abs(p.z)) <= 0.5;
                const int sign = !over ? 0 : p.y < heightAt(heights, p.x + 0.5, p.z + 0.5) ? -1 : 1;
                changes += sign == -before && sign != 0;
                before = sign;
            }
            EXPECT_EQ(hits.t.size(), changes) << seed << ' ' << hits.margin;
        }
    }
    EXPECT_GT(decided, 800);
    EXPECT_GT(several, 80);
}

TEST(PatchHit, AnswersInDoubleAsIn50Digits) {
    Random random(4);
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Heights heights = randomHeights(seed);
        for (int i = 0; i < 10; ++i) {
            const Ray ray = rayTo(heights, random);
            const PatchHits<double> got = hitsOf<double>(heights, ray);
            const PatchHits<Digits50> exact = hitsOf<Digits50>(heights, ray);
            EXPECT_NEAR(got.tangency, double(exact.tangency), 1e-12);
            EXPECT_NEAR(got.margin, double(exact.margin), 1e-12);
            EXPECT_EQ(got.below, exact.below);
            if (exact.margin < 1e-10) continue;
            ASSERT_EQ(got.t.size(), exact.t.size());
            for (std::size_t k = 0; k < got.t.size(); ++k)
                EXPECT_NEAR(got.t[k], double(exact.t[k]), 1e-14 / double(exact.margin) + 1e-12);
        }
    }
}

// A ridge of height 0 that is passed above or cut through below its top.
TEST(PatchHit, TellsHowFarARayIsFromTouching) {
    const std::array<double, 4> ridge{-1, 1.0 / 3, 1.0 / 3, -1}; // -4 (u - 1/2)²
    const Heights heights = productOf(ridge, {1, 1, 1, 1});
    for (const double off : {1e-2, 1e-5, 1e-9}) {
        const PatchHits<double> over = hitsOf<double>(heights, {{-1, off, 0}, {1, 0, 0}}),
                                through = hitsOf<double>(heights, {{-1, -off, 0}, {1, 0, 0}});
        EXPECT_EQ(over.t.size(), 0U);
        EXPECT_NEAR(over.tangency, off, 1e-15);
        ASSERT_EQ(through.t.size(), 2U);
        EXPECT_NEAR(through.tangency, off, 1e-15);
        EXPECT_NEAR(through.t[1] - through.t[0], std::sqrt(off), 1e-7 * std::sqrt(off) + 1e-15 / std::sqrt(off));
        // The farther of two ridges is none of the first hit's business.
        const Heights waves = productOf(cubicWithRoots(0.1, 0.7, 0.7 + std::sqrt(off), 1), {1, 1, 1, 1});
        const PatchHits<double> first = hitsOf<double>(waves, {{-1, 0, 0}, {1, 0, 0}});
        EXPECT_EQ(first.t.size(), 3U);
        EXPECT_LT(first.margin, off);
        EXPECT_GT(first.tangency, 0.01);
    }
}

TEST(PatchHit, TellsHowNearARayPassesTheRim) {
    const Heights heights = randomHeights(8);
    const PatchSurface<double> surface(heights, kUnit);
    for (const double off : {1e-2, 1e-5, 1e-9})
        for (const double side : {1.0, -1.0}) {
            // From above past the edge x = 1/2.
            const PatchHits<double> down = hitsOf(surface, Vec(0.5 + side * off, 9, 0.1), Vec(0, -1, 0), 0.0);
            EXPECT_EQ(down.t.size(), side < 0 ? 1U : 0U);
            EXPECT_NEAR(down.tangency, off, 1e-15);
            // Level through the edge x = -1/2, over it or below it: as far as it is across the edge's own slope.
            const auto jet = surface.at(-0.5, 0.1);
            const Vec along(0, jet.z, 1), level(1, 0, 0), across = unit(cross(along, level));
            const Vec at = Vec(-0.5, jet.y, 0.1) + (side * off) * across;
            const PatchHits<double> through = hitsOf(surface, at - 2.0 * level, level, 0.0);
            EXPECT_NEAR(through.margin, off, 1e-2 * off);
        }
}

// A start is a decision, too; and what lies behind it is none.
TEST(PatchHit, CountsFromTheStartOn) {
    const Heights heights = randomHeights(8);
    const PatchSurface<double> surface(heights, kUnit);
    const double y = surface.at(0.1, 0.2).y;
    const Vec normal = surface.normal({0.1, y, 0.2});
    for (const double off : {1e-3, 1e-6, 1e-9}) {
        const PatchHits<double> above = hitsOf(surface, Vec(0.1, y, 0.2) + off * normal, -normal, 0.0),
                                below = hitsOf(surface, Vec(0.1, y, 0.2) - off * normal, -normal, 0.0);
        ASSERT_EQ(above.t.size(), below.t.size() + 1);
        EXPECT_NEAR(above.t[0], off, 1e-14);
        EXPECT_NEAR(above.tangency, off, 1e-14);
        EXPECT_NEAR(below.tangency, off, 1e-14);
        EXPECT_FALSE(above.below);
        EXPECT_TRUE(below.below);
        // Off over the edge, which the line passes behind the start.
        const Vec beyond(0.5 + off, surface.at(0.5, 0.2).y, 0.2);
        const double away = surface.distance(beyond + Vec(0.7, 0, 0));
        EXPECT_NEAR(hitsOf(surface, beyond, Vec(1, 0, 0), 0.7).tangency, away, 1e-14);
        const PatchHits<double> later = hitsOf(surface, Vec(0.1, y, 0.2) + off * normal, -normal, 2 * off);
        EXPECT_EQ(later.t.size(), below.t.size());
    }
}

TEST(Bernstein, FindsEveryChangeOfSignOfAProduct) {
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        std::array<double, 5> roots;
        for (double& root : roots) root = random(-0.3, 1.3);
        std::sort(roots.begin(), roots.end());
        Bernstein<long double, 5> p;
        p.at.fill(1);
        for (int n = 0; n < 5; ++n) { // raises the degree n by the factor x - root, from the last coefficient down
            for (int k = n + 1; k >= 0; --k) {
                const long double before = k > 0 ? p.at[std::size_t(k) - 1] : 0,
                                  here = k <= n ? p.at[std::size_t(k)] : 0;
                p.at[std::size_t(k)] = (k * (1 - roots[n]) * before - (n + 1 - k) * roots[n] * here) / (n + 1);
            }
        }
        std::vector<double> inside;
        double least = 1;
        for (std::size_t n = 0; n < 5; ++n) {
            if (n > 0) least = std::min(least, roots[n] - roots[n - 1]);
            if (roots[n] > 0 && roots[n] < 1) inside.push_back(roots[n]);
        }
        const auto found = signChanges(p);
        ASSERT_EQ(std::size_t(found.count), inside.size());
        for (std::size_t n = 0; n < inside.size() && least > 1e-3; ++n)
            EXPECT_NEAR(double(found.at[n]), inside[n], 1e-17 / std::pow(least, 4)) << least;
    }
}

} // namespace
} // namespace gnomon::oracle
