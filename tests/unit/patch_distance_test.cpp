/// The certified distance to a height patch against closed forms, against itself where it must not change, and against
/// a search that knows only how steep the patch is at most.

#include "lab/reference/exact/first_root.h"
#include "lab/reference/exact/patch_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gnomon::oracle {
namespace {

using Vec = glm::dvec3;

constexpr Vec kCenter{0.5, 0, 0.5}, kSize{1, 1, 1}; ///< u is x, v is z, a height is y
constexpr double kRounding = 4e-15;                 ///< of distances up to some units

class Random {
  public:
    explicit Random(unsigned seed) : random_(seed) {}
    double operator()(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
    /// In the box about a patch, with a quarter of a unit around.
    Vec about(const Heights& heights) {
        const auto [low, high] = heightRange(heights);
        return {(*this)(-0.25, 1.25), (*this)(low - 0.25, high + 0.25), (*this)(-0.25, 1.25)};
    }

  private:
    std::mt19937_64 random_;
};

/// The net of a function that is a polynomial of degree 2 at most in u and in v, by what it is at 0, 1/2 and 1.
template<class Function>
Heights raised(const Function& f) {
    const auto cubic = [](double a, double middle, double b) -> std::array<double, 4> {
        const double control = 2 * middle - (a + b) / 2; // of degree 2
        return {a, (a + 2 * control) / 3, (2 * control + b) / 3, b};
    };
    std::array<std::array<double, 4>, 3> rows;
    for (std::size_t j = 0; j < 3; ++j) rows[j] = cubic(f(0.0, j / 2.0), f(0.5, j / 2.0), f(1.0, j / 2.0));
    Heights heights;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto column = cubic(rows[0][i], rows[1][i], rows[2][i]);
        for (std::size_t j = 0; j < 4; ++j) heights[4 * j + i] = column[j];
    }
    return heights;
}

Foot nearestTo(const Heights& heights, Vec q) { return nearestOn(heights, kCenter, kSize, q); }
double distanceTo(const Heights& heights, Vec q) { return nearestTo(heights, q).distance; }
double signedTo(const Heights& heights, Vec q) { return PatchDistance(heights, kCenter, kSize).signedDistance(q); }

// Above the square its height, beside it the distance of its nearest edge or corner.
TEST(PatchDistance, OfAFlatPatchIsThatOfItsRectangle) {
    Random random(1);
    const Vec center(3, -2, 5), size(2.5, 4, 0.75);
    Heights flat;
    flat.fill(0.125);
    for (int i = 0; i < 2000; ++i) {
        const Vec off(random(-3, 3), random(-3, 3), random(-3, 3));
        const double x = std::max(std::abs(off.x) - size.x / 2, 0.0), z = std::max(std::abs(off.z) - size.z / 2, 0.0);
        const Foot foot = nearestOn(flat, center, size, center + Vec(0, 0.5, 0) + off);
        EXPECT_NEAR(foot.distance, std::hypot(x, off.y, z), kRounding);
        EXPECT_NEAR(foot.u, std::clamp(off.x / size.x + 0.5, 0.0, 1.0), 1e-7);
        EXPECT_NEAR(foot.v, std::clamp(off.z / size.z + 0.5, 0.0, 1.0), 1e-7);
    }
}

TEST(PatchDistance, OfAPlaneIsThatOfThePlane) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const double a = random(-12, 12), b = random(-12, 12), c = random(-1, 1);
        const Heights plane = raised([&](double u, double v) { return a * u + b * v + c; });
        const Vec foot(random(0, 1), 0, random(0, 1)), up = glm::normalize(Vec(-a, 1, -b));
        const double away = random(-3, 3);
        const Vec q = Vec(foot.x, a * foot.x + b * foot.z + c, foot.z) + away * up;
        EXPECT_NEAR(distanceTo(plane, q), std::abs(away), 20 * kRounding);
        const bool beside = q.x < 0 || q.x > 1 || q.z < 0 || q.z > 1;
        EXPECT_NEAR(signedTo(plane, q), beside ? std::abs(away) : away, 20 * kRounding);
    }
}

