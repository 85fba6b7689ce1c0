/// Huge spheres on the GPU against a long-double oracle: from just above the ground, from inside, from elsewhere, from
/// far away.
///
/// Which sphere is meant: the one of the scene's double-precision numbers, not of centre and radius in float32.
/// Bounds (docs/numerics.md)  with D the distance from the anchor, which lies under the eye: no wrong decision further
/// than 2^-22 D of the tangent point from tangency; t within 1 ulp + 2^-22 D / cosine; the surface point within
/// 2^-22 D of the surface, and half an ulp of its own coordinates; normals within 3e-7 of the exact one.

#include "lab/batch/ray_batch.h"
#include "tests/support/large_ground.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/plan/drawn.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <random>

namespace gnomon {
namespace {

using namespace test;

constexpr Real kPi = 3.14159265358979323846L;

class Rays {
  public:
    Rays(const Ground& ground, unsigned seed) : ground_(ground), random_(seed) {}

    BatchRay downward(Vec from) {
        Vec way = direction();
        if (glm::dot(way, up(from)) > 0) way = -way;
        return ray(from, way);
    }
    BatchRay anywhere(Vec from) { return ray(from, direction()); }
    /// Towards the horizon but for up to 2 % of its dip, log-uniform.
    BatchRay horizon(Vec from) {
        const Vec out = up(from);
        const Real dip = std::acos(ground_.radius / glm::length(Vec(glm::vec3(from)) - ground_.center));
        const Real offset = std::pow(10.0L, number(-5, std::log10(0.02L))) * (number(0, 1) < 0.5L ? -1 : 1);
        const Vec side = direction();
        const Vec level = glm::normalize(side - glm::dot(side, out) * out);
        const Real angle = dip * (1 + offset);
        return ray(from, std::cos(angle) * level - std::sin(angle) * out);
    }
    /// From far away towards a point of the sphere or just beside it.
    BatchRay towards(Vec from) { return ray(from, ground_.center + 1.02L * ground_.radius * direction() - from); }

    Vec direction() {
        const Real z = number(-1, 1), around = number(0, 2 * kPi), r = std::sqrt(1 - z * z);
        return {r * std::cos(around), r * std::sin(around), z};
    }
    Real number(Real low, Real high) { return low + (high - low) * Real(random_() >> 11) * 0x1p-53L; }

  private:
    Vec up(Vec from) const { return glm::normalize(from - ground_.center); }
    static BatchRay ray(Vec from, Vec way) {
        BatchRay ray;
        ray.origin = glm::vec3(from);
        ray.direction = glm::vec3(glm::normalize(way));
        return ray;
    }

    const Ground& ground_;
    std::mt19937_64 random_;
};

/// What the GPU got wrong in a set of rays; the worst errors as fractions of what the bounds allow.
struct Faults {
    int compared = 0, wrong = 0;
    Real inBand = 0; ///< worst wrong decision's distance from tangency: within the band by construction
    Real t = 0, point = 0, normal = 0;

    void compare(const Ground& ground, const BatchRay& ray, const BatchHit& hit);
    void comparePoint(const Ground& ground, const BatchHit& hit);
    void expectNone(const std::string& what, int rays) const {
        std::printf(
            "%-44s %6d compared, %d wrong (in the band up to %.2Lf of it); of the bounds: t %.2Lf, point %.2Lf, "
            "normal %.2Lf\n",
            what.c_str(), compared, wrong, inBand, t, point, normal);
        EXPECT_GE(compared, rays) << what;
        EXPECT_EQ(wrong, 0) << what;
        EXPECT_LE(t, 1.0L) << what;
        EXPECT_LE(point, 1.0L) << what;
        EXPECT_LE(normal, 1.0L) << what;
    }
};

void Faults::compare(const Ground& ground, const BatchRay& ray, const BatchHit& hit) {
    const Vec o(ray.origin), d(ray.direction);
    const Chord chord(ground.center, ground.radius, o, d);
    const bool inside = ray.side < 0 || (ray.side == 0 && ground.distance(o) < 0);
    const Real wanted = inside ? chord.leave : chord.entry;
    const bool hits = ray.side <= 0 && chord.depth > 0 && (inside || wanted > 0);
    const bool got = hit.object >= 0;
    // A ray from inside always leaves; one from outside may only graze, where the tangent point lies ahead.
    const Real band = boundAt(ground, chord.deepest);
    if (!inside && chord.t > 0 && std::abs(chord.depth) < band) {
        if (hits != got) inBand = std::max(inBand, std::abs(chord.depth) / band);
        return;
    }
    ++compared;
    wrong += hits != got;
    if (!hits || !got) return;
    const Vec met = o + wanted * d;
    const Real cosine = std::abs(glm::dot(d, met - ground.center)) / ground.radius;
    const Real allowed = ulp(wanted) + boundAt(ground, met) / cosine;
    t = std::max(t, std::abs(Real(hit.t) - wanted) / allowed);
    comparePoint(ground, hit);
}

void Faults::comparePoint(const Ground& ground, const BatchHit& hit) {
    const Vec p(hit.point), n(hit.normal), size = glm::abs(p);
    // Each coordinate is rounded by half an ulp, which counts by the normal's component along it.
    const Real rounding = (ulp(size.x) * std::abs(n.x) + ulp(size.y) * std::abs(n.y) + ulp(size.z) * std::abs(n.z)) / 2;
    point = std::max(point, std::abs(ground.distance(p)) / (boundAt(ground, p) + rounding));
    normal = std::max(normal, glm::length(n - glm::normalize(p - ground.center)) / 3e-7L);
}

class LargeSphere : public testing::TestWithParam<double> {
  protected:
    const Ground ground{GetParam()};
    std::unique_ptr<RayBatch> batch;

