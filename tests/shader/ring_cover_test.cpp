/// Shadows of a torus by `silhouette` against rays in double that step by the exact distance: from about it and from
/// within its hole, from on the torus itself, thick and thin, under small lights and wide ones.

#include "lab/batch/light_batch.h"
#include "lab/intersect/subjects.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gnomon {
namespace {

using namespace test;
using oracle::sceneOf;

struct Ring {
    glm::dvec3 center, axis;
    double major, minor;

    double distance(glm::dvec3 p) const {
        const glm::dvec3 off = p - center;
        const double z = glm::dot(off, axis);
        return std::hypot(glm::length(off - z * axis) - major, z) - minor;
    }
};

/// Where the receivers are, against a torus whose major radius is 1.
enum class From { Afar, Near, Hole, Itself };

class Dice {
  public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    double number(double low, double high) {
        return low + (high - low) * (double(engine_() >> 11) / double(1ull << 53));
    }
    glm::dvec3 direction() {
        const double z = number(-1, 1), phi = number(0, 6.283185307179586), r = std::sqrt(1 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }

  private:
    std::mt19937_64 engine_;
};

struct Receiver {
    BatchLit lit;
    glm::dvec3 normal{0};
};

glm::dvec3 turnedAbout(glm::dvec3 axis) {
    return glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
}

/// On the surface, and the normal there.
std::pair<glm::dvec3, glm::dvec3> onTube(const Ring& ring, double u, double v) {
    const glm::dvec3 x = turnedAbout(ring.axis), y = glm::cross(ring.axis, x);
    const glm::dvec3 out = std::cos(u) * x + std::sin(u) * y;
    const glm::dvec3 normal = std::cos(v) * out + std::sin(v) * ring.axis;
    return {ring.center + ring.major * out + ring.minor * normal, normal};
}

Receiver receiverFrom(From from, const Ring& ring, Dice& dice) {
    Receiver receiver;
    for (;;) {
        const double turn = 6.283185307179586;
        auto [point, normal] = onTube(ring, dice.number(0, turn), dice.number(0, turn));
        if (from == From::Afar) point = ring.center + dice.number(2, 12) * dice.direction();
        if (from == From::Near) point += std::pow(10.0, dice.number(-3, 0)) * dice.direction();
        if (from == From::Hole) point = ring.center + dice.number(0, 0.8) * (1 - ring.minor) * dice.direction();
        const double away = dice.number(1, 10);
        // Half of them past the tube.
        const glm::dvec3 aim = onTube(ring, dice.number(0, turn), dice.number(0, turn)).first + 0.1 * dice.direction();
        const glm::dvec3 any = dice.direction();
        glm::dvec3 towards = dice.number(0, 1) < 0.5 ? glm::normalize(aim - point) : any;
        if (from == From::Itself && glm::dot(towards, normal) < 0) towards = -towards;
        const glm::dvec3 light = point + away * towards;
        const double radius = std::pow(10.0, dice.number(std::log10(0.05), std::log10(4.0)));
        if (radius > 0.9 * away || ring.distance(light) < radius) continue;
        if (from != From::Itself && ring.distance(point) < 1e-4) continue;
        receiver.lit.point = point;
        receiver.lit.light = light;
        receiver.lit.radius = float(radius);
        receiver.lit.normal = from == From::Itself ? normal : towards;
        receiver.lit.object = from == From::Itself ? 0 : -1;
        if (from == From::Itself) receiver.normal = normal;
        return receiver;
    }
}

bool meets(const Ring& ring, glm::dvec3 point, glm::dvec3 v) {
    const double stretch = glm::length(v), end = stretch;
    const glm::dvec3 d = v / stretch;
    for (double t = 1e-6; t < end;) {
        const double free = ring.distance(point + t * d);
        if (free < 1e-7) return true;
        t += free;
    }
    return false;
}

/// Fraction of the light's disc that `count` rays see.
double seenByRays(const Ring& ring, const Receiver& receiver, int count) {
    const glm::dvec3 point(receiver.lit.point), toLight = glm::dvec3(receiver.lit.light) - point;
    const double distance = glm::length(toLight), sine = std::min(double(receiver.lit.radius) / distance, 0.999);
    const glm::dvec3 x = sine / std::sqrt(1 - sine * sine) * distance * turnedAbout(toLight / distance),
                     y = glm::cross(toLight / distance, x);
    const bool own = receiver.lit.object >= 0;
    const glm::dvec3 start = own ? point + 1e-6 * receiver.normal : point;
    int seen = 0;
    for (int i = 0; i < count; ++i) {
        const double r = std::sqrt((i + 0.5) / count), phi = 2.399963229728653 * i;
        const glm::dvec3 v = toLight + r * (std::cos(phi) * x + std::sin(phi) * y);
        if (own && glm::dot(v, receiver.normal) <= 0) continue;
        seen += !meets(ring, start, v);
    }
    return double(seen) / count;
}

class RingCover : public testing::TestWithParam<std::tuple<From, double>> {};

TEST_P(RingCover, IsWhatRaysSee) {
    offscreen();
    const auto [from, minor] = GetParam();
    Dice dice(unsigned(from) * 100 + unsigned(minor * 64));
    const glm::dvec3 axis = glm::dvec3(glm::vec3(dice.direction()));
    const Ring ring{{0.25, -0.5, 1}, axis / glm::length(axis), 1, minor};
    const Shape shape = makeShape(ShapeKind::Torus, {ring.center, ring.axis}, {ring.major, ring.minor});
    constexpr int receivers = 400, rays = 4096;
    std::vector<Receiver> all;
    std::vector<BatchLit> lit;
    for (int i = 0; i < receivers; ++i) all.push_back(receiverFrom(from, ring, dice)), lit.push_back(all.back().lit);
    Settings settings;
    settings.shadows = ShadowModel::Silhouette;
    Problems problems;
    LightBatch batch(sceneOf({shape}), settings, problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    const auto shades = batch.shade(lit);
    double squares = 0, worst = 0;
    int soft = 0;
    for (int i = 0; i < receivers; ++i) {
        const double exact = seenByRays(ring, all[i], rays), error = std::abs(shades[i].visibility - exact);
        soft += exact > 0.01 && exact < 0.99;
        squares += error * error / receivers;
        worst = std::max(worst, error);
    }
    std::printf("rms %.4f worst %.4f, %d of %d soft\n", std::sqrt(squares), worst, soft, receivers);
    EXPECT_GT(soft, receivers / 20);
    EXPECT_LE(std::sqrt(squares), 0.002);
    EXPECT_LE(worst, from == From::Near ? 0.015 : 0.01);
}

std::string nameOf(const testing::TestParamInfo<std::tuple<From, double>>& test) {
    static const char* const kNames[] = {"Afar", "Near", "InItsHole", "OnItself"};
    return std::string(kNames[int(std::get<0>(test.param))]) + "Minor" +
           std::to_string(int(std::get<1>(test.param) * 128)) + "Of128";
}
INSTANTIATE_TEST_SUITE_P(Places, RingCover,
                         testing::Combine(testing::Values(From::Afar, From::Near, From::Hole, From::Itself),
                                          testing::Values(1.0 / 128, 0.0625, 0.25, 0.5, 0.875)),
                         nameOf);

} // namespace
} // namespace gnomon