// k (x - 1/2)(z - 1/2) from a height h over its middle: from h = 1/k on two feet wander out along the diagonal, and the
// middle is a saddle of the distance.
TEST(PatchDistance, OfATwistedPatchIsTheClosedForm) {
    for (const double k : {0.5, 2.0, 8.0, 32.0})
        for (double h = 0.01; h < 3; h += 0.0637) {
            const double out = std::sqrt(std::max(h - 1 / k, 0.0) / k); // along each axis
            if (out > 0.5) continue;
            const Heights twisted = raised([&](double u, double v) { return k * (u - 0.5) * (v - 0.5); });
            const double exact = k * h > 1 ? std::sqrt(2 * k * h - 1) / k : h;
            for (const double side : {1.0, -1.0}) {
                const Foot foot = nearestTo(twisted, {0.5, side * h, 0.5});
                EXPECT_NEAR(foot.distance, exact, kRounding) << k << ' ' << h;
                EXPECT_NEAR(std::abs(foot.u - 0.5), out, 1e-5) << k << ' ' << h; // flat about 1/k
                EXPECT_NEAR(foot.v - 0.5, side * (foot.u - 0.5), 1e-5) << k << ' ' << h;
            }
        }
}

/// Of a point to a plane cubic by its heights: sampled, and every dip searched for its bottom.
double toCubic(const std::array<double, 4>& c, double x, double y) {
    const auto f = [&](long double t) {
        const long double s = 1 - t, rise = s * s * s * c[0] + 3 * s * t * (s * c[1] + t * c[2]) + t * t * t * c[3] - y;
        return std::hypot(t - x, rise);
    };
    constexpr int kSteps = 2000;
    long double least = std::min(f(0), f(1));
    for (int i = 1; i < kSteps; ++i) {
        const long double t = i / (long double)kSteps, step = 1 / (long double)kSteps;
        if (f(t) <= f(t - step) && f(t) <= f(t + step)) least = std::min(least, f(bottomOf(f, t - step, t + step)));
    }
    return double(least);
}

TEST(PatchDistance, OfWhatIsTheSameAlongOneAxisIsThatOfAPlaneCubic) {
    Random random(3);
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Heights source = randomHeights(seed);
        const std::array<double, 4> cubic{source[0], source[1], source[2], source[3]};
        Heights along, across;
        for (std::size_t i = 0; i < 16; ++i) {
            along[i] = cubic[i % 4];
            across[i] = cubic[i / 4];
        }
        for (int i = 0; i < 60; ++i) {
            const Vec q = random.about(along);
            const double beside = std::max({-q.z, q.z - 1, 0.0});
            const double exact = std::hypot(toCubic(cubic, q.x, q.y), beside);
            EXPECT_NEAR(distanceTo(along, q), exact, 1e-13) << seed;
            EXPECT_NEAR(distanceTo(across, {q.z, q.y, q.x}), exact, 1e-13) << seed;
        }
    }
}