    void SetUp() override {
        offscreen();
        const Scene scene = sceneFrom(ground.json());
        ASSERT_EQ(drawnKinds(scene)[0], ShapeKind::LargeSphere);
        Problems problems;
        batch = std::make_unique<RayBatch>(scene, problems);
        ASSERT_TRUE(batch->valid()) << toString(problems);
    }
    template<class Make>
    Faults faultsOf(int count, const Make& make) {
        std::vector<BatchRay> rays(std::size_t(count), BatchRay{});
        for (BatchRay& ray : rays) ray = make();
        const std::vector<BatchHit> hits = batch->trace(rays);
        Faults faults;
        for (std::size_t i = 0; i < rays.size(); ++i) faults.compare(ground, rays[i], hits[i]);
        return faults;
    }
};

constexpr int kEach = 20000; // rays of each kind at each height
const Real kHeights[] = {0.01L, 1, 100};

TEST_P(LargeSphere, IsMetLikeTheOracleSaysFromAboveTheGround) {
    for (const Real height : kHeights) {
        const Vec eye = ground.over(0, 0, height);
        Rays rays(ground, 1);
        faultsOf(kEach, [&] {
            return rays.downward(eye);
        }).expectNone(format("r %g, %Lg above, downward", GetParam(), height), kEach * 95 / 100);
        faultsOf(kEach, [&] {
            return rays.horizon(eye);
        }).expectNone(format("r %g, %Lg above, horizon", GetParam(), height), kEach * 3 / 10);
    }
}

TEST_P(LargeSphere, IsMetLikeTheOracleSaysFromInside) {
    for (const Real depth : kHeights) {
        if (depth > ground.radius) continue;
        const Vec eye = ground.over(0, 0, -depth);
        Rays rays(ground, 2);
        faultsOf(kEach, [&] {
            return rays.anywhere(eye);
        }).expectNone(format("r %g, %Lg below, anywhere", GetParam(), depth), kEach);
    }
}

// The anchor lies under the eye, but rays start at mirrors and glass elsewhere, too.
TEST_P(LargeSphere, IsMetLikeTheOracleSaysFromFarFromItsAnchor) {
    for (const Real away : {0.01L, 0.1L, 0.5L, 1.0L, 1.5L}) {
        const Real height = ground.radius * 1e-3L;
        const Vec from = ground.center + (ground.radius + height) *
                                             glm::normalize(std::cos(away) * ground.up + std::sin(away) * ground.along);
        Rays rays(ground, 3);
        faultsOf(kEach, [&] {
            return rays.downward(from);
        }).expectNone(format("r %g, %.2Lf rad from the anchor, downward", GetParam(), away), kEach * 9 / 10);
        faultsOf(kEach, [&] {
            return rays.horizon(from);
        }).expectNone(format("r %g, %.2Lf rad from the anchor, horizon", GetParam(), away), kEach * 3 / 10);
    }
}

TEST_P(LargeSphere, IsMetLikeTheOracleSaysFromFarAway) {
    for (const Real far : {2.0L, 10.0L, 100.0L})
        for (const bool aboveAnchor : {true, false}) {
            Rays rays(ground, 4);
            const Vec way = aboveAnchor ? ground.up : glm::normalize(ground.along - 0.3L * ground.up);
            const Vec from = ground.center + far * ground.radius * way;
            faultsOf(kEach, [&] { return rays.towards(from); })
                .expectNone(format("r %g, %Lg r away, %s", GetParam(), far, aboveAnchor ? "above" : "aside"),
                            kEach * 9 / 10);
        }
}

// A ray that starts on the ground leaves it for good, or meets the far side: never its own start.
TEST_P(LargeSphere, IsNotMetAgainByRaysThatStartOnIt) {
    const Vec eye = ground.over(0, 0, std::min<Real>(1, ground.radius / 1000));
    Rays rays(ground, 5);
    std::vector<BatchRay> first(kEach);
    for (BatchRay& ray : first) ray = rays.downward(eye);
    std::vector<BatchRay> outward, inward;
    for (const BatchHit& hit : batch->trace(first)) {
        if (hit.object < 0) continue;
        BatchRay ray;
        ray.origin = hit.point;
        const Vec way = rays.direction();
        ray.direction = glm::vec3(glm::dot(way, Vec(hit.normal)) < 0 ? -way : way);
        ray.side = 1;
        outward.push_back(ray);
        ray.direction = -ray.direction;
        ray.side = -1;
        inward.push_back(ray);
    }
    ASSERT_GT(outward.size(), std::size_t(kEach) * 9 / 10);
    int acne = 0;
    for (const BatchHit& hit : batch->trace(outward)) acne += hit.object >= 0;
    EXPECT_EQ(acne, 0);
    const std::vector<BatchHit> leaving = batch->trace(inward);
    Faults faults;
    for (std::size_t i = 0; i < inward.size(); ++i) {
        const Vec o(inward[i].origin), d(inward[i].direction);
        if (std::abs(glm::dot(d, glm::normalize(o - ground.center))) < 1e-3L) continue; // along the ground
        faults.compare(ground, inward[i], leaving[i]);
    }
    faults.expectNone(format("r %g, from the ground inward", GetParam()), int(inward.size()) * 9 / 10);
}

INSTANTIATE_TEST_SUITE_P(Radii, LargeSphere, testing::Values(1e4, 1e3, 9e5, 1.0),
                         [](const auto& test) { return format("%.0f", test.param); });

} // namespace
} // namespace gnomon
