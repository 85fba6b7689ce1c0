/// Reflectance on the GPU against the Fresnel equations in long double, and against what is known of materials.

#include "lab/batch/light_batch.h"
#include "lab/reference/exact/fresnel.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace gnomon {
namespace {

using namespace test;
using Real = long double;

/// A surface and a ray: n and k beyond, the index on the ray's side, the cosine to the normal.
struct Incidence {
    float cosine = 1, n = 1.5f, k = 0, index = 1;
};

/// What the shader makes of them, with the shadow model's place for it: the receiver is (n, k, index), the light's
/// radius the cosine.
std::vector<float> reflected(const std::string& call, const std::vector<Incidence>& all) {
    offscreen();
    const std::string text = "#include \"shade/fresnel.glsl\"\nfloat visibility(ShadowQuery query) {\n"
                             "vec3 m = query.ray.origin; float cosine = query.lightRadius; return " +
                             call + "; }\n";
    const std::vector<ShaderFile> overrides{{"shadow/hard.glsl", text}};
    Problems problems;
    LightBatch batch(sceneFrom(R"({"materials": {"c": {"coat": {"ior": 1.5}}, "m": {"conductor": {"n": 1, "k": 1}}},
        "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "c"},
                    {"sphere": {"center": [5, 0, 0], "radius": 1}, "material": "m"}]})"),
                     {}, problems, overrides);
    EXPECT_TRUE(batch.valid()) << toString(problems);
    if (!batch.valid()) return {};
    std::vector<BatchLit> lit;
    for (const Incidence& in : all) {
        BatchLit one;
        one.point = {in.n, in.k, in.index};
        one.light = one.point + glm::vec3(0, 0, 10);
        one.radius = in.cosine;
        lit.push_back(one);
    }
    std::vector<float> values;
    for (const BatchShade& shade : batch.shade(lit)) values.push_back(shade.visibility);
    return values;
}

std::vector<float> dielectrics(const std::vector<Incidence>& all) {
    return reflected("fresnelDielectric(cosine, m.z, m.x)", all);
}
std::vector<float> metals(const std::vector<Incidence>& all) {
    return reflected("fresnelConductor(cosine, vec3(m.x), vec3(m.y)).g", all);
}

Real exact(const Incidence& in, Real cosine) {
    return oracle::fresnelReflectance(cosine, std::complex<Real>(Real(in.n) / in.index, Real(in.k) / in.index));
}

/// How far the value is from what the equations say for cosines up to `ulps` of 2^-23 away.
Real off(float value, const Incidence& in, int ulps) {
    Real least = 1, most = 0;
    for (int i = -2 * ulps; i <= 2 * ulps; ++i) {
        const Real r = exact(in, std::clamp<Real>(in.cosine * (1 + i * 0x1p-24L), 0, 1));
        least = std::min(least, r);
        most = std::max(most, r);
    }
    return std::isnan(value) ? Real(1) : std::max<Real>({0, least - value, value - most});
}

/// The worst of all, for the header's bound and for the figures beside it.
Real worst(const char* name, const std::vector<float>& values, const std::vector<Incidence>& all) {
    EXPECT_EQ(values.size(), all.size());
    Real most = 0, strict = 0, plain = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Real by = off(values[i], all[i], 4);
        if (by > most) at = i;
        most = std::max(most, by);
        strict = std::max(strict, off(values[i], all[i], 2));
        plain = std::max(plain, off(values[i], all[i], 0));
    }
    const Incidence& in = all[at];
    std::printf("%s: %zu values, %.2Lg beside a cosine of 4 ulp, %.2Lg of 2, %.2Lg of none; worst n %.9g k %.9g index "
                "%.9g cosine %.9g\n",
                name, values.size(), most, strict, plain, in.n, in.k, in.index, in.cosine);
    return most;
}

/// Cosines from grazing to straight: 0, 1, even ones, and ever smaller ones.
class Cosines {
  public:
    float next() {
        const double u = number_(random_);
        switch (count_++ % 8) {
        case 0: return count_ % 16 < 8 ? 0.0f : 1.0f;
        case 1:
        case 2: return float(std::pow(10.0, -8 * u));
        case 3: return float(1 - std::pow(10.0, -8 * u));
        default: return float(u);
        }
    }
    double number() { return number_(random_); }

  private:
    std::mt19937_64 random_{5};
    std::uniform_real_distribution<double> number_{0, 1};
    int count_ = 0;
};

constexpr double kBound = 1e-6; // as shaders/shade/fresnel.glsl states it, beside 4 ulp of the cosine

// From either side, of index 1.0001 to 4, at total reflection and a hair before it.
TEST(FresnelDielectric, IsTheEquationsOwn) {
    Cosines random;
    std::vector<Incidence> all;
    for (int i = 0; i < 200000; ++i) {
        const double above = i % 2 ? 3 * random.number() : std::pow(10.0, -4 + 4.5 * random.number());
        Incidence in{random.next(), float(1 + std::clamp(above, 1e-4, 3.0)), 0, 1};
        const bool leaving = i % 4 >= 2;
        if (leaving) std::swap(in.n, in.index);
        if (leaving && i % 3 == 0) { // about the critical angle
            const Real ratio = Real(in.n) / in.index;
            const double by = 1 + std::pow(10.0, -7 * random.number()) * (random.number() - 0.5);
            in.cosine = float(std::clamp<Real>(std::sqrt(1 - ratio * ratio) * by, 0, 1));
        }
        all.push_back(in);
    }
    EXPECT_LE(worst("dielectrics", dielectrics(all), all), kBound);
}

