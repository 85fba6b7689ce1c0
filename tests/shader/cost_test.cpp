/// What exactness costs: the library's intersectors against the textbook ones of tests/textbook, on llvmpipe.
///
/// Ours and the textbook's run in turn; time is the CPU time of the process with all its threads, which the GL in
/// software runs in, so that what else the machine does weighs little. A program keeps the luck of where the GL put
/// its code: one of seven is half as slow again for as long as it lives. So each figure is of several goes with
/// programs made anew, a go's time is the median of its turns, and the quickest goes of both are compared, as bad luck
/// only costs. Rays go from a distance to points spread evenly in the bounding sphere, in no order: the eight rays that
/// llvmpipe takes in lock step have nothing to do with each other.

#include "lab/batch/ray_batch.h"
#include "lab/reference/textbook/textbook.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <span>

namespace gnomon {
namespace {

using namespace test;

/// One shape about the origin.
struct Subject {
    const char *name, *json;
    double size;  ///< radius of the bounding sphere
    double bound; ///< cost over the textbook's
};
std::ostream& operator<<(std::ostream& out, const Subject& subject) { return out << subject.name; }

const Subject kTorus{"torus",
                     R"({"torus": {"center": [0, 0, 0], "axis": [0, 0, 1], "major_radius": 1, "minor_radius": 0.25}})",
                     1.25, 2.5};
const Subject kSubjects[] = {
    {"sphere", R"({"sphere": {"center": [0, 0, 0], "radius": 1}})", 1, 4},
    {"plane", R"({"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}})", 1, 4},
    {"disc", R"({"disc": {"center": [0, 0, 0], "normal": [0, 0.6, 0.8], "radius": 1}})", 1, 4},
    {"triangle", R"({"triangle": {"vertices": [[-1, -0.5, 0], [1, -0.5, 0.2], [0, 1, -0.2]]}})", 1.2, 4},
    kTorus,
    {"box", R"({"box": {"center": [0, 0, 0], "half_size": [0.6, 0.5, 0.6]}})", 1, 4},
    {"cylinder", R"({"cylinder": {"from": [0, -0.8, 0.1], "to": [0, 0.8, -0.1], "radius": 0.6}})", 1, 4},
    {"capsule", R"({"capsule": {"from": [-0.5, 0, 0.1], "to": [0.5, 0.2, 0], "radius": 0.4}})", 1, 4},
    {"cone", R"({"cone": {"from": [0, -0.7, 0], "to": [0.1, 0.7, 0], "radius": 0.7}})", 1, 4},
};

Scene sceneOf(const Subject& subject) { return sceneFrom(std::string(R"({"objects": [)") + subject.json + "]}"); }

std::vector<BatchRay> raysInto(const Subject& subject, double distance, int count) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> number(0, 1);
    const auto direction = [&] {
        const double z = 2 * number(random) - 1, around = 6.283185307179586 * number(random), r = std::sqrt(1 - z * z);
        return glm::dvec3(r * std::cos(around), r * std::sin(around), z);
    };
    std::vector<BatchRay> rays(std::size_t(count), BatchRay{});
    for (BatchRay& ray : rays) {
        const glm::dvec3 origin = distance * direction();
        const glm::dvec3 target = subject.size * std::cbrt(number(random)) * direction();
        ray.origin = glm::vec3(origin);
        ray.direction = glm::vec3(glm::normalize(target - origin));
    }
    return rays;
}

/// The programs of one go, told to run: seconds each.
struct Pair {
    std::function<double()> ours, textbook;
};

struct Ratio {
    double ratio = 0;         ///< of the quickest goes
    double low = 0, high = 0; ///< quarter and three quarters of the goes
    double ours = 0;          ///< seconds, of the quickest go
};

double medianOf(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(values.size() / 2));
    return values[values.size() / 2];
}

Ratio ratioOf(const std::function<Pair()>& makeAnew) {
    const int goes = 7, turns = 5;
    std::vector<double> ours, textbook, ratios;
    for (int go = 0; go < goes; ++go) {
        const Pair pair = makeAnew();
        pair.ours(), pair.textbook(); // compiles for this target
        std::vector<double> a, b;
        for (int turn = 0; turn < turns; ++turn) a.push_back(pair.ours()), b.push_back(pair.textbook());
        ours.push_back(medianOf(a)), textbook.push_back(medianOf(b));
        ratios.push_back(ours.back() / textbook.back());
    }
    std::ranges::sort(ratios);
    const double quickest = std::ranges::min(ours);
    return {quickest / std::ranges::min(textbook), ratios[goes / 4], ratios[goes - 1 - goes / 4], quickest};
}

void print(const std::string& what, const Ratio& ratio, double each, const char* unit) {
    std::printf("%-24s %.2f times the textbook's (half of the programs %.2f to %.2f), %.3g %s\n", what.c_str(),
                ratio.ratio, ratio.low, ratio.high, ratio.ours * each, unit);
}

Ratio intersectCost(const Subject& subject, double distance) {
    const int count = 512 * 64, repeats = 16;
    const std::vector<BatchRay> rays = raysInto(subject, distance, count);
    const auto batch = [&](std::span<const ShaderFile> overrides) -> std::function<double()> {
        Problems problems;
        const auto made = std::make_shared<RayBatch>(sceneOf(subject), problems, overrides);
        EXPECT_TRUE(made->valid()) << toString(problems);
        return [=, &rays] { return made->valid() ? made->seconds(rays, repeats, processSeconds) : 0; };
    };
    const Ratio ratio = ratioOf([&] { return Pair{batch({}), batch(textbookShaders())}; });
    char what[64];
    std::snprintf(what, sizeof what, "%s from %g units", subject.name, distance);
    print(what, ratio, 1e9 / (double(count) * repeats), "ns a ray");
    return ratio;
}