TEST(PatchDistance, StaysWhereTheWholeIsTurnedMirroredOrMoved) {
    Random random(4);
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Heights heights = randomHeights(seed), reversedU = partOf(heights, {1, 0}, {0, 1}),
                      reversedV = partOf(heights, {0, 1}, {1, 0});
        Heights transposed, higher = heights, mirrored = heights, taller = heights;
        for (std::size_t i = 0; i < 16; ++i) {
            transposed[4 * (i % 4) + i / 4] = heights[i];
            higher[i] += 0.75;
            mirrored[i] *= -1;
            taller[i] *= 0.5;
        }
        for (int i = 0; i < 100; ++i) {
            const Vec q = random.about(heights);
            const double d = signedTo(heights, q), most = 1e-13;
            EXPECT_NEAR(signedTo(reversedU, {1 - q.x, q.y, q.z}), d, most);
            EXPECT_NEAR(signedTo(reversedV, {q.x, q.y, 1 - q.z}), d, most);
            EXPECT_NEAR(signedTo(transposed, {q.z, q.y, q.x}), d, most);
            EXPECT_NEAR(signedTo(higher, q + Vec(0, 0.75, 0)), d, most);
            const bool beside = q.x < 0 || q.x > 1 || q.z < 0 || q.z > 1;
            EXPECT_NEAR(signedTo(mirrored, {q.x, -q.y, q.z}), beside ? d : -d, most);
            const Vec away(10, -20, 30);
            const Foot far = nearestOn(taller, 3.0 * kCenter + away, {3, 6, 3}, 3.0 * q + away);
            EXPECT_NEAR(far.distance, 3 * std::abs(d), 10 * most);
        }
    }
}

// A net of degree 2 raised to 3 has the surface of the former: its points are on the patch, and those on its normals,
// nearer than it bends, as far from it as they are from these.
TEST(PatchDistance, TakesARaisedNetForTheSurfaceThatItIs) {
    Random random(5);
    for (int net = 0; net < 20; ++net) {
        double c[6];
        for (double& x : c) x = random(-2, 2);
        const auto f = [&](double u, double v) {
            return c[0] + c[1] * u + c[2] * v + c[3] * u * v + c[4] * u * u + c[5] * v * v * u;
        };
        const Heights heights = raised(f);
        for (int i = 0; i < 50; ++i) {
            const double u = random(0.1, 0.9), v = random(0.1, 0.9);
            const Vec p(u, f(u, v), v);
            EXPECT_LE(distanceTo(heights, p), kRounding);
            const Vec up(-(c[1] + c[3] * v + 2 * c[4] * u + c[5] * v * v), 1, -(c[2] + c[3] * u + 2 * c[5] * v * u));
            const double away = random(-0.01, 0.01);
            EXPECT_NEAR(signedTo(heights, p + away * glm::normalize(up)), away, kRounding);
        }
    }
}

TEST(PatchDistance, IsTheLeastOfThatOfFourParts) {
    Random random(6);
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Heights heights = randomHeights(seed);
        const glm::dvec2 cut(random(0.2, 0.8), random(0.2, 0.8));
        const double ends[2][3]{{0, cut.x, 1}, {0, cut.y, 1}};
        for (int i = 0; i < 50; ++i) {
            const Vec q = random.about(heights);
            double least = 1e30;
            for (int a = 0; a < 2; ++a)
                for (int b = 0; b < 2; ++b) {
                    const glm::dvec2 low(ends[0][a], ends[1][b]), high(ends[0][a + 1], ends[1][b + 1]);
                    const glm::dvec2 middle = (low + high) / 2.0, size = high - low;
                    const Foot foot =
                        nearestOn(partOf(heights, low, high), {middle.x, 0, middle.y}, {size.x, 1, size.y}, q);
                    least = std::min(least, foot.distance);
                }
            EXPECT_NEAR(distanceTo(heights, q), least, 1e-13) << seed;
        }
    }
}

TEST(PatchDistance, ChangesByNoMoreThanThePointMoves) {
    Random random(7);
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Heights heights = randomHeights(seed);
        for (int i = 0; i < 100; ++i) {
            const Vec q = random.about(heights),
                      step = std::pow(10.0, random(-6, 0)) * Vec(random(-1, 1), random(-1, 1), random(-1, 1));
            EXPECT_LE(std::abs(distanceTo(heights, q) - distanceTo(heights, q + step)), glm::length(step) + 1e-14);
        }
    }
}