TEST(FresnelDielectric, ReflectsAllBeyondTheCriticalAngleAndNothingOfNoSurface) {
    std::vector<Incidence> total, none;
    for (const float cosine : {0.0f, 1e-6f, 0.1f, 0.5f, 0.74f}) total.push_back({cosine, 1, 0, 1.5f});
    for (const float cosine : {0.0f, 1e-6f, 0.1f, 1.0f}) none.push_back({cosine, 1.25f, 0, 1.25f});
    for (const float value : dielectrics(total)) EXPECT_EQ(value, 1.0f);
    for (const float value : dielectrics(none)) EXPECT_EQ(value, 0.0f);
}

TEST(FresnelConductor, IsTheEquationsOwn) {
    Cosines random;
    const auto anyOf = [&] {
        const double u = random.number();
        return float(random.number() < 0.5 ? 20 * u : std::pow(10.0, -6 + 7.3 * u));
    };
    std::vector<Incidence> all;
    for (int i = 0; i < 200000; ++i) {
        const double u = random.number();
        Incidence in{random.next(), anyOf(), anyOf(), 1};
        if (i % 10 == 0) in.k = 0;
        if (i % 10 == 1) in.n = 0;
        if (i % 10 == 2) in.n = float(1 + 1e-4 * u), in.k = float(1e-4 * random.number());
        all.push_back(in);
    }
    EXPECT_LE(worst("conductors", metals(all), all), kBound);
}

// Gold, silver and aluminium in red light, copper, iron: what tables say.
TEST(FresnelConductor, IsThatOfMetalsInTables) {
    Cosines random;
    const glm::vec2 tables[] = {{0.17f, 3.1f}, {0.14f, 4.1f}, {1.35f, 7.47f}, {0.27f, 3.41f}, {2.91f, 3.09f}};
    std::vector<Incidence> all;
    for (const glm::vec2 metal : tables)
        for (int i = 0; i < 4000; ++i) all.push_back({random.next(), metal.x, metal.y, 1});
    EXPECT_LE(worst("metals", metals(all), all), kBound);
    const std::vector<float> straight = metals({{1, 0.17f, 3.1f, 1}, {1, 1.35f, 7.47f, 1}, {1, 0, 0, 1}, {0, 0, 0, 1}});
    EXPECT_NEAR(straight[0], 0.938, 5e-4) << "gold";
    EXPECT_NEAR(straight[1], 0.912, 5e-4) << "aluminium";
    EXPECT_EQ(straight[2], 1.0f) << "nothing enters an index of 0";
    EXPECT_EQ(straight[3], 1.0f);
}

/// The middle of a plane seen at an angle, in a white room.
float seenAt(double degrees, const std::string& material, const std::string& more = "") {
    const double a = glm::radians(degrees);
    const Scene scene = sceneFrom(
        "{" + more + R"("camera": {"eye": [)" + std::to_string(5 * std::sin(a)) + ", " +
        std::to_string(5 * std::cos(a)) + R"(, 0], "target": [0, 0, 0], "up": [0, 0, 1], "fov": 1},
        "background": {"color": 1}, "materials": {"m": {)" +
        material + R"(}}, "objects": [{"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}, "material": "m"}]})");
    Settings settings;
    settings.size = {3, 3};
    return *outputOf(scene, settings, Aov::Color).at(1, 1);
}

TEST(Fresnel, IsThatOfWaterSeenAtALowAngle) {
    EXPECT_NEAR(seenAt(84, R"("coat": {"ior": 1.333})"), 0.525, 1e-3);
    EXPECT_NEAR(seenAt(84, R"("dielectric": {"ior": 1.333})"), 0.525 + 0.475, 1e-3) << "and the rest goes through";
    EXPECT_NEAR(seenAt(84, R"("coat": {"ior": 1.333})", R"("fresnel": "schlick",)"), 0.584, 1e-3);
}

TEST(Fresnel, IsThatOfMetalsWhereSchlicksIsNot) {
    // Aluminium is darkest at 80 degrees; Schlick's approximation only rises.
    const std::string aluminium = R"("conductor": {"n": 1.35, "k": 7.47})";
    const auto wanted = [](double degrees) {
        return double(oracle::fresnelReflectance<Real>(std::cos(glm::radians(degrees)), {1.35L, 7.47L}));
    };
    for (const double degrees : {0.5, 30.0, 60.0, 80.0, 88.0})
        EXPECT_NEAR(seenAt(degrees, aluminium), wanted(degrees), 1e-4) << degrees;
    EXPECT_GT(std::abs(seenAt(80, aluminium, R"("fresnel": "schlick",)") - wanted(80)), 0.04);
}

TEST(Mirror, ReflectsItsFractionAtEveryAngle) {
    for (const char* fresnel : {"", R"("fresnel": "schlick",)"})
        for (const double degrees : {0.5, 45.0, 89.0}) {
            EXPECT_FLOAT_EQ(seenAt(degrees, R"("mirror": 0.7)", fresnel), 0.7f) << degrees;
            EXPECT_FLOAT_EQ(seenAt(degrees, R"("mirror": [0.25, 0.5, 1], "emission": 0.5)", fresnel), 0.75f);
        }
}

} // namespace
} // namespace gnomon
