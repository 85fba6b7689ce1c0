/// Fields by the third source's descents, beside the same steps in double.

#include "tests/support/bakes.h"
#include "tests/support/offscreen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace gnomon {
namespace {

using namespace test;

/// The source's descents in double, as shaders/field/descents.glsl tells them, on a patch of sides 1 in the origin.
class Descents {
  public:
    explicit Descents(const FieldBake& bake) : bake_(bake) {}

    double operator()(glm::dvec3 q) const {
        q += glm::dvec3(0.5, 0, 0.5);
        double best = from(q, {q.x, q.z});
        const int n = int(std::ceil(std::sqrt(bake_.starts - 1)));
        for (int i = 0; i + 1 < bake_.starts; ++i)
            best = std::min(best, from(q, (glm::dvec2(i % n, i / n) + 0.5) / double(n)));
        return q.y < heightAt(bake_.heights, q.x, q.z) ? -best : best;
    }

  private:
    /// Half the gradient of D would be (x - q) + (height - q) slope; the slope from the nets of first differences.
    glm::dvec2 gradient(glm::dvec3 q, glm::dvec2 x) const {
        const auto blend = [](double a, double b, double c, double t) {
            return (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c;
        };
        const Heights& h = bake_.heights;
        std::array<double, 3> alongU, alongV;
        for (std::size_t i = 0; i < 3; ++i) {
            const double s = 1 - x.y, c[]{s * s * s, 3 * s * s * x.y, 3 * s * x.y * x.y, x.y * x.y * x.y};
            const double r = 1 - x.x, d[]{r * r * r, 3 * r * r * x.x, 3 * r * x.x * x.x, x.x * x.x * x.x};
            alongU[i] = alongV[i] = 0;
            for (std::size_t j = 0; j < 4; ++j) {
                alongU[i] += 3 * c[j] * (h[4 * j + i + 1] - h[4 * j + i]);
                alongV[i] += 3 * d[j] * (h[4 * i + 4 + j] - h[4 * i + j]);
            }
        }
        const glm::dvec2 slope(blend(alongU[0], alongU[1], alongU[2], x.x),
                               blend(alongV[0], alongV[1], alongV[2], x.y));
        return 2.0 * (x - glm::dvec2(q.x, q.z) + (heightAt(h, x.x, x.y) - q.y) * slope);
    }

    double from(glm::dvec3 q, glm::dvec2 x) const {
        glm::dvec2 m(0), u(0);
        for (int t = 1; t <= bake_.iterations; ++t) {
            glm::dvec2 g = gradient(q, x);
            g = (x - glm::clamp(x - 1e-4 * g, 0.0, 1.0)) / 1e-4;
            x = glm::clamp(x - bake_.rate * step(g, m, u, t), 0.0, 1.0);
        }
        return glm::length(glm::dvec3(x.x, heightAt(bake_.heights, x.x, x.y), x.y) - q);
    }

    glm::dvec2 step(glm::dvec2 g, glm::dvec2& m, glm::dvec2& u, int t) const {
        const double b1 = bake_.beta1, b2 = bake_.beta2;
        if (bake_.method == BakeMethod::Gradient) return g;
        m = b1 * m + (1 - b1) * g;
        const glm::dvec2 mean = m / (1 - std::pow(b1, t));
        if (bake_.method == BakeMethod::Adam) {
            u = b2 * u + (1 - b2) * g * g;
            return mean / (glm::sqrt(u / (1 - std::pow(b2, t))) + 1e-8);
        }
        u = glm::max(glm::max(b2 * u, glm::abs(g)), glm::dvec2(1e-4));
        return mean / u;
    }

    FieldBake bake_;
};

// Steps of a fixed number end anywhere: what float32 loses on the way is some hundredfold of a rounding.
TEST(DescentBakes, AreTheSourcesInDouble) {
    offscreen();
    Baker baker;
    const auto compare = [&](BakeMethod method, int iterations, double rate, int starts) {
        FieldBake bake = bakeOf(randomHeights(31), 16, method);
        bake.iterations = iterations;
        bake.rate = rate;
        bake.starts = starts;
        std::vector<double> errors = errorsOf(bake, baker(bake), Descents(bake));
        std::sort(errors.begin(), errors.end());
        std::printf("method %d, %d steps: at most %.2g, 99 %% %.2g\n", int(method), iterations, errors.back(),
                    errors[errors.size() * 99 / 100]);
        EXPECT_LE(errors.back(), 1e-5) << "method " << int(method);
        EXPECT_LE(errors[errors.size() * 99 / 100], 1e-6) << "method " << int(method);
    };
    compare(BakeMethod::AdaMax, 25, 0.05, 10);
    compare(BakeMethod::AdaMax, 120, 0.005, 10);
    compare(BakeMethod::Adam, 25, 0.05, 5);
    compare(BakeMethod::Gradient, 25, 0.002, 2);
}

} // namespace
} // namespace gnomon