TEST(PatchDistance, IsNothingOnTheSurfaceAndSignedBesideIt) {
    Random random(8);
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Heights heights = randomHeights(seed);
        for (int i = 0; i < 50; ++i) {
            const double u = random(0, 1), v = random(0, 1), y = heightAt(heights, u, v);
            EXPECT_LE(distanceTo(heights, {u, y, v}), kRounding);
            EXPECT_GT(signedTo(heights, {u, y + 1e-9, v}), 0);
            EXPECT_LT(signedTo(heights, {u, y - 1e-9, v}), 0);
            const double beside = random(1e-9, 1);
            EXPECT_GT(signedTo(heights, {-beside, y - 1, v}), 0);
        }
    }
}

// k (x - 1/2)² from a height h over its lowest line: up to the centre of curvature, 1/(2 k), that is nearest, and there
// the distance is flat to the third derivative.
TEST(PatchDistance, HoldsAtACentreOfCurvatureAndBehindIt) {
    for (const double k : {1.0, 4.0, 16.0}) {
        const double focus = 1 / (2 * k);
        const auto valley = [&](double u, double) { return k * (u - 0.5) * (u - 0.5); };
        const auto bowl = [&](double u, double v) { return valley(u, v) + valley(v, u); };
        for (const double off : {-1e-2, -1e-5, -1e-9, 0.0, 1e-9, 1e-5, 1e-2}) {
            const double h = focus + off, exact = off > 0 ? std::sqrt(h / k - 1 / (4 * k * k)) : h;
            const Foot foot = nearestTo(raised(valley), {0.5, h, 0.3});
            EXPECT_GE(foot.distance, exact - kRounding) << k << ' ' << off;
            EXPECT_LE(foot.distance, exact + foot.slack + kRounding) << k << ' ' << off;
            if (off > 1e-5) continue;
            const Foot ofRing = nearestTo(raised(bowl), {0.5, h, 0.5});
            EXPECT_GE(ofRing.distance, exact - kRounding) << k << ' ' << off;
            EXPECT_LE(ofRing.distance, exact + ofRing.slack + kRounding) << k << ' ' << off;
        }
    }
}

/// The least distance by cells of the square about whose middles the patch reaches no farther than it is steep at most.
/// Cells that may hold what is nearer are cut in 16 until they reach no farther than `reach`: it is that much too large
/// at most.
double bySteepness(const Heights& heights, Vec q, double reach) {
    double steep[2]{0, 0};
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 3; ++i) {
            steep[0] = std::max(steep[0], 3 * std::abs(heights[4 * j + i + 1] - heights[4 * j + i]));
            steep[1] = std::max(steep[1], 3 * std::abs(heights[4 * (i + 1) + j] - heights[4 * i + j]));
        }
    int across = 256;
    const auto reachOf = [&](int cells) {
        return (std::hypot(1.0, steep[0]) + std::hypot(1.0, steep[1])) / (2.0 * cells);
    };
    std::vector<glm::ivec2> cells;
    for (int j = 0; j < across; ++j)
        for (int i = 0; i < across; ++i) cells.emplace_back(i, j);
    for (;;) {
        double least = 1e30;
        std::vector<double> away;
        for (const glm::ivec2 cell : cells) {
            const double u = (cell.x + 0.5) / across, v = (cell.y + 0.5) / across;
            away.push_back(glm::distance(q, Vec(u, heightAt(heights, u, v), v)));
            least = std::min(least, away.back());
        }
        if (reachOf(across) <= reach) return least;
        std::vector<glm::ivec2> finer;
        for (std::size_t n = 0; n < cells.size(); ++n)
            for (int k = 0; k < 16 && away[n] - reachOf(across) <= least; ++k)
                finer.push_back(4 * cells[n] + glm::ivec2(k % 4, k / 4));
        cells.swap(finer);
        across *= 4;
    }
}

