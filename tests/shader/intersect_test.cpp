/// The intersectors on the GPU, ray by ray, against a long-double oracle: spheres and tori from 3 to 10 000 units,
/// uniform and grazing rays, thin and fat.
///
/// Bounds (docs/numerics.md)  no wrong decision further than 2^-22 of the size from tangency; o + t d within 1.5 ulp of
/// the distance of the surface, the point within 4 · 2^-23 of the size; normals unit.

#include "tests/shader/first_root.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/lab/ray_batch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gnomon {
namespace {

using namespace test;
using Vec = glm::tvec3<Real>;

/// A body about the origin; the torus' axis is z.
struct Body {
    const char* name;
    Real major, minor; ///< a sphere where major is 0

    Real size() const { return major + minor; }
    Real distance(Vec p) const {
        return major == 0 ? glm::length(p) - minor : std::hypot(std::hypot(p.x, p.y) - major, p.z) - minor;
    }
    std::string json() const {
        char text[200];
        if (major == 0)
            std::snprintf(text, sizeof text, R"({"sphere": {"center": [0, 0, 0], "radius": %.9Lg}})", minor);
        else
            std::snprintf(
                text, sizeof text,
                R"({"torus": {"center": [0, 0, 0], "axis": [0, 0, 1], "major_radius": %.9Lg, "minor_radius": %.9Lg}})",
                major, minor);
        return text;
    }
};
std::ostream& operator<<(std::ostream& out, const Body& body) { return out << body.name; }

// Radii that float32 holds exactly: the oracle and the shader mean the same body.
const Body kBodies[] = {{"sphere", 0, 1}, {"thinTorus", 1, 0.0078125L}, {"torus", 1, 0.25L}, {"fatTorus", 1, 0.875L}};

class Rays {
  public:
    Rays(const Body& body, unsigned seed) : body_(body), random_(seed) {}

    /// From distance `far` towards a point somewhere within the bounding sphere.
    BatchRay uniform(Real far) {
        const Vec origin = far * body_.size() * direction();
        return ray(origin, body_.size() * std::cbrt(number(0, 1)) * direction() - origin);
    }
    /// From distance `far` towards a point of the surface.
    BatchRay towardsSurface(Real far) {
        const Vec origin = far * body_.size() * direction();
        return ray(origin, surface().point - origin);
    }
    /// Tangent to the surface but for an offset of 1e-8 … 1e-2 of the size, in or out.
    BatchRay grazing(Real far) {
        const auto [middle, normal] = surface();
        const Real offset = std::pow(10.0L, number(-8, -2)) * (number(0, 1) < 0.5L ? -1 : 1) * body_.size();
        const Vec point = middle + offset * normal;
        Vec along = direction();
        along = glm::normalize(along - glm::dot(along, normal) * normal);
        return ray(point - far * body_.size() * along, along);
    }

    Vec direction() {
        const Real z = number(-1, 1), around = number(0, 2 * kPi), r = std::sqrt(1 - z * z);
        return {r * std::cos(around), r * std::sin(around), z};
    }
    Real number(Real low, Real high) { return low + (high - low) * Real(random_() >> 11) * 0x1p-53L; }

  private:
    static constexpr Real kPi = 3.14159265358979323846L;

    struct Spot {
        Vec point, normal;
    };
    Spot surface() {
        const Real around = number(0, 2 * kPi), across = number(0, 2 * kPi);
        const Vec ring(std::cos(around), std::sin(around), 0);
        const Vec normal = body_.major == 0 ? direction() : std::cos(across) * ring + std::sin(across) * Vec(0, 0, 1);
        return {body_.major * ring + body_.minor * normal, normal};
    }
    static BatchRay ray(Vec origin, Vec along) {
        BatchRay ray;
        ray.origin = glm::vec3(origin);
        ray.direction = glm::vec3(glm::normalize(along));
        return ray;
    }