class Cost : public testing::TestWithParam<Subject> {};

// The torus must stay within 2.5 times the closed form's time, the others within a generous 4: a bound against
// accidents.
TEST_P(Cost, StaysWithinItsBoundOfTheTextbooks) {
    offscreen();
    for (const double distance : {3.0, 10.0}) EXPECT_LE(intersectCost(GetParam(), distance).ratio, GetParam().bound);
}

// Right near by, or it would be no baseline: hit or miss, and t within 1e-3, for 99 of 100 rays.
TEST_P(Cost, ComparesWithATextbookThatAgreesFromThreeUnits) {
    offscreen();
    Problems problems;
    RayBatch ours(sceneOf(GetParam()), problems), textbook(sceneOf(GetParam()), problems, textbookShaders());
    ASSERT_TRUE(ours.valid() && textbook.valid()) << toString(problems);
    const std::vector<BatchRay> rays = raysInto(GetParam(), 3, 100000);
    const std::vector<BatchHit> a = ours.trace(rays), b = textbook.trace(rays);
    int alike = 0, hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool hit = a[i].object >= 0;
        const bool same = glm::distance(a[i].point, b[i].point) < 1e-3f && glm::dot(a[i].normal, b[i].normal) > 0.99f;
        hits += hit;
        alike += hit == (b[i].object >= 0) && (!hit || (std::abs(a[i].t - b[i].t) < 1e-3f && same));
    }
    std::printf("%-10s %d of 100000 rays hit, %d answered alike\n", GetParam().name, hits, alike);
    EXPECT_GE(hits, 20000);
    EXPECT_GE(alike, 99000);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Cost, testing::ValuesIn(kSubjects),
                         [](const auto& test) { return std::string(test.param.name); });

// Four times the repeats take about four times as long, so that no work is shared between them; more rays than one draw
// takes are timed all; and what the batch answers afterwards is what it answered before.
TEST(RayBatch, TimesEveryRepeatOfEveryRay) {
    offscreen();
    Problems problems;
    RayBatch batch(sceneOf(kTorus), problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    const std::vector<BatchRay> few = raysInto(kTorus, 3, 512 * 64), many = raysInto(kTorus, 3, 512 * 600);
    const std::vector<BatchHit> before = batch.trace(few);
    const auto seconds = [&](const std::vector<BatchRay>& rays, int repeats) {
        return [&, repeats] { return batch.seconds(rays, repeats, processSeconds); };
    };
    EXPECT_NEAR(ratioOf([&] { return Pair{seconds(few, 32), seconds(few, 8)}; }).ratio, 4, 1);
    EXPECT_NEAR(ratioOf([&] { return Pair{seconds(many, 2), seconds(few, 2)}; }).ratio, 600.0 / 64, 3);
    const std::vector<BatchHit> after = batch.trace(few);
    for (std::size_t i = 0; i < few.size(); ++i) {
        ASSERT_EQ(before[i].object, after[i].object);
        ASSERT_EQ(before[i].t, after[i].t);
        ASSERT_EQ(before[i].point, after[i].point);
    }
}

// What the cost buys: the closed form's float32 quartic answers one ray of ten and more wrongly from 100 units away.
TEST(CostOfTheTorus, IsNotPaidForNothing) {
    offscreen();
    Problems problems;
    RayBatch ours(sceneOf(kTorus), problems), textbook(sceneOf(kTorus), problems, textbookShaders());
    ASSERT_TRUE(ours.valid() && textbook.valid()) << toString(problems);
    for (const double distance : {3.0, 10.0, 30.0, 100.0}) {
        const std::vector<BatchRay> rays = raysInto(kTorus, distance, 100000);
        const std::vector<BatchHit> a = ours.trace(rays), b = textbook.trace(rays);
        int wrong = 0;
        for (std::size_t i = 0; i < rays.size(); ++i)
            wrong += (a[i].object < 0) != (b[i].object < 0) || (a[i].object >= 0 && std::abs(a[i].t - b[i].t) > 0.05f);
        std::printf("torus from %g units: the textbook's answer differs for %d of 100000 rays\n", distance, wrong);
        if (distance >= 100) {
            EXPECT_GT(wrong, 10000);
        }
    }
}

// The whole frame of the scene `torus`, shadows and reflections and all.
TEST(CostOfTheTorus, IsLittleOfAFrame) {
    offscreen();
    const auto torus =
        std::ranges::find(textbookShaders(), std::string_view("primitive/torus.glsl"), &ShaderFile::name);
    ASSERT_NE(torus, textbookShaders().end());
    Settings settings;
    settings.size = {320, 240};
    const Scene scene = sceneNamed("torus");
    const auto frame = [&](std::span<const ShaderFile> overrides) -> std::function<double()> {
        const auto drawing = std::make_shared<Drawing>(scene, settings, overrides);
        return [=] {
            const double start = processSeconds();
            drawing->picture();
            return processSeconds() - start;
        };
    };
    const Ratio ratio = ratioOf([&] { return Pair{frame({}), frame({&*torus, 1})}; });
    print("frame of `torus`", ratio, 1e3, "ms");
    EXPECT_LE(ratio.ratio, 1.3);
}

} // namespace
} // namespace gnomon