TEST(PatchDistance, IsThatOfASearchBySteepness) {
    Random random(9);
    constexpr double kReach = 1e-3;
    for (unsigned seed = 100; seed < 110; ++seed) {
        const Heights heights = randomHeights(seed);
        for (int i = 0; i < 4; ++i) {
            const Vec q = random.about(heights);
            const double searched = bySteepness(heights, q, kReach), d = distanceTo(heights, q);
            EXPECT_LE(d, searched + kRounding) << seed;
            EXPECT_GE(d, searched - kReach) << seed;
        }
    }
}

TEST(PatchDistance, IsCertifiedAndThatOfItsFoot) {
    Random random(10);
    for (unsigned seed = 0; seed < 100; ++seed) {
        const Heights heights = randomHeights(seed);
        const PatchDistance patch(heights, kCenter, kSize);
        const auto [low, high] = heightRange(heights);
        EXPECT_LE(patch.tolerance(), 1e-8 * std::max(1.0, high - low));
        for (int i = 0; i < 100; ++i) {
            const Vec q = random.about(heights);
            const Foot foot = patch.nearest(q);
            EXPECT_LE(foot.slack, patch.tolerance() + 1e-14);
            EXPECT_NEAR(foot.distance, glm::distance(q, Vec(foot.u, heightAt(heights, foot.u, foot.v), foot.v)), 1e-14);
        }
    }
}

// In long double the foot is a stationary point to more digits than doubles have.
TEST(PatchSurface, IsAsNearAsCertifiedAndFinerThanDouble) {
    Random random(11);
    using Wide = Vec3<long double>;
    int inside = 0;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Heights heights = randomHeights(seed);
        const PatchSurface<long double> surface(heights, {1, 1, 1});
        for (int i = 0; i < 50; ++i) {
            const Vec q = random.about(heights);
            const Wide p = Wide(q - kCenter), foot = surface.nearest(p);
            EXPECT_NEAR(double(length(p - foot)), distanceTo(heights, q), 2e-14);
            EXPECT_NEAR(double(foot.y), heightAt(heights, double(foot.x) + 0.5, double(foot.z) + 0.5), 1e-14);
            if (std::abs(foot.x) == 0.5L || std::abs(foot.z) == 0.5L) continue;
            ++inside;
            EXPECT_LE(double(length(cross(surface.normal(foot), p - foot))), 1e-16) << seed;
        }
    }
    EXPECT_GT(inside, 1000);
}

// Towards a point of the surface that is nearest the two come together; the normal is what the distance grows along.
TEST(PatchSurface, BendsAsItsDistanceDoes) {
    Random random(12);
    for (unsigned seed = 0; seed < 50; ++seed) {
        const PatchSurface<double> surface(randomHeights(seed), {1, 1, 1});
        for (int i = 0; i < 20; ++i) {
            const double x = random(-0.4, 0.4), z = random(-0.4, 0.4);
            const Vec3<double> p(x, surface.at(x, z).y, z), up = surface.normal(p);
            const double bend = surface.bend(p), small = std::min(1e-4, 0.01 * bend);
            EXPECT_NEAR(surface.signedDistance(p + small * up), small, 1e-12) << seed;
            // To one side it bends so: a little beyond that radius its neighbours are nearer, before it they are not.
            double least = 1e30;
            for (const double side : {1.0, -1.0}) {
                const Vec3<double> q = p + (1.1 * side * bend) * up;
                for (int k = 0; k < 360; ++k) {
                    const double turn = k * 0.0174532925199433, step = 1e-3 * std::min(bend, 0.1);
                    const double a = x + step * std::cos(turn), b = z + step * std::sin(turn);
                    const Vec3<double> beside(a, surface.at(a, b).y, b);
                    least = std::min(least, (length(q - beside) - 1.1 * bend) / dot(beside - p, beside - p));
                    const Vec3<double> nearer = p + (0.9 * side * bend) * up;
                    EXPECT_GT(length(nearer - beside), 0.9 * bend) << seed;
                }
            }
            EXPECT_LT(least, 0) << seed;
        }
    }
}

} // namespace
} // namespace gnomon::oracle