    const Body& body_;
    std::mt19937_64 random_;
};

/// What the GPU got wrong in a set of rays, beyond the band about tangency.
struct Faults {
    int judged = 0, missed = 0, invented = 0, elsewhere = 0;
    Real worstAlong = 0; ///< |distance(o + t d)| in ulp of the distance travelled
    Real worstPoint = 0; ///< |distance(P)| in 2^-23 of the size
    Real worstNormal = 0;
};

Real ulp(Real x) { return std::ldexp(1.0L, std::ilogb(x) - 23); }

/// Somewhere between where the ray should stop and where it does it is off the surface: it stops elsewhere, or on
/// another sheet. `along` is the signed distance along the ray.
template<class Distance>
bool isElsewhere(const Body& body, Real wanted, Real got, const Distance& along) {
    const Real slack = 4 * (ulp(std::max(wanted, body.size())) + ulp(body.size()));
    const int steps = 32;
    for (int i = 0; i <= steps; ++i)
        if (std::abs(along(wanted + (got - wanted) * i / steps)) > slack) return true;
    return false;
}

void judge(const Body& body, const BatchRay& ray, const BatchHit& hit, Faults& faults) {
    const Vec o(ray.origin), d(ray.direction);
    const Real middle = -glm::dot(o, d) / glm::dot(d, d), reach = 1.01L * body.size();
    const auto along = [&](Real t) { return body.distance(o + t * d); };
    const bool inside = body.distance(o) < 0;
    const Real from = std::max<Real>(middle - reach, 0), to = middle + reach;
    const FirstRoot root = from < to ? firstRoot(along, from, to, inside) : FirstRoot{};
    if (root.tangency < std::ldexp(body.size(), -22)) return; // too near to tangency for float32 to decide
    ++faults.judged;
    const bool got = hit.object >= 0;
    faults.missed += root.hit && !got;
    faults.invented += !root.hit && got;
    if (!root.hit || !got) return;
    faults.elsewhere += isElsewhere(body, root.t, hit.t, along);
    faults.worstAlong = std::max(faults.worstAlong, std::abs(along(hit.t)) / (ulp(std::max(root.t, body.size()))));
    faults.worstPoint =
        std::max(faults.worstPoint, std::abs(body.distance(Vec(hit.point))) / std::ldexp(body.size(), -23));
    faults.worstNormal = std::max(faults.worstNormal, std::abs(glm::length(Vec(hit.normal)) - 1));
}

class Intersect : public testing::TestWithParam<Body> {};

TEST_P(Intersect, DecidesLikeTheOracleFromThreeToTenThousandUnits) {
    const Body& body = GetParam();
    offscreen();
    Problems problems;
    RayBatch batch(sceneFrom(R"({"objects": [)" + body.json() + "]}"), problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    const int each = 20000; // of each kind at each distance: 200 000 a body
    for (const Real far : {3.0L, 10.0L, 100.0L, 1000.0L, 10000.0L})
        for (const bool grazing : {false, true}) {
            Rays rays(body, unsigned(far) + grazing);
            std::vector<BatchRay> asked(each);
            for (BatchRay& ray : asked) ray = grazing ? rays.grazing(far) : rays.uniform(far);
            const std::vector<BatchHit> answers = batch.trace(asked);
            Faults faults;
            for (int i = 0; i < each; ++i) judge(body, asked[i], answers[i], faults);
            std::printf(
                "%-10s %-8s %6.0Lf units: %d missed, %d invented, %d elsewhere; o+td %.2Lf ulp, point %.2Lf · 2^-23\n",
                body.name, grazing ? "grazing" : "uniform", far, faults.missed, faults.invented, faults.elsewhere,
                faults.worstAlong, faults.worstPoint);
            EXPECT_GT(faults.judged, grazing ? each * 6 / 10 : each * 99 / 100)
                << "rays that are not too near to tangency";
            EXPECT_EQ(faults.missed, 0);
            EXPECT_EQ(faults.invented, 0);
            EXPECT_EQ(faults.elsewhere, 0);
            EXPECT_LE(faults.worstAlong, 1.5L);
            EXPECT_LE(faults.worstPoint, 4.0L);
            EXPECT_LE(faults.worstNormal, 3e-7L);
        }
}

// A ray that leaves a torus' surface starts from the point that an earlier ray found, and names the side it travels on:
// it neither meets its own start again nor misses the rest of the tube.
TEST_P(Intersect, NeitherMeetsItsOwnStartNorMissesTheRest) {
    const Body& body = GetParam();
    offscreen();
    Problems problems;
    RayBatch batch(sceneFrom(R"({"objects": [)" + body.json() + "]}"), problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    Rays rays(body, 7);
    std::vector<BatchRay> first(30000);
    for (BatchRay& ray : first) ray = rays.towardsSurface(10);
    std::vector<BatchRay> second;
    std::vector<glm::vec3> normals; // where they start
    for (const BatchHit& hit : batch.trace(first))
        for (const float side : {1.0f, -1.0f}) {
            if (hit.object < 0) continue;
            BatchRay ray;
            ray.origin = hit.point;
            ray.side = side;
            const Vec towards = rays.direction();
            const Vec way = glm::dot(towards, Vec(hit.normal)) * side < 0 ? -towards : towards;
            ray.direction = glm::vec3(way);
            if (std::abs(glm::dot(way, Vec(hit.normal))) < 0.01L) continue;
            second.push_back(ray);
            normals.push_back(hit.normal);
        }
    ASSERT_GT(second.size(), 50000u);
    const std::vector<BatchHit> answers = batch.trace(second);
    int acne = 0, wrong = 0;
    for (std::size_t i = 0; i < second.size(); ++i) {
        const BatchRay& ray = second[i];
        const Vec o(ray.origin), d(ray.direction);
        const auto along = [&](Real t) { return body.distance(o + t * d); };
        // By then the ray is further from the surface than its start can be.
        const Real clear = std::ldexp(body.size(), -21) / std::abs(glm::dot(d, Vec(normals[i])));
        const FirstRoot root = firstRoot(along, clear, 3 * body.size(), ray.side < 0, 1024);
        if (root.tangency < std::ldexp(body.size(), -21)) continue;
        acne += answers[i].object >= 0 && answers[i].t < clear;
        const bool got = answers[i].object >= 0;
        wrong += root.hit != got || (got && isElsewhere(body, root.t, answers[i].t, along));
    }
    EXPECT_EQ(acne, 0);
    EXPECT_EQ(wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(Bodies, Intersect, testing::ValuesIn(kBodies),
                         [](const auto& test) { return std::string(test.param.name); });

/// A fan of triangles about a vertex: the rays go exactly through its edges and its middle.
class Watertight : public testing::TestWithParam<glm::dvec3> {};

TEST_P(Watertight, LetsNoRayThroughAnEdgeOrAVertex) {
    const glm::dvec3 middle = GetParam();
    const int spokes = 6;
    std::vector<glm::vec3> rim;
    std::string objects;
    std::mt19937_64 random(3);
    const auto number = [&](double low, double high) { return low + (high - low) * double(random() >> 11) * 0x1p-53; };
    for (int i = 0; i < spokes; ++i) {
        const double angle = 6.283185307179586 * i / spokes;
        rim.emplace_back(middle + glm::dvec3(std::cos(angle), std::sin(angle), number(-0.3, 0.3)));
    }
    const auto text = [](glm::dvec3 v) {
        char buffer[120];
        std::snprintf(buffer, sizeof buffer, "[%.17g, %.17g, %.17g]", v.x, v.y, v.z);
        return std::string(buffer);
    };
    for (int i = 0; i < spokes; ++i)
        objects += (i ? "," : "") + (R"({"triangle": {"vertices": [)" + text(glm::vec3(middle))) + "," + text(rim[i]) +
                   "," + text(rim[(i + 1) % spokes]) + "]}}";
    offscreen();
    Problems problems;
    RayBatch batch(sceneFrom(R"({"objects": [)" + objects + "]}"), problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    // The origin is on a coarse grid and the direction a difference of floats, so that edges are met as exactly as they
    // can be.
    std::vector<BatchRay> rays(200000);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const float along = i % 4 == 0 ? 0.0f : float(number(0, 0.9));
        const glm::vec3 center(middle);
        const glm::vec3 aim = center + along * (rim[i % spokes] - center);
        const glm::vec3 away(float(number(-2, 2)), float(number(-2, 2)), float(number(3, 9)));
        rays[i].origin = aim + away;
        rays[i].direction = glm::normalize(aim - rays[i].origin);
    }
    int leaks = 0;
    for (const BatchHit& hit : batch.trace(rays)) leaks += hit.object < 0;
    EXPECT_EQ(leaks, 0);
}

INSTANTIATE_TEST_SUITE_P(Places, Watertight, testing::Values(glm::dvec3(0), glm::dvec3(148376, 1234, -223423)),
                         [](const auto& test) { return test.param.x == 0 ? "AtTheOrigin" : "FarAway"; });

} // namespace
} // namespace gnomon
